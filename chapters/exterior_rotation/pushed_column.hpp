/// \file
/// \brief The column of figure 6.1 pushed along without turning (claim 6.2a).
#pragma once

#include "driver/experiment.hpp"
#include "exterior_rotation/held_run.hpp"

namespace tumble::chapters {

// The column upright and alone, without gravity: as on a ground without friction, which carries its
// weight and does nothing else.
inline World lone_column(int boxes) {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < boxes; ++k) world.add(cube, Vec3(0.0, 0.5 + k, 0.0));
  return world;
}

// The effect of a push.
struct PushedRun {
  double gap = 0.0;    // [m] largest opening or overlap of any joint after any step
  double way = 0.0;    // [m] of the first cube
  double force = 0.0;  // [N] largest in the glue
  std::vector<double>
      gaps;  // [m] largest magnitude of all joints, at the start and after each step
};

inline constexpr double kPushedMargin = 1e-9;  // [-] of find_joints(): the cubes touch exactly

inline double largest_gap(std::span<const Joint> joints, std::span<const BodyState> states) {
  const JointGap gap = gap_of(joints, states);
  return std::max(gap.opening, gap.overlap);
}

// Pushes the column sideways, half of the push at the middle of each of its two middle cubes (all of it
// at that of the middle one of an odd number), and steps as the thesis does.
//
// The glue's forces are right at the beginning of each step and held over it, \f$x^+ = x + h v\f$ and
// \f$v^+ = v + h a\f$. The push goes through the centre of the column, so nothing turns, and the
// acceleration is what JointForces::project() makes of the accelerations without glue.
// push: [N] of all cubes together
inline PushedRun push_column(int boxes, double push, double dt, int steps) {
  World world = lone_column(boxes);
  const std::vector<Joint> joints = find_joints(world, kPushedMargin);
  const std::size_t middle[2] = {static_cast<std::size_t>((boxes - 1) / 2),
                                 static_cast<std::size_t>(boxes / 2)};
  JointForces forces;
  std::vector<MovingBody> rates;
  PushedRun run;
  run.gaps.push_back(largest_gap(joints, world.states()));
  for (int n = 0; n < steps; ++n) {
    // Accelerations without glue, then with it. The rates of change of momenta are read from them, as
    // project() reads velocities.
    load_moving_bodies(world, rates);
    for (MovingBody& rate : rates) {
      rate.velocity_w = Vec3::Zero();
      rate.angular_velocity_w = Vec3::Zero();
    }
    for (const std::size_t k : middle)
      rates[k].velocity_w.x() += 0.5 * push / world.bodies()[k].mass;
    forces.project(rates, joints, world.states());
    for (std::size_t j = 0; j < joints.size(); ++j)
      run.force = std::max(run.force, forces.on_second(static_cast<int>(j)).force_w.norm());
    for (std::size_t k = 0; k < rates.size(); ++k) {
      const BodyProperties& body = world.bodies()[k];
      BodyState& state = world.states()[k];
      state.position_w += dt * velocity(body, state);
      state.orientation_wb =
          (rotation_from_vector(dt * angular_velocity(body, state)) * state.orientation_wb)
              .normalized();
      state.linear_momentum_w += dt * body.mass * rates[k].velocity_w;
      state.angular_momentum_w +=
          dt * body.inertia_b.cwiseProduct(rates[k].angular_velocity_w);  // of a cube: in any frame
    }
    run.gaps.push_back(largest_gap(joints, world.states()));
    run.gap = std::max(run.gap, run.gaps.back());
  }
  run.way = world.states()[0].position_w.x();
  return run;
}

}  // namespace tumble::chapters
