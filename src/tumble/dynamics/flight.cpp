/// \file
/// \brief Bodies in flight: where they are at any time of a step, and how far apart (thesis 3.2).
#include "tumble/dynamics/flight.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"

#include <algorithm>

namespace tumble {
namespace {

double valid_time(const Flight& flight, int body) {
  return flight.valid_times.empty() ? 0.0 : flight.valid_times[idx(body)];
}

double micro_step_of(const Flight& flight, int body) {
  return flight.micro_steps.empty() ? flight.micro_step : flight.micro_steps[idx(body)];
}

// The height of the lowest corner: the ground is the first body, so the normal is +y.
Separation gap_above_ground(const BodyProperties& body, const BodyState& state) {
  return Separation{.distance = state.position_w.y() - reach(box_of(body, state), Vec3::UnitY()),
                    .normal_w = Vec3::UnitY()};
}

// How fast any point of the body can move against its centre until the end.
double corner_speed(const Flight& flight, int body, double end) {
  const BodyProperties& properties = flight.bodies[idx(body)];
  if (!properties.movable()) return 0.0;
  const double duration = std::min(end - valid_time(flight, body), micro_step_of(flight, body));
  const double turning =
      angular_speed_bound(properties, flight.states[idx(body)], duration, flight.rule);
  return turning * 0.5 * properties.size.norm();
}

}  // namespace

void require_valid(const Flight& flight, double start) {
  const std::size_t count = flight.bodies.size();
  require::finite(start, "start");
  require::finite(flight.gravity_w, "flight.gravity_w");
  require::that(flight.states.size() == count, "flight.states: expected one for each body");
  require::that(flight.valid_times.empty() || flight.valid_times.size() == count,
                "flight.valid_times: expected one for each body, or none");
  require::that(flight.accelerations_w.empty() || flight.accelerations_w.size() == count,
                "flight.accelerations_w: expected one for each body, or none");
  require::that(flight.micro_steps.empty() || flight.micro_steps.size() == count,
                "flight.micro_steps: expected one for each body, or none");
  for (const BodyState& state : flight.states) {
    require::finite(state.position_w, "flight.states.position_w");
    require::unit(state.orientation_wb, "flight.states.orientation_wb");
    require::finite(state.linear_momentum_w, "flight.states.linear_momentum_w");
    require::finite(state.angular_momentum_w, "flight.states.angular_momentum_w");
  }
  for (const double time : flight.valid_times) {
    if (time <= start) continue;
    refuse("flight.valid_times has " + shortest_text(time) +
           ": expected at most start = " + shortest_text(start));
  }
  for (const Vec3& acceleration : flight.accelerations_w)
    require::finite(acceleration, "flight.accelerations_w");
}

bool turns_evenly(const BodyProperties& body, const BodyState& state, RotationRule rule) {
  const Vec3& moments = body.inertia_b;
  const bool round = moments.x() == moments.y() && moments.y() == moments.z();
  return !body.movable() || state.angular_momentum_w.isZero(0.0) ||
         (round && rule != RotationRule::rk4);
}

BodyState state_at(const Flight& flight, int body, double time) {
  BodyState state = flight.states[idx(body)];
  fly_in_micro_steps(flight.bodies[idx(body)], state, acceleration_of(flight, body),
                     time - valid_time(flight, body), flight.rule, micro_step_of(flight, body));
  return state;
}

Separation gap_between(const BodyProperties& first, const BodyState& first_state,
                       const BodyProperties& second, const BodyState& second_state) {
  if (first.shape == Shape::ground) return gap_above_ground(second, second_state);
  if (second.shape == Shape::ground) {
    Separation out = gap_above_ground(first, first_state);
    out.normal_w = -out.normal_w;
    return out;
  }
  SeparationOptions all_axes{.prefer_faces = false,
                             .enough = std::numeric_limits<double>::infinity()};
  return separation(box_of(first, first_state), box_of(second, second_state), all_axes);
}

Vec3 acceleration_of(const Flight& flight, int body) {
  if (!flight.bodies[idx(body)].movable()) return Vec3::Zero();
  return flight.accelerations_w.empty() ? flight.gravity_w : flight.accelerations_w[idx(body)];
}

// Without turning the body: v + a (t - t_valid).
Vec3 velocity_at(const Flight& flight, int body, double time) {
  return velocity(flight.bodies[idx(body)], flight.states[idx(body)]) +
         (time - valid_time(flight, body)) * acceleration_of(flight, body);
}

Separation gap_at(const Flight& flight, const IndexPair& pair, double time) {
  return gap_between(flight.bodies[idx(pair.first)], state_at(flight, pair.first, time),
                     flight.bodies[idx(pair.second)], state_at(flight, pair.second, time));
}

ClosingBound closing_bound(const Flight& flight, const IndexPair& pair, const Vec3& normal_w,
                           double time, double end) {
  ClosingBound bound;
  bound.speed =
      normal_w.dot(velocity_at(flight, pair.first, time) - velocity_at(flight, pair.second, time)) +
      corner_speed(flight, pair.first, end) + corner_speed(flight, pair.second, end);
  bound.acceleration =
      normal_w.dot(acceleration_of(flight, pair.first) - acceleration_of(flight, pair.second));
  return bound;
}

// The parabola stays within g t²/8 of its chord.
Bounds bounds_of_flight(const BodyProperties& body, const BodyState& start, const Vec3& gravity_w,
                        double time, double reach) {
  if (!body.movable()) return bounds_of(body, start);
  const double sag = gravity_w.norm() * time * time / 8.0;
  const Vec3 end_w =
      start.position_w + time * velocity(body, start) + 0.5 * time * time * gravity_w;
  const Vec3 wide = Vec3::Constant(reach + sag);
  return Bounds{start.position_w.cwiseMin(end_w) - wide, start.position_w.cwiseMax(end_w) + wide};
}

}  // namespace tumble
