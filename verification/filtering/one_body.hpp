/// \file
/// \brief Runs of one body, for the tests of filters.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/filtering/pose_filter.hpp"
#include "tumble/math/rotation.hpp"

#include <functional>
#include <vector>

// Helpers for the tests of filters that treat each body on its own.
namespace one_body {

// Interval of two frames [s].
inline constexpr double kFrameTime = 1.0 / 60.0;

// A run of one body.
// interval: [s] between frames
inline tumble::Trajectory run_of(int count, const std::function<tumble::BodyState(int)>& state,
                                 double interval = kFrameTime) {
  tumble::Trajectory run;
  const std::vector<tumble::BodyId> ids = {tumble::BodyId{7}};
  std::vector<tumble::BodyState> states(1);
  for (int n = 0; n < count; ++n) {
    states[0] = state(n);
    run.record(tumble::Frame{n * interval, n, ids, states});
  }
  return run;
}

// A body at rest on the x axis.
// x: [m] its position
inline tumble::BodyState at(double x) {
  tumble::BodyState state;
  state.position_w.x() = x;
  return state;
}

// A body at the origin, rotated about the z axis.
// angle: [rad] its rotation
inline tumble::BodyState turned_by(double angle) {
  tumble::BodyState state;
  state.orientation_wb = tumble::rotation_from_vector(tumble::Vec3(0.0, 0.0, angle));
  return state;
}

// The body in a frame of run_of().
inline const tumble::BodyState& body_in(const tumble::Trajectory& run, int frame) {
  return run.frame(frame).states[0];
}

// Whether two poses have the same bits.
inline bool same_pose(const tumble::BodyState& a, const tumble::BodyState& b) {
  return a.position_w == b.position_w && a.orientation_wb.coeffs() == b.orientation_wb.coeffs();
}

// Counts the frames in which the body's displayed position changes.
inline int changes_in(const tumble::Trajectory& run) {
  int changes = 0;
  for (int n = 1; n < run.count(); ++n)
    if (!same_pose(body_in(run, n - 1), body_in(run, n))) ++changes;
  return changes;
}

// A random walk of a body, with rotations; steps have all lengths up to a bound.
// way: [m] longest move of the centre in a frame
// turn: [rad] largest turn in a frame
inline tumble::Trajectory random_walk(int count, double way, double turn, std::uint64_t seed) {
  tumble::Random chance(seed);
  tumble::BodyState now{.orientation_wb = chance.orientation()};
  return run_of(count, [&, way, turn](int) {
    const tumble::Vec3 along = chance.direction();
    const tumble::Vec3 axis = chance.direction();
    const double share = chance.unit();
    const double turn_share = chance.unit();
    now.position_w += share * way * along;
    now.orientation_wb = tumble::turned(now.orientation_wb, turn_share * turn * axis, 1.0);
    return now;
  });
}

}  // namespace one_body
