/// \file
/// \brief Parts of a picture: the floor, and the faces of a box with pips and shadows.
#pragma once

#include "tumble/pictures/back_to_front.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/picture.hpp"

#include <span>
#include <vector>

namespace tumble {

/// A scene with its camera and lamps.
struct PictureScene {
  std::span<const PictureBox> boxes;  ///< all boxes
  Vec3 eye_w = Vec3::Zero();          ///< [m] position of the camera
  Projection view;                    ///< projection to pixels
  Lamp lamp;                          ///< for faces and for shadows on the floor
  Lamp face_lamp;                     ///< the same, with fewer points, for shadows on faces
};

/// A scene and its lamps. The more boxes there are, the fewer points a lamp has.
/// \throws std::invalid_argument for a camera that Projection rejects
[[nodiscard]] PictureScene picture_scene(std::span<const PictureBox> boxes, const Camera& camera);

/// The floor y = 0 with the shadows of all boxes on it.
/// \param around  boxes that define the extent of the floor
/// \return areas from the farthest to the nearest layer; they may extend beyond the picture. None
///         if the eye is below the floor
[[nodiscard]] std::vector<PictureArea> floor_areas(const PictureScene& scene,
                                                   std::span<const PictureBox> around);

/// A face of a box.
struct PictureFace {
  FacePart whole;                  ///< its corners in space
  std::vector<PictureArea> areas;  ///< its rectangle, pips, shadows: in the order of painting
};

/// The visible faces of a box, with pips and the shadows of other boxes.
/// \param number  an index of `scene.boxes`
/// \return the faces; they may extend beyond the picture
[[nodiscard]] std::vector<PictureFace> visible_faces(const PictureScene& scene, std::size_t number);

}  // namespace tumble
