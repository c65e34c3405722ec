/// \file
/// \brief A column without glue that falls, and the moments at which its joints open (footnote of thesis
///        6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A moment of a fall.
struct JointMoment {
  World world;                // the bodies
  std::vector<Joint> joints;  // and their holds
};

// A change of a joint.
struct JointEvent {
  double time = 0.0;                    // [s] since the start
  int joint = 0;                        // its place; of a column 0 is the pivot, 1 the lowest area
  JointHold hold = JointHold::nothing;  // the hold from now on
  double angle = 0.0;                   // [rad] centre_angle() of all that moves, then
  JointMoment after;                    // just after it
};

// A fall with joints that push only.
struct UnilateralRun {
  World world;                     // at the end
  std::vector<Joint> joints;       // at the end
  std::vector<JointEvent> events;  // in the order of time
  int solves = 0;                  // systems of joint forces that were solved
};

// Options of a fall without glue.
// accuracy: [-] of dormand_prince
GluedOptions unilateral(GluedScheme scheme, GluedEvents events, double accuracy = 1e-12);

// Lets a world fall.
// end: [s] length of the fall
UnilateralRun run_unilateral(World world, const GluedOptions& options, double end, int steps,
                             const std::function<void(const World&, const Glued&)>& after = {});

// Distance of two worlds with the same bodies.
// Returns [m] largest distance of a corner of a movable box in the one from itself in the other
double farthest_corner(const World& world, const World& other);

// Where an area is pressed.
// Returns [m] centre of pressure across the column, from the edge on the pivot's side: 0 to 1 while no part
// has to pull
double pressed_at(const Joint& joint, const Wrench& push, std::span<const BodyState> states);

}  // namespace tumble::chapters
