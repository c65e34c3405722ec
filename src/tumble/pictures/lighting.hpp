/// \file
/// \brief Lighting of a picture: brightness of faces, and shadows.
#pragma once

#include "tumble/geometry/box.hpp"
#include "tumble/pictures/camera.hpp"
#include "tumble/pictures/polygon.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tumble {

/// Mixes two colours.
/// \param colour  0xRRGGBB
/// \param with    0xRRGGBB
/// \param share   [-] of the second one, 0 to 1
/// \return 0xRRGGBB, rounded
std::uint32_t mixed(std::uint32_t colour, std::uint32_t with, double share);

/// Formats a colour as web pages and gnuplot do.
/// \param colour 0xRRGGBB
/// \return for example "#0072b2"
std::string colour_text(std::uint32_t colour);

/// A flat surface that shadows fall on.
struct Plane {
  Vec3 origin_w = Vec3::Zero();   ///< [m] a point of it
  Vec3 u_w = Vec3::UnitZ();       ///< [-] first axis in it, length 1
  Vec3 v_w = Vec3::UnitX();       ///< [-] second axis, length 1, across the first
  Vec3 normal_w = Vec3::UnitY();  ///< [-] u x v, to the visible side

  /// A point of the surface in space.
  /// \param p [m] along u and v
  /// \return [m] world frame
  [[nodiscard]] Vec3 at(const Vec2& p) const { return origin_w + p.x() * u_w + p.y() * v_w; }
};

/// A lamp high over the viewer's left shoulder, infinitely far away and six degrees wide, so that the
/// three visible faces of a box have different shades, and shadows soft edges.
class Lamp {
 public:
  /// [rad] Half its width as seen from the scene.
  static constexpr double kRadius = 0.055;

  /// Places the lamp.
  /// \param points  number of its points; a soft shadow is the overlay of the shadows of all of them, and
  ///                sharp for 1, the middle
  Lamp(const Projection& view, int points);

  /// The middle of the lamp [-]: direction to it, length 1, world frame.
  [[nodiscard]] const Vec3& middle_w() const { return middle_w_; }
  /// The points of the lamp [-]: directions to them, length 1, world frame.
  [[nodiscard]] const std::vector<Vec3>& points_w() const { return points_w_; }

  /// The colour of a face: ambient light, diffuse light by Lambert's cosine, and a little white where it is
  /// brightest.
  /// \param colour    0xRRGGBB, of the object
  /// \param normal_w  [-] of the face, length 1
  /// \return 0xRRGGBB
  [[nodiscard]] std::uint32_t shade(std::uint32_t colour, const Vec3& normal_w) const;

  /// Darkness of the shadow on a face.
  /// \param normal_w [-] of the face, length 1
  /// \return [-] opacity of the shadow, 0 for a face that looks away from the lamp
  [[nodiscard]] double shadow_depth(const Vec3& normal_w) const;

 private:
  Vec3 middle_w_;
  std::vector<Vec3> points_w_;
};

/// The shadow of the part of a box in front of a surface.
/// \param light_w  [-] direction to the light; its angle with the normal is less than 90 degrees
/// \return [m] along u and v, counter-clockwise; none if the box is behind the surface
[[nodiscard]] Polygon shadow_of(const Box& box, const Plane& plane, const Vec3& light_w);

}  // namespace tumble
