/// \file
/// \brief Shades and shadows.
#include "tumble/pictures/lighting.hpp"

#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// Direction to the lamp, relative to the viewer: up, to the left and behind.
constexpr double kUp = 0.84, kLeft = 0.42, kBehind = 0.38;

constexpr double kFromEverywhere = 0.58;  // ambient light
constexpr double kFromLamp = 0.42;        // diffuse light at normal incidence
constexpr double kAwayFromLamp = 0.14;    // decrease of ambient light on faces opposite to the lamp
constexpr double kGloss = 0.18;           // white in the brightest face
constexpr std::uint32_t kDark = 0x10101a;

constexpr double kGoldenAngle = 2.399963229728653;  // [rad] spreads points evenly over a disc

}  // namespace

std::string colour_text(std::uint32_t colour) {
  std::string text = "#";
  for (int place = 20; place >= 0; place -= 4) text += "0123456789abcdef"[colour >> place & 15U];
  return text;
}

std::uint32_t mixed(std::uint32_t colour, std::uint32_t with, double share) {
  std::uint32_t out = 0;
  for (int shift = 16; shift >= 0; shift -= 8) {
    const double a = static_cast<double>(colour >> shift & 0xffU);
    const double b = static_cast<double>(with >> shift & 0xffU);
    out = out << 8U | static_cast<std::uint32_t>(std::lround(a + share * (b - a)));
  }
  return out;
}

Lamp::Lamp(const Projection& view, int points) {
  const Vec3 behind_w = view.right_w().cross(Vec3::UnitY());  // back, made level
  middle_w_ = (kUp * Vec3::UnitY() - kLeft * view.right_w() + kBehind * behind_w).normalized();
  // A spiral from the middle outwards that gives every point the same area of the disc.
  const Vec3 a_w = middle_w_.cross(Vec3::UnitY()).normalized();
  const Vec3 b_w = middle_w_.cross(a_w);
  for (int k = 0; k < points; ++k) {
    const double radius = kRadius * std::sqrt(static_cast<double>(k) / points);
    const elementary::SinCos turn = elementary::sincos(kGoldenAngle * k);
    points_w_.push_back((middle_w_ + radius * (turn.cos * a_w + turn.sin * b_w)).normalized());
  }
}

std::uint32_t Lamp::shade(std::uint32_t colour, const Vec3& normal_w) const {
  const double cosine = normal_w.dot(middle_w_);
  const double lit = std::max(0.0, cosine);
  const double light = kFromEverywhere + kFromLamp * lit + kAwayFromLamp * std::min(0.0, cosine);
  return mixed(mixed(kDark, colour, light), 0xffffff, kGloss * lit * lit);
}

double Lamp::shadow_depth(const Vec3& normal_w) const {
  const double lamp = kFromLamp * std::max(0.0, normal_w.dot(middle_w_));
  return lamp / (kFromEverywhere + lamp);
}

Polygon shadow_of(const Box& box, const Plane& plane, const Vec3& light_w) {
  // The box's silhouette in front of the surface: its corners there, and the points where edges cross it.
  std::array<double, 8> heights;
  Polygon points;
  const std::array<Vec3, 8> corners_w = corners_of(box);
  const double rise = light_w.dot(plane.normal_w);
  const auto slide = [&](const Vec3& point_w, double height) {
    const Vec3 on_w = point_w - height / rise * light_w - plane.origin_w;
    points.emplace_back(plane.u_w.dot(on_w), plane.v_w.dot(on_w));
  };
  for (std::size_t k = 0; k < 8; ++k) {
    heights[k] = plane.normal_w.dot(corners_w[k] - plane.origin_w);
    if (heights[k] > 0.0) slide(corners_w[k], heights[k]);
  }
  if (points.empty()) return points;
  for (std::size_t k = 0; k < 8; ++k) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      const std::size_t other = k | bit;
      if (other == k || (heights[k] > 0.0) == (heights[other] > 0.0)) continue;
      const double share = heights[k] / (heights[k] - heights[other]);
      slide(corners_w[k] + share * (corners_w[other] - corners_w[k]), 0.0);
    }
  }
  return convex_hull(std::move(points));
}

}  // namespace tumble
