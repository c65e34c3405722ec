/// \file
/// \brief Camera of a picture, and its projection from the world to pixels.
#pragma once

#include "tumble/base/types.hpp"

#include <span>

namespace tumble {

/// Position, direction and size of a picture. Its upper edge is upwards in the world.
struct Camera {
  Vec3 eye_w = Vec3(6.0, 5.0, 10.0);  ///< [m] position of the camera
  Vec3 target_w = Vec3::Zero();       ///< [m] point in the middle of the picture
  double field_of_view = 0.5;         ///< [rad] from the lower to the upper edge
  double width = 900.0;               ///< [px]
  double height = 600.0;              ///< [px]
};

/// The closest camera that has all points in the picture, seen from a direction.
/// \param points_w     [m] at least two different ones
/// \param direction_w  [-] from the points to the eye, any length but 0, not vertical
/// \param width        [px] above 0
/// \param height       [px] above 0
/// \param air          [-] free margin at each edge, as a share of the height, 0 to 0.4
/// \return the camera; along one pair of edges points lie on the margin
/// \throws std::invalid_argument naming the value that is out of range
Camera camera_for(std::span<const Vec3> points_w, const Vec3& direction_w, double width,
                  double height, double air = 0.06);

/// Perspective projection from the world to pixels.
class Projection {
 public:
  /// Makes the projection.
  /// \throws std::invalid_argument for values that are not finite, a line of sight that is vertical
  ///         or of length 0, a field of view outside 0.01 to 3 rad, or a size not above 0
  explicit Projection(const Camera& camera);

  /// The image of a point.
  /// \param point_w [m] world frame, its depth above 0
  /// \return [px] from the upper left corner, y down
  [[nodiscard]] Vec2 operator()(const Vec3& point_w) const;

  /// Distance of a point in front of the eye.
  /// \return [m] along the middle line of sight; below 0 behind the eye
  [[nodiscard]] double depth(const Vec3& point_w) const { return -back_w_.dot(point_w - eye_w_); }

  /// Direction opposite to the line of sight [-], length 1, world frame.
  [[nodiscard]] const Vec3& back_w() const { return back_w_; }
  /// To the right in the picture [-], length 1, horizontal, world frame.
  [[nodiscard]] const Vec3& right_w() const { return right_w_; }
  /// Upwards in the picture [-], length 1, world frame.
  [[nodiscard]] const Vec3& up_w() const { return up_w_; }
  /// Scale of the projection [px], of a length of 1 m across the line of sight at a depth of 1 m.
  [[nodiscard]] double scale() const { return scale_; }

 private:
  Vec3 eye_w_;
  Vec2 middle_;  // [px]
  Vec3 back_w_, right_w_, up_w_;
  double scale_;
};

}  // namespace tumble
