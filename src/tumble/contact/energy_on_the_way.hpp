/// \file
/// \brief The way from one state of motion to another, and how far energy allows to go (thesis 4.3, 6.3.1).
#pragma once

#include "tumble/contact/collision_law.hpp"

#include <algorithm>

namespace tumble {

/// The energy above the allowed one at a share t of the way from one state of motion to another: start + b t + a t².
struct EnergyOnTheWay {
  double start = 0.0;      ///< [J]
  double slope = 0.0;      ///< [J] b
  double curvature = 0.0;  ///< [J] a
  double error = 0.0;      ///< [J] what counts as none

  /// The largest share of the way on which there is not too much [-]: from 0 to 1.
  [[nodiscard]] double allowed() const {
    if (start + slope + curvature <= error || curvature == 0.0) return 1.0;  // 0: nothing changes
    return largest_share(std::min(start, 0.0), slope, curvature);
  }
};

/// Velocities at a share of the way from one state of motion to another.
/// \param share  [-] 0 to 1
/// \param to     the other one; velocities in and out
inline void interpolate(const MovingBody& from, double share, MovingBody& to) {
  to.velocity_w = from.velocity_w + share * (to.velocity_w - from.velocity_w);
  to.angular_velocity_w =
      from.angular_velocity_w + share * (to.angular_velocity_w - from.angular_velocity_w);
}

}  // namespace tumble
