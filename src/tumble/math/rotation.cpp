/// \file
/// \brief Orientations: rotation vectors, turning, and the angle between two.
#include "tumble/math/rotation.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble {
namespace {

// Whether a squared length can be divided by; false for NaN.
bool usable(double square) {
  return square >= tolerance::smallest_square && square <= 1.0 / tolerance::smallest_square;
}

// The components of a quaternion of the cube's 24 rotations have squares 0, 1/4, 1/2 or 1.
double snapped(double component) {
  return std::copysign(0.5 * std::sqrt(std::floor(4.0 * component * component + 0.5)), component);
}

Quat snapped(const Quat& q) {
  return Quat(snapped(q.w()), snapped(q.x()), snapped(q.y()), snapped(q.z()));
}

bool right_angled(double degrees) { return std::fmod(degrees, 90.0) == 0.0; }

// A turn about one coordinate axis. Two full turns bring a quaternion back, and fmod is exact.
Quat about_axis(int axis, double degrees) {
  constexpr double half_radians = 0x1.1df46a2529d39p-7;  // π/360
  const elementary::SinCos half = elementary::sincos(std::fmod(degrees, 720.0) * half_radians);
  Quat q(half.cos, 0.0, 0.0, 0.0);
  q.vec()[axis] = half.sin;
  return right_angled(degrees) ? snapped(q) : q;
}

}  // namespace

Mat3 skew(const Vec3& a) {
  Mat3 m;
  // clang-format off
  m <<    0.0, -a.z(),  a.y(),
        a.z(),    0.0, -a.x(),
       -a.y(),  a.x(),    0.0;
  // clang-format on
  return m;
}

Quat normalised(const Quat& q) {
  const double square = q.squaredNorm();
  if (!usable(square)) {  // the message is built only when it is needed
    refuse("q: |q|² = " + shortest_text(square) +
           ": expected a quaternion of a length from 1e-150 to 1e150");
  }
  const double length = std::sqrt(square);
  return Quat(q.w() / length, q.x() / length, q.y() / length, q.z() / length);
}

Quat rotation_from_vector(const Vec3& rotation_w) {
  // A vector so short that its square is 0 has sinc 1, so that no digit is lost.
  const double square = rotation_w.squaredNorm();
  if (!(square <= 1.0 / tolerance::smallest_square)) {
    require::finite(rotation_w, "rotation_w");
    refuse("rotation_w: expected a length up to 1e150");
  }
  const double half_angle = 0.5 * std::sqrt(square);
  const Vec3 v = (0.5 * elementary::sinc(half_angle)) * rotation_w;
  return Quat(elementary::cos(half_angle), v.x(), v.y(), v.z());
}

Vec3 rotation_vector(const Quat& q) {
  // Of q and -q, the same orientation, take the one with w > 0; half a turn has w = 0, and then
  // the first component that is not 0 decides.
  const Quat unit = normalised(q);
  double decider = unit.w();
  for (int k = 0; k < 3 && decider == 0.0; ++k) decider = unit.vec()[k];
  const double sign = decider < 0.0 ? -1.0 : 1.0;
  const double w = sign * unit.w();
  const Vec3 v = sign * unit.vec();

  // r = v θ/|v| with tan(θ/2) = |v|/w. For small angles θ/|v| is 2/w, also where |v|² is 0.
  const double length = v.norm();
  if (length < tolerance::small_rotation * w) return (2.0 / w) * v;
  return (2.0 * elementary::atan2(length, std::abs(w)) / length) * v;
}

Quat turned(const Quat& q_wb, const Vec3& omega_w, double dt) {
  return normalised(rotation_from_vector(dt * omega_w) * q_wb);
}

Vec3 along_arc(const Vec3& rotation_w, const Vec3& straight_w) {
  require::finite(rotation_w, "rotation_w");
  const double angle = rotation_w.norm();
  require::that(angle <= 1e150, "rotation_w: expected a length up to 1e150");
  const double half = elementary::sinc(0.5 * angle);
  const double across = 0.5 * half * half;  // (1 - cos θ) / θ²
  // (θ - sin θ) / θ³ cancels for small angles, and is multiplied by θ² then.
  const double inwards = angle < tolerance::small_angle
                             ? 1.0 / 6.0
                             : (1.0 - elementary::sinc(angle)) / (angle * angle);
  const Vec3 turned_w = rotation_w.cross(straight_w);
  return straight_w + across * turned_w + inwards * rotation_w.cross(turned_w);
}

Vec3 rotation_vector_rate(const Vec3& rotation_w, const Vec3& omega_w) {
  require::finite(rotation_w, "rotation_w");
  const double angle = rotation_w.norm();
  require::that(angle < 2.0 * std::numbers::pi, "rotation_w: expected less than a full turn");
  double inwards = 1.0 / 12.0;
  if (angle >= tolerance::small_angle) {
    const elementary::SinCos half = elementary::sincos(0.5 * angle);
    inwards = (1.0 - 0.5 * angle * half.cos / half.sin) / (angle * angle);
  }
  const Vec3 turned_w = rotation_w.cross(omega_w);
  return omega_w - 0.5 * turned_w + inwards * rotation_w.cross(turned_w);
}

double angle_between(const Quat& p, const Quat& q) {
  // On the unit sphere of quaternions p - q and p + q are at right angles and half the angle from
  // p to q has the tangent |p - q|/|p + q|. A rotation turns by twice that angle.
  const double apart = (p.coeffs() - q.coeffs()).norm();
  const double together = (p.coeffs() + q.coeffs()).norm();
  return 4.0 * elementary::atan2(std::min(apart, together), std::max(apart, together));
}

Quat rotation_between(const Quat& from, const Quat& to, double share) {
  const Vec3 turn = rotation_vector(to * from.conjugate());
  return turn == Vec3::Zero() ? from : normalised(rotation_from_vector(share * turn) * from);
}

Quat rotation_from_degrees(const Vec3& xyz_deg) {
  require::finite(xyz_deg, "xyz_deg");
  const Quat about_x = about_axis(0, xyz_deg.x());
  const Quat about_y = about_axis(1, xyz_deg.y());
  const Quat about_z = about_axis(2, xyz_deg.z());
  const Quat q = about_z * about_y * about_x;

  // Products of √½ are off by rounding; the group of right angles knows where they belong.
  for (int k = 0; k < 3; ++k)
    if (!right_angled(xyz_deg[k])) return normalised(q);
  return snapped(q);
}

}  // namespace tumble
