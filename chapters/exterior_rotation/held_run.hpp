/// \file
/// \brief A group of bodies that stick, step by step: states, and how far each joint has come apart
///        (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include <vector>

namespace tumble::chapters {

/// The bodies after a step.
struct HeldFrame {
  double time = 0.0;              ///< [s] since the start
  std::vector<BodyState> states;  ///< by index
  std::vector<JointGap> gaps;     ///< [m] by joint
};

/// A run of the technique `glued`.
struct HeldRun {
  World start;                ///< the bodies at the start; constant parts are those of all frames
  std::vector<Joint> joints;  ///< what is held
  std::vector<HeldFrame> frames;  ///< the start and each step after it
  double acceleration = 0.0;      ///< [m/s²] largest of relative_acceleration() at starts of steps

  /// The frame at a time.
  /// \param time [s] from 0
  /// \return the nearest one
  [[nodiscard]] const HeldFrame& at(double time) const;
  /// The bodies of a frame as a world.
  /// \param frame one of this run
  /// \return the world of the start with the states of the frame
  [[nodiscard]] World world(const HeldFrame& frame) const;
};

/// Steps a group.
/// \param start    the bodies; what touches is held
/// \param options  how
/// \param dt       [s] of a step, above 0
/// \param steps    how many
/// \return with one frame more than steps
/// \throws std::runtime_error if a state is not finite
HeldRun run_held(const World& start, const GluedOptions& options, double dt, int steps);

/// A gap as one number.
/// \param gap as measured
/// \return [m] the opening, or less than 0 the overlap, whichever is larger
double signed_gap(const JointGap& gap);

/// The gap of one kind of joint, the one with the largest magnitude.
/// \param run    a run
/// \param frame  of it
/// \param hold   which joints: those of a group's glue are areas, those that it turns about edges
/// \return [m] as signed_gap()
double widest(const HeldRun& run, const HeldFrame& frame, JointHold hold);

/// How far corners are from where they should be, the largest of all joints.
/// \param frame of a run
/// \return [m] JointGap::apart
double farthest_apart(const HeldFrame& frame);

/// How fast the two sides of each held point accelerate away from one another, with the forces that were
/// found for this instant.
/// \param world   the bodies
/// \param joints  what is held
/// \return [m/s²] the largest of all joints
double relative_acceleration(const World& world, std::span<const Joint> joints);

}  // namespace tumble::chapters
