/// \file
/// \brief A group of bodies that stick, step by step: states, gaps of its joints, and the schemes of the film
///        strips (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/glued_runs.hpp"

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
  [[nodiscard]] const HeldFrame& at(double time) const {
    return *std::ranges::min_element(frames, [&](const HeldFrame& a, const HeldFrame& b) {
      return std::abs(a.time - time) < std::abs(b.time - time);
    });
  }
  // The bodies of a frame as a world.
  [[nodiscard]] World world(const HeldFrame& frame) const {
    World world = start;
    std::copy(frame.states.begin(), frame.states.end(), world.states().begin());
    return world;
  }
};

inline HeldFrame frame_of(const World& world, std::span<const Joint> joints, double time) {
  HeldFrame frame{.time = time};
  frame.states.assign(world.states().begin(), world.states().end());
  for (const Joint& joint : joints) frame.gaps.push_back(gap_of(joint, world.states()));
  return frame;
}

// The acceleration of a point of a body's material.
inline Vec3 acceleration_of(const BodyProperties& body, const BodyState& state, const Wrench& rate,
                            const Vec3& point_w) {
  if (!body.movable()) return Vec3::Zero();
  const Vec3 omega_w = angular_velocity(body, state);
  const Vec3 torque_w = rate.torque_w - omega_w.cross(state.angular_momentum_w);
  const Vec3 alpha_w = inverse_inertia_w(body, state.orientation_wb) * torque_w;
  const Vec3 lever_w = point_w - state.position_w;
  return body.inverse_mass * rate.force_w + alpha_w.cross(lever_w) +
         omega_w.cross(omega_w.cross(lever_w));
}

// The forces that hold joints at an instant.
struct HeldInstant {
  std::vector<MovingBody> moving;  // the bodies, by index
  std::vector<Wrench> rates;       // of change of their momenta, gravity included
  JointForces forces;              // has solved for them

  // Solves for the forces.
  HeldInstant(const World& world, std::span<const Joint> joints) {
    load_moving_bodies(world, moving);
    forces.hold(world, moving, joints, rates);
  }
};

// Relative acceleration of the two sides of each held point, with the forces that were found for this
// instant.
// Returns [m/s²] the largest of all joints
inline double relative_acceleration(const World& world, std::span<const Joint> joints) {
  const std::vector<Wrench> rates = HeldInstant(world, joints).rates;
  double largest = 0.0;
  for (const Joint& joint : joints) {
    const JointPoint held = held_point(joint, world.states());
    const auto of = [&](int body, const Vec3& point_w) {
      const std::size_t k = idx(body);
      return acceleration_of(world.bodies()[k], world.states()[k], rates[k], point_w);
    };
    const Vec3 apart_w = of(joint.second, held.second_w) - of(joint.first, held.first_w);
    largest = std::max(largest, apart_w.norm());
  }
  return largest;
}

// [m] The opening, or below 0 the overlap, whichever is larger.
inline double signed_gap(const JointGap& gap) {
  return gap.opening >= gap.overlap ? gap.opening : -gap.overlap;
}

// Steps a group.
inline HeldRun run_held(const World& start, const GluedOptions& options, double dt, int steps) {
  HeldRun run{.start = start};
  World world = start;
  Glued glued(options);
  glued.find(world);
  run.joints.assign(glued.joints().begin(), glued.joints().end());
  run.frames.push_back(frame_of(world, run.joints, 0.0));
  for (int k = 1; k <= steps; ++k) {
    run.acceleration = std::max(run.acceleration, relative_acceleration(world, run.joints));
    finished(glued.step(world, dt));
    if (!all_finite(world)) throw std::runtime_error("a step of glued left no finite state");
    run.frames.push_back(frame_of(world, run.joints, k * dt));
  }
  return run;
}

// The gap of one kind of joint, the one with the largest magnitude.
// Returns [m] the opening, or below 0 the overlap, whichever is larger
inline double widest(const HeldRun& run, const HeldFrame& frame, JointHold hold) {
  double widest = 0.0;
  for (std::size_t j = 0; j < run.joints.size(); ++j) {
    if (run.joints[j].hold != hold) continue;
    const double gap = signed_gap(frame.gaps[j]);
    if (std::abs(gap) > std::abs(widest)) widest = gap;
  }
  return widest;
}

// Largest distance of a corner from its place, over all joints [m], JointGap::apart.
inline double farthest_apart(const HeldFrame& frame) {
  return largest_of(frame.gaps, &JointGap::apart);
}

// A scheme with its names in figures.
struct FilmScheme {
  std::string column;  // of tables
  std::string words;   // for readers
  GluedScheme scheme;  // how the motion is integrated
};

// The three schemes of order 1, the midpoint rule, the classical method, and the reference.
inline std::span<const FilmScheme> film_schemes() {
  static const std::array<FilmScheme, 6> kSchemes = {{
      {"forward_euler", "forward Euler", GluedScheme::forward_euler},
      {"semi_implicit", "semi-implicit", GluedScheme::semi_implicit},
      {"impulse", "impulses", GluedScheme::impulse},
      {"midpoint", "midpoint", GluedScheme::midpoint},
      {"rk4", "rk4", GluedScheme::rk4},
      {"reference", "reference", GluedScheme::dormand_prince},
  }};
  return kSchemes;
}

// Number of film_schemes() that the eye distinguishes: all but the classical method and the reference.
inline constexpr std::size_t kSeenSchemes = 4;

// The options of `glued` for a scheme, centres and orientations apart.
inline GluedOptions options_of(const FilmScheme& scheme, PoseUpdate pose = PoseUpdate::separate) {
  return glued_options(scheme.scheme, pose, 1e-12);
}

// By how far one step from an exact state of the column pulls its highest joint apart, along the line
// from the centre of rotation of the one to that of the other.
// Returns [m] above 0 a gap, below 0 overlap
inline double gap_of_step(const World& world, const GluedOptions& options, double dt) {
  World moved = world;
  Glued glued(options);
  glued.find(moved);
  finished(glued.step(moved, dt));
  const Joint& joint = glued.joints().back();
  const auto centre = [&](int body) { return moved.states()[idx(body)].position_w; };
  // The larger box's centre does not turn: its pivot stands for it.
  const bool edge = joint.hold == JointHold::edge;
  const JointPoint held = held_point(joint, moved.states());
  const Vec3 from_w = edge ? held.first_w : centre(joint.first);
  return (centre(joint.second) - from_w).normalized().dot(held.second_w - held.first_w);
}

}  // namespace tumble::chapters
