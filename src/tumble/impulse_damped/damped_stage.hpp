/// \file
/// \brief The stages of damped integration that apply impulses, and the data they share (thesis 5.2, A.2).
#pragma once

#include "tumble/contact/collision_noise.hpp"
#include "tumble/contact/graph.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/impulse_damped/collide.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include <vector>

namespace tumble {

/// The pairs with an impulse in a step: each with the geometry of its last pass, and the sum of its impulses at the first
/// point.
class PushedPairs {
 public:
  /// Removes all pairs.
  void clear();
  /// Adds the impulses of a pass.
  void add(const Contact& collision);
  /// \return the number of pairs
  [[nodiscard]] std::size_t count() const { return order_.size(); }
  /// A pair.
  /// \param place  in the order of ids, from 0
  [[nodiscard]] const Contact& operator[](std::size_t place) const {
    return contacts_[order_[place].contact];
  }

 private:
  struct Place {
    int first, second;
    std::size_t contact;  // place in the list
  };
  std::vector<Place> order_;  // by bodies
  ContactList contacts_;      // in the order in which they were pushed first
};

/// Data of the stages of one step. Nothing here is owned.
struct DampedStage {
  const World& world;            ///< poses at the start of the step
  double dt = 0.0;               ///< [s] of the step
  RotationRule rotation{};       ///< how orientations are integrated
  const SleepingRule* sleeping;  ///< bodies to leave out; nullptr: none
  DampedBodies& bodies;          ///< velocities, predicted poses, stable bodies
  PairGatherer& gatherer;        ///< finds overlapping pairs
  Collide& collide;              ///< applies the impulse of a pair
  ContactList& collisions;       ///< pairs of the present pass
  PushedPairs& pushed_pairs;     ///< pairs of this step with all their impulses
  StepReport& report;            ///< counts and energy

  /// integrateObjectPositions and gatherCollisions: predicts the poses at the end of the step and finds the pairs that
  /// overlap there.
  void predict_and_gather();
  /// Lets a pair collide, and books its impulse.
  /// \param collision    of the present pass
  /// \param restitution  [-] -1 to 1
  /// \param gravity      whether velocities include gravity of the step
  void run(Contact& collision, double restitution, TemporaryGravity gravity);
};

/// The listing RESOLVECOLLISIONS: bodies that will overlap at the end of the step bounce, pass by
/// pass.
///
/// Restitution acts in every pass, also on approach that earlier passes have left, so that a stack
/// which is not quite at rest bounces a little. A body at rest does not bounce: gravity is in its
/// predicted position but not in its velocity, so it does not approach.
/// \param stage   velocities in and out
/// \param passes  NUM_COLLISION_ITERATIONS, at least 0
/// \param noise   randomness in collisions (thesis 4.2)
/// \algorithm{RESOLVECOLLISIONS: appendix A.2}
/// \verified{A box at rest does not bounce though restitution is 0.9}
void resolve_collisions(DampedStage& stage, int passes, const NoiseOptions& noise,
                        const Random& random);

/// The listing RESOLVECONTACTS: bodies that gravity would press into each other are stopped.
///
/// In pass i of N the restitution is \f$-1 + i/N\f$: each pass removes a larger part of the approach,
/// the last one all of it. The division is of real numbers; with integers every pass but the last would do nothing.
/// \param stage   velocities in and out
/// \param passes  NUM_CONTACT_ITERATIONS, N, at least 0
/// \algorithm{RESOLVECONTACTS: appendix A.2}
/// \deviation{i/N is divided as real numbers.}
/// \verified{A box at rest stays where it is}
void resolve_contacts(DampedStage& stage, int passes);

/// Guendelman, Bridson and Fedkiw's shock propagation, which the thesis replaced by a push (4.4).
///
/// It stops contacts once more, level by level of the contact graph from the ground up. Bodies of lower levels count as
/// immovable.
class ShockPropagation {
 public:
  /// Goes through all levels once.
  /// \param stage   velocities in and out
  /// \param passes  over the contacts of each level, at least 1
  void run(DampedStage& stage, int passes);

 private:
  std::vector<SupportEdge> edges_;
  ContactGraph graph_;
};

}  // namespace tumble
