/// \file
/// \brief Pairs of bodies that overlap at the poses they are about to have (thesis 2.5.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/impulse_damped/impulse_bodies.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Two bodies that have been near each other in this step.
struct ImpulsePair {
  IndexPair bodies;  ///< by index, the smaller one first
  /// The points at the predicted poses that overlap or touch, as last seen; kept when the pair
  /// comes apart. Impulses are those of the stage so far, approach speeds are not used.
  Contact contact;
  bool near = false;  ///< whether the two are as near as the margin of ImpulsePairs::begin()
  Vec3 near_normal_w = Vec3::UnitY();  ///< [-] from the first body to the second, if near
  bool overlaps = false;               ///< whether they overlap or touch
  double depth = 0.0;                  ///< [m] of the deepest point
  double size = 0.0;                   ///< [m] the shortest edge of the two
  int first_version = -1;   ///< ImpulseBodies::version() of the first body when it was looked at
  int second_version = -1;  ///< ditto, of the second

  bool met = false;                       ///< whether the two have collided in this step
  double approach = 0.0;                  ///< [m/s] of the event: see ImpulsePush::collide()
  Vec3 first_velocity_w = Vec3::Zero();   ///< [m/s] of the first body when that was so
  Vec3 first_spin_w = Vec3::Zero();       ///< [rad/s] ditto
  Vec3 second_velocity_w = Vec3::Zero();  ///< [m/s] of the second body
  Vec3 second_spin_w = Vec3::Zero();      ///< [rad/s] ditto
};

/// All pairs of a step, by a number that they keep until its end.
/// \par Cost and determinism
/// A broad phase for each look at all pairs, and a test of two boxes for each pair one of whose
/// bodies has another predicted pose than at the last look. No allocation once warm. Numbers are
/// given in the order in which pairs are found, by index; nothing is kept from step to step that
/// could change a result.
class ImpulsePairs {
 public:
  /// Forgets all pairs.
  /// \param margin [m] up to which bodies count as near in this step, at least 0
  void begin(double margin);

  /// Finds all pairs that overlap or touch at the predicted poses.
  /// \param sleeping  pairs to leave out (SleepingRule::needs_test()); nullptr: none
  /// \return their numbers, ascending by the indices of the bodies; valid until the next call
  std::span<int> find(const World& world, const ImpulseBodies& bodies,
                      const SleepingRule* sleeping);

  /// Looks at one pair again, if a body of it has got another predicted pose.
  ImpulsePair& look(const World& world, const ImpulseBodies& bodies, int number);

  /// A pair as last seen.
  [[nodiscard]] ImpulsePair& operator[](int number) {
    return pairs_[static_cast<std::size_t>(number)];
  }

  /// The contacts of all pairs that are near.
  /// \param out is overwritten; sorted by id
  void list_near(ContactList& out) const;

  /// All pairs of this step, for reports: numbers, ascending by the indices of the bodies.
  [[nodiscard]] std::span<const int> all() const { return sorted_; }

  /// Tests of two bodies since begin().
  [[nodiscard]] std::int64_t tests() const { return tests_; }

 private:
  void add_new(const World& world, const SleepingRule* sleeping);

  double margin_ = 0.0;  // [m]
  BoundingTree broad_phase_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> near_;
  std::vector<ImpulsePair> pairs_;  // by number
  std::vector<int> sorted_;         // all numbers, ascending by the indices of the bodies
  std::vector<int> found_;
  std::int64_t tests_ = 0;
};

}  // namespace tumble
