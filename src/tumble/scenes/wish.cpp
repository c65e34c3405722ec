/// \file
/// \brief Violation of wishes.
#include "tumble/scenes/wish.hpp"

#include "tumble/contact/moving_body.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/scenes/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble {
namespace {

constexpr double kFaceLevel = 0.99;  // [-] cosine of a face that is up: 8 degrees
constexpr double kRest = 0.05;       // [-] speed of what rests, as a share of sqrt(g L)

double below_limit(double value, double limit) { return value < limit ? 1.0 - value / limit : 0.0; }

// Unit vector out of a face, body frame.
Vec3 face_normal(int face) { return Vec3::Unit(face / 2) * (face % 2 == 0 ? 1.0 : -1.0); }

double face_violation(const Wish& wish, const BodyView& body, double gravity) {
  const double level = (body.orientation_wb() * face_normal(wish.face)).y();
  const BodyProperties& box = body.properties();
  const double scale = std::sqrt(gravity * box.size.minCoeff());
  const double speed = fastest_point_speed(box, body.velocity_w(), body.angular_velocity_w());
  double sum = level < kFaceLevel ? 0.5 * (1.0 - level) : 0.0;
  if (speed > kRest * scale) sum += scale > 0.0 ? std::min(1.0, speed / scale) : 1.0;
  return sum;
}

double region_violation(const Wish& wish, const BodyView& body) {
  const Vec3& at_w = body.position_w();
  const double out = (at_w - at_w.cwiseMax(wish.low_w).cwiseMin(wish.high_w)).norm();
  return out / (out + body.properties().size.maxCoeff());
}

// Cosine of the angle by which the axis that was up has turned.
double upright_cosine(const SceneBox& start, const BodyView& body) {
  const Vec3 axis_b = start.orientation_wb.conjugate() * Vec3::UnitY();
  return (body.orientation_wb() * axis_b).y();
}

double tilt_violation(const Wish& wish, const SceneBox& start, const BodyView& body) {
  const double limit = elementary::cos(wish.angle_deg * std::numbers::pi / 180.0);
  const double cosine = upright_cosine(start, body);
  if (wish.kind == WishKind::stands) return cosine > limit ? 0.0 : (limit - cosine) / (1.0 + limit);
  return cosine <= limit ? 0.0 : (cosine - limit) / (1.0 - limit);
}

double way_violation(const Wish& wish, const SceneBox& start, const BodyView& body) {
  const double way = (body.position_w() - start.position_w).norm();
  const double limit = distance_of(wish, start);
  if (wish.kind == WishKind::moves) return below_limit(way, limit);
  return way > limit ? 1.0 - limit / way : 0.0;
}

}  // namespace

double distance_of(const Wish& wish, const SceneBox& box) {
  if (wish.distance > 0.0) return wish.distance;
  constexpr double share = 0.25;
  return wish.kind == WishKind::stays ? share * box.size.minCoeff() : box.size.maxCoeff();
}

double violation(const Wish& wish, const Scene& scene, const World& world) {
  double sum = 0.0;
  for (const std::string& name : wish.bodies) {
    const auto start = std::find_if(scene.boxes.begin(), scene.boxes.end(),
                                    [&](const SceneBox& box) { return box.name == name; });
    if (start == scene.boxes.end() || !world.find(name)) {
      sum += 1.0;
      continue;
    }
    const BodyView body = world.body(name);
    switch (wish.kind) {
      case WishKind::face_up: sum += face_violation(wish, body, world.gravity_w.norm()); break;
      case WishKind::ends_in: sum += region_violation(wish, body); break;
      case WishKind::topples:
      case WishKind::stands: sum += tilt_violation(wish, *start, body); break;
      case WishKind::moves:
      case WishKind::stays: sum += way_violation(wish, *start, body); break;
    }
  }
  return sum;
}

double violation(const Scene& scene, const World& world) {
  double sum = 0.0;
  for (const Wish& wish : scene.wishes) sum += violation(wish, scene, world);
  return sum;
}

}  // namespace tumble
