/// \file
/// \brief Random points, directions and orientations.
#include "tumble/base/random.hpp"

#include <cmath>

namespace tumble {

Vec3 Random::in_cube(double half) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = uniform(-half, half);
  return p;
}

Vec3 Random::direction() {
  // Points of the unit ball are found by throwing away those of the cube outside it; dividing by
  // the length then favours no direction. Points too near the centre lose digits.
  while (true) {
    const Vec3 p = in_cube(1.0);
    const double square = p.squaredNorm();
    if (square <= 1.0 && square > 0x1p-20) return p / std::sqrt(square);
  }
}

Quat Random::orientation() {
  // The same in four dimensions: unit quaternions spread evenly over the 3-sphere.
  while (true) {
    double c[4];
    for (double& component : c) component = uniform(-1.0, 1.0);
    const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3];
    if (square > 1.0 || square <= 0x1p-20) continue;
    const double scale = 1.0 / std::sqrt(square);
    return Quat(c[0] * scale, c[1] * scale, c[2] * scale, c[3] * scale);
  }
}

}  // namespace tumble
