/// \file
/// \brief Poses that several tests need, and both ways to change them that techniques have to pass.
#pragma once

#include "tumble/dynamics/pose_update.hpp"

#include "support/test.hpp"

namespace tumble::test {

// The pose update of the techniques that a test makes by posed(), or by name.
inline PoseUpdate pose_under_test = PoseUpdate::separate;

// Sets the pose update for the rest of a scope.
class PoseScope {
 public:
  explicit PoseScope(PoseUpdate update) { pose_under_test = update; }
  ~PoseScope() { pose_under_test = PoseUpdate::separate; }
  PoseScope(const PoseScope&) = delete;
  PoseScope& operator=(const PoseScope&) = delete;
};

// Options with the pose update of the test.
template <class Options>
Options posed(Options options = {}) {
  options.pose = pose_under_test;
  return options;
}

// A cube on its corner: turns the diagonal (1, 1, 1) upright, about the axis that lies level.
inline Quat on_corner() {
  const double half = 0.5 * std::acos(std::sqrt(1.0 / 3.0));
  const double part = std::sin(half) * std::sqrt(0.5);
  return Quat(std::cos(half), -part, 0.0, part);
}

}  // namespace tumble::test

// Runs the rest of a test case with each pose update.
#define BOTH_POSES                                                              \
  const tumble::test::PoseScope pose_scope(                                     \
      GENERATE(tumble::PoseUpdate::separate, tumble::PoseUpdate::exponential)); \
  INFO("pose=" << tumble::name_of(tumble::test::pose_under_test))
