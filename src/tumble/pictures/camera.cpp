/// \file
/// \brief Perspective, and the distance of a camera.
#include "tumble/pictures/camera.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <limits>

namespace tumble {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Along one direction across the picture, x, with depth z towards the viewer: the eye (ex, ez) sees
// all points within a slope s of the line of sight if
//   x - ex <= s (ez - z)  and  ex - x <= s (ez - z)  for each of them,
// that is, if  high <= ex + s ez  and  ex - s ez <= low  with the bounds gathered here.
struct Fit {
  double low = kInfinity;    // [m] least x - s z
  double high = -kInfinity;  // [m] largest x + s z

  void add(double x, double z, double slope) {
    low = std::min(low, x - slope * z);
    high = std::max(high, x + slope * z);
  }
  // The closest eye: both conditions hold with equality.
  [[nodiscard]] double depth(double slope) const { return (high - low) / (2.0 * slope); }
  // Farther back there is freedom; the middle leaves equal margins on both sides.
  [[nodiscard]] double across() const { return 0.5 * (low + high); }
};

}  // namespace

Projection::Projection(const Camera& camera) : eye_w_(camera.eye_w) {
  require::finite(camera.eye_w, "eye_w");
  require::finite(camera.target_w, "target_w");
  require::within(camera.field_of_view, 0.01, 3.0, "field_of_view");
  require::positive(camera.width, "width");
  require::positive(camera.height, "height");
  const Vec3 back_w = (camera.eye_w - camera.target_w).stableNormalized();
  const Vec3 right_w = Vec3::UnitY().cross(back_w);
  require::that(!right_w.isZero(0.0),
                "the line of sight is vertical or has no length: move the eye aside");
  back_w_ = back_w;
  right_w_ = right_w.normalized();
  up_w_ = back_w_.cross(right_w_);
  const elementary::SinCos half = elementary::sincos(0.5 * camera.field_of_view);
  scale_ = 0.5 * camera.height * half.cos / half.sin;
  middle_ = 0.5 * Vec2(camera.width, camera.height);
}

Vec2 Projection::operator()(const Vec3& point_w) const {
  const Vec3 seen_w = point_w - eye_w_;
  const double size = scale_ / depth(point_w);
  return middle_ + size * Vec2(right_w_.dot(seen_w), -up_w_.dot(seen_w));
}

Camera camera_for(std::span<const Vec3> points_w, const Vec3& direction_w, double width,
                  double height, double air) {
  require::that(!points_w.empty(), "no points: expected at least two");
  require::finite(direction_w, "direction_w");
  require::within(air, 0.0, 0.4, "air");
  Camera camera{.eye_w = direction_w, .target_w = Vec3::Zero(), .width = width, .height = height};
  const Projection axes(camera);

  // Across and upwards; the direction that needs more space determines the distance of the eye.
  const double slope_x = (0.5 * width - air * height) / axes.scale();
  const double slope_y = (0.5 - air) * height / axes.scale();
  require::that(slope_x > 0.0,
                "width = " + shortest_text(width) + ": less than the free air at both edges");
  Fit x, y;
  double nearest = -kInfinity;
  double farthest = kInfinity;
  for (const Vec3& point_w : points_w) {
    require::finite(point_w, "points_w");
    const double z = axes.back_w().dot(point_w);
    x.add(axes.right_w().dot(point_w), z, slope_x);
    y.add(axes.up_w().dot(point_w), z, slope_y);
    nearest = std::max(nearest, z);
    farthest = std::min(farthest, z);
  }
  const double depth = std::max(x.depth(slope_x), y.depth(slope_y));
  require::that(depth > nearest,
                "points_w: no two are beside each other as seen from there: bodies so far from the "
                "origin that their size is lost in rounding cannot be drawn");
  const Vec3 across_w = x.across() * axes.right_w() + y.across() * axes.up_w();
  camera.eye_w = across_w + depth * axes.back_w();
  camera.target_w = across_w + 0.5 * (nearest + farthest) * axes.back_w();
  return camera;
}

}  // namespace tumble
