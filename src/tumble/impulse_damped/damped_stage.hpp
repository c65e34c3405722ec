/// \file
/// \brief The stages of damped integration that push bodies, and the tools they share (thesis 5.2, A.2).
#pragma once

#include "tumble/contact/collision_noise.hpp"
#include "tumble/contact/graph.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/impulse_damped/collide.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include <vector>

namespace tumble {

/// The pairs that a step has pushed, each as it was last, with the impulses of the whole step at its first point.
class PushedPairs {
 public:
  /// Forgets them.
  void clear();
  /// Takes a pair that was pushed.
  /// \param collision  with the impulses of this push
  void add(const Contact& collision);
  /// How many there are.
  /// \return 0 or above
  [[nodiscard]] std::size_t count() const { return order_.size(); }
  /// One of them.
  /// \param place  in the order of ids, from 0
  /// \return the pair
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

/// A step in the making: the bodies and the tools of its stages. Nothing here is owned.
struct DampedStage {
  const World& world;            ///< poses of the step's start
  double dt = 0.0;               ///< [s] of the step
  RotationRule rotation{};       ///< how bodies turn
  const SleepingRule* sleeping;  ///< which bodies to leave out; nullptr: none
  DampedBodies& bodies;          ///< velocities, predicted poses, marks
  PairGatherer& gatherer;        ///< finds what overlaps
  Collide& collide;              ///< lets pairs collide
  ContactList& collisions;       ///< of the present pass
  PushedPairs& pushed_pairs;     ///< pairs of this step with all their impulses
  StepReport& report;            ///< counts and energy

  /// integrateObjectPositions and gatherCollisions: looks where bodies come to, and which overlap
  /// there.
  void predict_and_gather();
  /// Lets a pair collide and keeps book of it.
  /// \param collision    of the present pass
  /// \param restitution  [-] -1 to 1
  /// \param gravity      with which velocities
  void run(Contact& collision, double restitution, TemporaryGravity gravity);
};

/// The listing RESOLVECOLLISIONS: bodies that will overlap at the end of the step bounce, pass by
/// pass.
///
/// Restitution is used in every pass, also on what earlier passes left of an approach (so a stack
/// that is not quite at rest bounces a little). A body at rest does not bounce: gravity is in its
/// predicted place but not in its velocity, and so it does not approach.
/// \param stage   velocities in and out
/// \param passes  NUM_COLLISION_ITERATIONS, at least 0
/// \param noise   the share of chance (thesis 4.2)
/// \param random  the stream of this step
/// \algorithm{RESOLVECOLLISIONS: appendix A.2}
/// \verified{A box at rest does not bounce though restitution is 0.9}
void resolve_collisions(DampedStage& stage, int passes, const NoiseOptions& noise,
                        const Random& random);

/// The listing RESOLVECONTACTS: bodies that gravity would press into each other are stopped.
///
/// In pass i of N the restitution is \f$-1 + i/N\f$: each pass takes a larger part of the approach,
/// the last one all of it. The division is one of real numbers; of whole numbers it would be 0 in
/// every pass but the last, and these would do nothing.
/// \param stage   velocities in and out
/// \param passes  NUM_CONTACT_ITERATIONS, N, at least 0
/// \algorithm{RESOLVECONTACTS: appendix A.2}
/// \deviation{i/N is divided as real numbers.}
/// \verified{A box at rest stays where it is}
void resolve_contacts(DampedStage& stage, int passes);

/// Guendelman, Bridson and Fedkiw's shock propagation, which the thesis replaced by a push (4.4).
///
/// Once more contacts are stopped, from the ground up: level by level of the contact graph, and
/// all that lies below counts as immovable. Bodies of one level that touch are stopped as usual.
class ShockPropagation {
 public:
  /// Goes up once.
  /// \param stage   velocities in and out
  /// \param passes  over the contacts of each level, at least 1
  void run(DampedStage& stage, int passes);

 private:
  std::vector<SupportEdge> edges_;
  ContactGraph graph_;
};

}  // namespace tumble
