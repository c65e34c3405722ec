/// \file
/// \brief A group of bodies that stick, step by step: states, gaps of its joints, and the schemes of the film
///        strips (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The bodies after a step.
struct HeldFrame {
  double time = 0.0;              // [s] since the start
  std::vector<BodyState> states;  // by index
  std::vector<JointGap> gaps;     // [m] by joint
};

// A run of the technique `glued`.
struct HeldRun {
  World start;                    // the bodies at the start; constant parts are those of all frames
  std::vector<Joint> joints;      // that are held
  std::vector<HeldFrame> frames;  // the start and each step after it
  double acceleration = 0.0;      // [m/s²] largest of relative_acceleration() at starts of steps

  // The frame at a time.
  // time: [s] from 0
  [[nodiscard]] const HeldFrame& at(double time) const;
  // The bodies of a frame as a world.
  [[nodiscard]] World world(const HeldFrame& frame) const;
};

// Steps a group.
// dt: [s] of a step, above 0
HeldRun run_held(const World& start, const GluedOptions& options, double dt, int steps);

// The gap of one kind of joint, the one with the largest magnitude.
// Returns [m] the opening, or below 0 the overlap, whichever is larger
double widest(const HeldRun& run, const HeldFrame& frame, JointHold hold);

// Largest distance of a corner from its place, over all joints.
// Returns [m] JointGap::apart
double farthest_apart(const HeldFrame& frame);

// The forces that hold joints at an instant.
struct HeldInstant {
  std::vector<MovingBody> moving;  // the bodies, by index
  std::vector<Wrench> rates;       // of change of their momenta, gravity included
  JointForces forces;              // has solved for them

  // Solves for the forces.
  HeldInstant(const World& world, std::span<const Joint> joints);
};

// Relative acceleration of the two sides of each held point, with the forces that were found for this
// instant.
// Returns [m/s²] the largest of all joints
double relative_acceleration(const World& world, std::span<const Joint> joints);

// A scheme with its names in figures.
struct FilmScheme {
  std::string column;  // of tables
  std::string words;   // for readers
  GluedScheme scheme;  // how the motion is integrated
};

// The three schemes of order 1, the midpoint rule, the classical method, and the reference.
std::span<const FilmScheme> film_schemes();

// Number of film_schemes() that the eye distinguishes: all but the classical method and the reference.
inline constexpr std::size_t kSeenSchemes = 4;

// The options of `glued` for a scheme, centres and orientations apart.
GluedOptions options_of(const FilmScheme& scheme, PoseUpdate pose = PoseUpdate::separate);

// By how far one step from an exact state of the column pulls its highest joint apart, along the line
// from the centre of rotation of the one to that of the other.
// dt: [s] above 0
// Returns [m] above 0 a gap, below 0 overlap
double gap_of_step(const World& world, const GluedOptions& options, double dt);

}  // namespace tumble::chapters
