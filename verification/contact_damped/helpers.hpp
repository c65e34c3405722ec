/// \file
/// \brief Shared by the tests of contact_damped.
#pragma once

#include "impulse_damped/scene_runs.hpp"
#include "support/runs.hpp"
#include "support/touching.hpp"

#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace tumble::test {

// [rad] One degree.
inline constexpr double kDegree = std::numbers::pi / 180.0;

// A number as a setting.
inline std::string text(double value) { return std::to_string(value); }

// The technique, with all bodies awake unless set otherwise.
inline std::unique_ptr<Technique> contact_damped(const Settings& set = {}) {
  return awake("contact_damped", set);
}

}  // namespace tumble::test
