/// \file
/// \brief Shared by the tests of contact_damped.
#pragma once

#include "tumble/geometry/broad_phase.hpp"

#include "impulse_damped/scene_runs.hpp"

#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace tumble::test {

/// [rad] One degree.
inline constexpr double kDegree = std::numbers::pi / 180.0;

/// A number as a setting.
/// \param value  the number
/// \return six decimals
inline std::string text(double value) { return std::to_string(value); }

/// The technique, with all bodies awake unless set otherwise.
/// \param set  options to change
/// \return a new one
inline std::unique_ptr<Technique> contact_damped(const Settings& set = {}) {
  return awake("contact_damped", set);
}

/// All pairs of bodies, as candidates for contact.
/// \param world  the bodies
/// \return sorted
inline std::vector<IndexPair> all_pairs(const World& world) {
  std::vector<IndexPair> pairs;
  for (int k = 0; k < world.count(); ++k)
    for (int j = k + 1; j < world.count(); ++j) pairs.push_back({k, j});
  return pairs;
}

}  // namespace tumble::test
