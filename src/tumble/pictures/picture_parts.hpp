/// \file
/// \brief What a picture is painted with: the floor, and the faces of a box with what falls on them.
#pragma once

#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/picture.hpp"

#include <span>
#include <vector>

namespace tumble {

/// A scene and who looks at it.
struct PictureScene {
  std::span<const PictureBox> boxes;  ///< what is seen
  Vec3 eye_w = Vec3::Zero();          ///< [m] from where
  Projection view;                    ///< how points become pixels
  Lamp lamp;                          ///< what shines on them, in points for shadows on the floor
  Lamp face_lamp;                     ///< the same, in points for shadows on faces
};

/// A scene and its lamps. Shadows of many boxes are small and many: fewer points make each.
/// \param boxes   what is seen
/// \param camera  from where
/// \return the scene
/// \throws std::invalid_argument for a camera that Projection refuses
[[nodiscard]] PictureScene picture_scene(std::span<const PictureBox> boxes, const Camera& camera);

/// The floor y = 0 with the shadows of all boxes on it.
/// \param scene   what stands on it or above
/// \param around  around what it is seen
/// \return areas from the farthest to the nearest layer; they may reach beyond the picture. None
///         if the eye is below the floor
[[nodiscard]] std::vector<PictureArea> floor_areas(const PictureScene& scene,
                                                   std::span<const PictureBox> around);

/// The faces of a box that are seen, with pips and the shadows of other boxes on them.
/// \param scene   all boxes
/// \param number  which one, an index of `scene.boxes`
/// \return areas in the order of painting; they may reach beyond the picture
[[nodiscard]] std::vector<PictureArea> face_areas(const PictureScene& scene, std::size_t number);

}  // namespace tumble
