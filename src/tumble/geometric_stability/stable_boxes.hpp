/// \file
/// \brief Who may be left out of the system of contact forces (thesis 5.4, 6.3.1).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/islands.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"
#include "tumble/geometric_stability/towers.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// In which directions a body is taken for immovable. As a char, so that it also tells whether.
enum class Hold : char {
  free = 0,     ///< in none
  upright = 1,  ///< does not rise, sink or tip; may slide and spin about the vertical
  still = 2     ///< does not move at all (tolerance::standstill)
};

/// What one search for stable boxes took.
struct StableBoxesReport {
  bool remembered = false;           ///< nothing has changed since the last search: its answer
  int stable = 0;                    ///< movable bodies that are stable
  int pivots = 0;                    ///< of the static equilibrium
  std::int64_t multiplications = 0;  ///< its work, whatever the machine
};

/// Who stays where it is, whatever the contact forces turn out to be, and may be taken for immovable.
///
/// With `corners` or `hull`: GeometricStability with exact supports, of bodies that neither rise nor
/// sink nor tip. With `equilibrium`, cheapest first:
/// 1. bodies that are stable by the hull; from now on they count as immovable;
/// 2. towers on them, seen as loads (Towers);
/// 3. of what is left, whole islands that are in balance under their weight and the towers on
///    them (StaticEquilibrium).
///
/// Steps 2 and 3 say that a body does not accelerate as things are, not whatever comes: who touches
/// somebody who is in no such group is in none either.
///
/// **Who is not.** Who rises, sinks or tips to speak of (tolerance::resting_speed), and who has a gap that is
/// still to close (tolerance::contact_gap). Of towers and islands also who spins; and where a normal is not
/// vertical, whoever moves at all, since then holding would brake.
///
/// **Memory.** Contacts, masses, who is quiet, and where bodies in contact are, are remembered. As
/// long as all of it is the same to the bit, as it is for a heap at rest, the last answer is given; so forgetting it changes nothing.
/// \par Cost and determinism
/// A comparison of the contacts if nothing has changed; else that of the parts. The answer
/// does not depend on the order of bodies or contacts.
/// \algorithm{Leaving stable boxes out: section 5.4}
/// \verified{Leaving stable boxes out changes no acceleration}
class StableBoxes {
 public:
  /// Islands with more contact points are not looked at by StaticEquilibrium: that takes longer than their forces.
  static constexpr int kMostPoints = 500;

  /// \param rule         by which boxes are told
  /// \param most_points  `equilibrium`: islands with more contact points are never held
  explicit StableBoxes(StableRule rule, int most_points = kMostPoints)
      : rule_(rule), most_points_(most_points) {}

  /// Finds who is stable.
  /// \param world     masses, poses, gravity
  /// \param bodies    how they move, one for each body index
  /// \param contacts  points where forces can act, and no others
  /// \return by index, a Hold: `free` for who may accelerate; valid until the next call
  /// \throws std::invalid_argument for a contact of a body that there is not, or bodies that are not
  ///         one for each
  std::span<const char> find(const World& world, std::span<const MovingBody> bodies,
                             std::span<const Contact> contacts);

  /// What the last find() took.
  /// \return the work of it
  [[nodiscard]] const StableBoxesReport& report() const { return report_; }

 private:
  // What a verdict rests on.
  struct Basis {
    Vec3 gravity_w = Vec3::Zero();
    std::vector<BodyId> ids;
    std::vector<double> inverse_masses;
    std::vector<char> motion;
    std::vector<BodyState> states;  // where the bodies are
    ContactList contacts;
  };

  void find_motion(const World& world, std::span<const MovingBody> bodies,
                   std::span<const Contact> contacts);
  [[nodiscard]] bool unchanged(const World& world, std::span<const Contact> contacts) const;
  void search(const World& world, std::span<const Contact> contacts);
  void add_balanced(const World& world, std::span<const Contact> contacts);
  void drop_large_islands(const World& world);
  void take_islands(const World& world);
  void take_towers(const World& world);

  StableRule rule_;
  int most_points_;
  GeometricStability geometric_;
  Towers towers_;
  StaticEquilibrium equilibrium_;
  StableBoxesReport report_;
  bool known_ = false;  // whether basis_ and held_ are of a search
  Basis basis_;
  std::vector<char> motion_;  // by index: how a body moves
  std::vector<char> held_;    // by index: a Hold
  std::vector<char> stable_;  // by index: by the rule of the thesis
  std::vector<char> apart_;   // by index: no part of a tower
  ContactList left_;          // contacts of what is no load
  std::vector<Load> loads_;   // of towers on what is no tower
  std::vector<char> drop_;    // by contact in left_: of an island that is not looked at
  Islands islands_;
};

}  // namespace tumble
