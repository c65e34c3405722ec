/// \file
/// \brief Inverse masses at a point, and impulses on a pair.
#include "tumble/contact/effective_mass.hpp"

#include <limits>

namespace tumble {
namespace {

// The matrix whose product with x is r × x.
Mat3 cross_matrix(const Vec3& r) {
  Mat3 m;
  m << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return m;
}

void push(MovingBody& body, const Vec3& point_w, const Vec3& impulse_w) {
  body.velocity_w += body.inverse_mass.cwiseProduct(impulse_w);
  body.angular_velocity_w += body.inverse_inertia_w * (point_w - body.position_w).cross(impulse_w);
  body.changed = true;
}

}  // namespace

Mat3 inverse_mass_at(const MovingBody& body, const Vec3& point_w) {
  // [r]' = -[r], so that -[r] I^-1 [r] is written in the form in which it is seen to be
  // positive semidefinite.
  const Mat3 r = cross_matrix(point_w - body.position_w);
  Mat3 k = r * body.inverse_inertia_w * r.transpose();
  k.diagonal() += body.inverse_mass;
  return k;
}

Mat3 inverse_mass_at(const MovingBody& first, const MovingBody& second, const Vec3& point_w) {
  return inverse_mass_at(first, point_w) + inverse_mass_at(second, point_w);
}

double effective_mass(const MovingBody& first, const MovingBody& second, const Vec3& point_w,
                      const Vec3& direction_w) {
  const double inverse = direction_w.dot(inverse_mass_at(first, second, point_w) * direction_w);
  return inverse > 0.0 ? 1.0 / inverse : std::numeric_limits<double>::infinity();
}

void apply_impulse(MovingBody& first, MovingBody& second, const Vec3& point_w,
                   const Vec3& impulse_w) {
  push(first, point_w, -impulse_w);
  push(second, point_w, impulse_w);
}

Tangents tangents_of(const Vec3& normal_w) {
  // The world axis that lies farthest from the normal makes the safest cross product; of equal
  // ones the first.
  int axis = 0;
  normal_w.cwiseAbs().minCoeff(&axis);
  Tangents t{.first_w = normal_w.cross(Vec3::Unit(axis)).normalized()};
  t.second_w = normal_w.cross(t.first_w);
  return t;
}

}  // namespace tumble
