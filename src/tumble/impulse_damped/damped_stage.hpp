/// \file
/// \brief What the stages of damped integration work with (thesis 5.2).
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/impulse_damped/collide.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

namespace tumble {

/// A step in the making: the bodies and the tools of its stages. Nothing here is owned.
struct DampedStage {
  const World& world;            ///< poses of the step's start
  double dt = 0.0;               ///< [s] of the step
  RotationRule rotation{};       ///< how bodies turn
  const SleepingRule* sleeping;  ///< whom to leave out; nullptr: nobody
  DampedBodies& bodies;          ///< velocities, predicted poses, marks
  PairGatherer& gatherer;        ///< finds what overlaps
  Collide& collide;              ///< lets pairs collide
  ContactList& collisions;       ///< of the present pass
  ContactList& told;             ///< pairs of this step with all their impulses, sorted by id
  StepReport& report;            ///< counts and energy

  /// integrateObjectPositions and gatherCollisions: looks where bodies come to, and who overlaps
  /// there.
  void predict_and_gather();
  /// Lets a pair collide and keeps book of it.
  /// \param collision    of the present pass
  /// \param restitution  [-] -1 to 1
  /// \param gravity      with which velocities
  void run(Contact& collision, double restitution, TemporaryGravity gravity);
};

}  // namespace tumble
