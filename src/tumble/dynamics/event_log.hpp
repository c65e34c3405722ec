/// \file
/// \brief Collisions as they happened.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// One collision that was resolved.
struct Event {
  double time = 0.0;              ///< [s] since the start of the run
  BodyId first{};                 ///< the body with the smaller id
  BodyId second{};                ///< the other one
  Vec3 point_w = Vec3::Zero();    ///< [m] where the impulse acts, world frame
  Vec3 normal_w = Vec3::UnitY();  ///< [-] from the first body to the second, world frame
  Vec3 impulse_w = Vec3::Zero();  ///< [N s] on the second body, world frame; the first got minus it
  int rewinds = 0;                ///< bodies put back in time to get here
  int restarts = 0;               ///< searches begun again for a third body
};

/// All collisions of a run, in the order in which they were resolved.
using EventLog = std::vector<Event>;

}  // namespace tumble
