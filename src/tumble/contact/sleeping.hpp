/// \file
/// \brief Bodies that rest are left alone until something happens to them (thesis 4.5).
#pragma once

#include "tumble/contact/islands.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/world.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tumble {

/// When a body counts as slow, and for how long it has to be.
struct SleepingOptions {
  /// [-] speed of its fastest point, at most this share of sqrt(g L); L is its shortest edge
  double speed = tolerance::sleeping_speed;
  /// [-] the same where there is no gravity, as a share of L / dt
  double speed_weightless = tolerance::sleeping_speed_weightless;
  double time = tolerance::sleeping_time;  ///< [s] for which it has to be slow
};

/// What SleepingRule::update() did.
struct SleepReport {
  int fell_asleep = 0;  ///< bodies, in this call
  int woke = 0;         ///< bodies, since the call before
  double energy = 0.0;  ///< [J] 0 or below: kinetic energy of those that fell asleep; for booking
};

/// Puts whole islands of resting bodies to sleep, and wakes them when something happens.
///
/// The thesis (4.5) asks that a group at rest stay at rest until there is a new interaction; what
/// that means in detail is ours. An island falls asleep when all its bodies have been slow for a
/// while and, if there is gravity, it touches something immovable: a body whose speed is 0 for an
/// instant at the top of its way is neither. A caller may list bodies that count as slow although they
/// shake. The momenta of sleepers are 0. They are not to be advanced, and pairs without an awake body
/// need no test.
///
/// The islands that fall asleep become *groups*; a group and the immovable bodies that it touches
/// stay as they are or wake together. A group wakes when
/// - a body that is awake touches it (wake_touched());
/// - a body of it, or an immovable one that it rests on, was pushed, given a velocity or momentum,
///   moved or removed between two steps (wake_disturbed());
/// - an immovable body was added or moved and now touches it;
/// - gravity changed.
///
/// Nothing else wakes a group: waking goes along contacts, not by distance. A body that was put to
/// sleep by another rule (one whose memory is lost) is woken, since its contacts are not known.
/// \par Use
/// \code
/// rule.wake_disturbed(world);                      // first in the step
/// do gather(); while (rule.wake_touched(world, contacts) > 0);  // asks rule.needs_test(i, j)
/// // ... impulses and motion of those whose sleep_states()[i].asleep is false ...
/// report.energy.damping += rule.update(world, contacts, islands, dt).energy;  // last
/// \endcode
/// Its memory decides what happens next and belongs to a snapshot: copy it with the technique.
/// \par Cost and determinism
/// O(bodies + contacts) with a small factor for a sleeper: a comparison of its pose. No allocation
/// once the storage is warm. Results do not depend on the order of the contacts.
/// \algorithm{Bodies at rest are left alone: section 4.5}
/// \verified{An island sleeps as a whole or not at all}
class SleepingRule {
 public:
  /// Starts with an empty memory.
  /// \throws std::invalid_argument for a number that is not finite or below 0
  explicit SleepingRule(const SleepingOptions& options = {});

  /// Wakes whatever was disturbed since the last update(). First thing in a step; adding and
  /// removing bodies is for before it.
  /// \param world the bodies; changes sleep_states() only
  /// \return how many bodies it woke, besides those that World itself has woken
  int wake_disturbed(World& world);

  /// Whether two bodies can have a contact that is of interest.
  ///
  /// Not of interest: two sleepers, two immovable bodies, and a sleeper with an immovable body that
  /// has been where it is since the last step.
  /// \return false if the pair needs no test; true before wake_disturbed() was called
  [[nodiscard]] bool needs_test(int first, int second) const;

  /// Whether all movable bodies sleep, and nothing immovable is new or was moved.
  /// \return after wake_disturbed(): whether nothing is left to do in a step
  [[nodiscard]] bool nobody_awake() const;

  /// Wakes the groups that are touched by an awake body, or by an immovable one that is new there.
  ///
  /// Contacts within the woken groups were not looked for: gather again if this returns more than 0.
  /// \param world     the bodies; changes sleep_states() only
  /// \param contacts  all that were found
  /// \return how many bodies it woke
  /// \throws std::invalid_argument if wake_disturbed() has not seen these bodies
  int wake_touched(World& world, std::span<const Contact> contacts);

  /// The same for pairs of bodies that touch.
  /// \param pairs  by index; all that were found
  /// \throws std::invalid_argument if wake_disturbed() has not seen these bodies
  int wake_touched_pairs(World& world, std::span<const IndexPair> pairs);

  /// Counts how long bodies have been slow, and puts islands to sleep. Last thing in a step.
  /// \param world     the bodies; changes sleep_states(), and the momenta of those that fall asleep
  /// \param contacts  those that the step worked with
  /// \param slow      by index, not 0: counts as slow whatever its speed, unless it woke in this step;
  ///                  empty: none
  /// \throws std::invalid_argument for a dt that is not finite and above 0, or if wake_disturbed()
  ///         has not seen these bodies
  SleepReport update(World& world, std::span<const Contact> contacts, const Islands& islands,
                     double dt, std::span<const char> slow = {});

  /// The same for pairs of bodies that touch.
  /// \param pairs    by index; those that the step worked with
  /// \throws std::invalid_argument for a dt that is not finite and above 0, or if wake_disturbed()
  ///         has not seen these bodies
  SleepReport update_with_pairs(World& world, std::span<const IndexPair> pairs,
                                const Islands& islands, double dt, std::span<const char> slow = {});

 private:
  /// What a body is to the pair filter.
  enum class Role : std::uint8_t {
    awake,
    asleep,
    fixed,   // immovable, and where it was
    changed  // immovable, and new here
  };
  /// A body as it was at the end of the last update().
  struct Seen {
    BodyId id{};
    bool asleep = false;
    BodyId group{};  // of a sleeper: the smallest id of those it fell asleep with
    Vec3 position_w = Vec3::Zero();
    Quat orientation_wb = Quat::Identity();
  };
  void compare(const World& world, int body, const Seen* before);
  void disturb(const Seen& before);
  int wake_groups(World& world, bool all);
  [[nodiscard]] bool is_slow(const World& world, int body, double dt, bool counts) const;
  [[nodiscard]] bool can_sleep(const World& world, std::span<const IndexPair> contacts,
                               const Islands& islands, int island) const;
  void put_to_sleep(World& world, std::span<const IndexPair> contacts, const Islands& islands,
                    int island, SleepReport& report);
  void remember(const World& world);

  SleepingOptions options_;
  std::vector<IndexPair> pairs_;  // of contacts, while they are looked at

  // Memory from step to step.
  std::vector<Seen> seen_;  // all bodies, ascending by id
  /// An immovable body and a group that touches it; ascending.
  std::vector<std::pair<BodyId, BodyId>> supports_;
  Vec3 gravity_w_ = Vec3::Zero();  // [m/s²]
  int woke_ = 0;                   // since the last report

  // Of this step, by index; filled by wake_disturbed().
  std::vector<Role> role_;
  std::vector<BodyId> group_;      // of the sleepers
  std::vector<BodyId> disturbed_;  // groups about to be woken
  std::vector<char> woken_;        // not 0: woken by this rule
};

}  // namespace tumble
