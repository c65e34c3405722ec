/// \file
/// \brief Runs of groups that stick, and the groups of the figures on the cure (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Options of the technique `glued`.
// accuracy: [-] of dormand_prince, error allowed in a step
GluedOptions glued_options(GluedScheme scheme, PoseUpdate pose = PoseUpdate::separate,
                           double accuracy = GluedOptions{}.accuracy);

// Numbers that are evenly spread in the logarithm.
std::vector<double> log_spaced(double first, double last, int count);

// The result of a run of the technique `glued`.
struct GluedRun {
  World world;         // at the end
  double gap = 0.0;    // [m] largest opening or overlap of any joint after any step
  double apart = 0.0;  // [m] largest distance of a held corner from itself after any step
  int solves = 0;      // systems of joint forces solved
};

// Runs a group that sticks.
// dt: [s] of a step
GluedRun run_glued(World world, const GluedOptions& options, double dt, int steps,
                   const std::function<void(const World&, const JointGap&)>& after = {});

// Four cubes that stick, as a column that stands on one corner: a ball joint on top of a larger box,
// near the corner of it beyond which the column falls.
// angle: [rad] of the column's centre, as seen from the pivot, from the vertical
// spin: [rad/s] of the column about its long axis
World column_on_corner(double angle, double spin);

// The same four cubes in the air, thrown.
// velocity_w: [m/s] of the column's centre
// spin_w: [rad/s] of the column, about its centre
World column_in_flight(const Vec3& velocity_w, const Vec3& spin_w);

// The sums over all movable bodies.
struct GroupMotion {
  double mass = 0.0;                    // [kg]
  Vec3 centre_w = Vec3::Zero();         // [m] of mass
  Vec3 momentum_w = Vec3::Zero();       // [N s]
  Vec3 angular_about_w = Vec3::Zero();  // [N m s] about the centre
};

// Adds the bodies of a group up.
GroupMotion motion_of(const World& world);

}  // namespace tumble::chapters
