/// \file
/// \brief Three motions with closed forms, and how far a technique is off them.
#include "choosing/problems.hpp"

#include <gsl/gsl_sf_elljac.h>

namespace tumble::chapters {
namespace {

const BodyState& state_of(const World& world, std::string_view name) {
  return world.states()[static_cast<std::size_t>(world.index_of(*world.find(name)))];
}

// [m] How high the lower face is: one flight after the other.
double bounced_height(double height, double restitution, double time) {
  const double fall = std::sqrt(2.0 * height / kGravity);
  if (time < fall) return height - 0.5 * kGravity * time * time;
  double left = time - fall;
  double speed = kGravity * fall * restitution;
  while (left > 2.0 * speed / kGravity && speed > 0.0) {
    left -= 2.0 * speed / kGravity;
    speed *= restitution;
  }
  return speed * left - 0.5 * kGravity * left * left;
}

}  // namespace

Problem bounce_problem() {
  constexpr double height = 1.0, restitution = 0.5;
  Problem problem{"bounce", make_scene("bouncing_box", {"height=1", "restitution=0.5"}), 36,
                  height};
  problem.value = [](const World& world) { return state_of(world, "cube").position_w.y() - 0.5; };
  problem.exact = [](double time) { return bounced_height(height, restitution, time); };
  return problem;
}

Problem slide_problem() {
  constexpr double speed = 3.0, braking = 0.3 * kGravity;
  Problem problem{"slide", make_scene("slide", {"speed=3", "friction=0.3"}), 45,
                  speed * speed / (2.0 * braking)};
  problem.value = [](const World& world) { return state_of(world, "box").position_w.x(); };
  problem.exact = [](double time) {
    const double moving = std::min(time, speed / braking);
    return speed * moving - 0.5 * braking * moving * moving;
  };
  return problem;
}

Problem rock_problem() {
  constexpr double width = 0.4, height = 2.0, tilt = 0.5;
  const double diagonal = std::atan2(width, height);  // [rad] tilt at which it balances
  Problem problem{"rock",
                  make_scene("rocking_block", {"width=0.4", "height=2", "tilt=0.5", "friction=2"}),
                  14, tilt * diagonal};
  problem.value = [](const World& world) {
    return rotation_vector(state_of(world, "block").orientation_wb).z();
  };
  problem.exact = [diagonal](double time) {
    const double radius = 0.5 * std::hypot(width, height);
    const double frequency = std::sqrt(kGravity / (4.0 / 3.0 * radius));
    const double k = std::cos(0.5 * (1.0 - tilt) * diagonal);
    double sn = 0.0, cn = 0.0, dn = 0.0;
    if (gsl_sf_elljac_e(frequency * time, k * k, &sn, &cn, &dn) != 0)
      throw std::runtime_error("no elliptic functions at this time");
    const double from_vertical = 2.0 * std::acos(k * cn / dn);  // of the line from edge to centre
    return diagonal - from_vertical;
  };
  return problem;
}

std::array<Problem, 3> closed_problems() {
  return {bounce_problem(), slide_problem(), rock_problem()};
}

Attempt attempt(const Problem& problem, const PlayedTechnique& played, int per_frame) {
  Attempt out;
  double worst = 0.0;
  int steps = 0;
  const auto look = [&](const World& world, const Metrics&) {
    if (++steps % per_frame != 0) return;
    const double time = kComparedEvery * (steps / per_frame);
    worst = std::max(worst, std::abs(problem.value(world) - problem.exact(time)));
  };
  const RunResult run = run_compared(problem.scene, played, kComparedEvery / per_frame,
                                     kComparedEvery * problem.frames, look);
  out.totals = run.totals;
  if (run.end == RunEnd::complete) out.error = worst / problem.scale;
  return out;
}

}  // namespace tumble::chapters
