/// \file
/// \brief Pictures of boxes in three dimensions: in exact order, shaded, with soft shadows.
#pragma once

#include "tumble/geometry/box.hpp"
#include "tumble/pictures/camera.hpp"
#include "tumble/pictures/polygon.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// A box to be drawn.
struct PictureBox {
  Box box;                          ///< where it is
  std::uint32_t colour = 0x0072b2;  ///< 0xRRGGBB
  bool die = false;                 ///< with pips on its faces, see pips_of_side()
};

/// The pips on a side of a die: 1, 2 and 3 at its positive axes, and 7 on opposite sides together.
/// \param side 0 to 5, see Box
/// \return 1 to 6
int pips_of_side(int side);

/// The number of the box of an area that belongs to none.
inline constexpr int kNoBox = -1;

/// A filled area.
struct PictureArea {
  /// [px] from the upper left corner, y down. Convex, all in the same sense of rotation; what is
  /// inside any of them is filled, once. Two points are a line.
  std::vector<Polygon> loops;
  std::uint32_t colour = 0;   ///< 0xRRGGBB
  double opacity = 1.0;       ///< [-] 0 to 1
  std::uint32_t outline = 0;  ///< 0xRRGGBB of a thin line around
  bool outlined = false;      ///< whether there is such a line
  bool shadow = false;        ///< whether it darkens what was drawn before it
  int box = kNoBox;           ///< on which box it is, by its number; kNoBox: on the floor
};

/// Areas to be drawn from first to last.
struct Picture {
  double width = 0.0;              ///< [px]
  double height = 0.0;             ///< [px]
  std::vector<PictureArea> areas;  ///< floor and its shadows, then faces and theirs
  /// Rings of boxes that cover one another and could not be mended: some pixels are wrong. 0 else.
  int rings = 0;
};

/// A camera that looks at boxes from a direction and has them, and their shadows, in the picture.
/// \param boxes        what is to be seen, at least one; for several pictures by one camera, the
///                     boxes of all of them
/// \param direction_w  [-] from the boxes to the eye, any length but 0, not vertical
/// \param width        [px] above 0
/// \param height       [px] above 0
/// \param floor        whether shadows fall on the floor y = 0
/// \return the camera
/// \throws std::invalid_argument naming the value that is out of range
Camera camera_for(std::span<const PictureBox> boxes, const Vec3& direction_w, double width,
                  double height, bool floor);

/// Draws boxes.
///
/// Faces that look away are left out, the others are drawn box by box in painter's order. Where
/// boxes cover one another in a ring, what they have in common is drawn again, so that no pixel is
/// wrong for disjoint boxes. The floor fades into the white of the page; shadows fall on it and
/// on faces.
/// \param boxes   in front of the eye; slight overlap is drawn as separation() sees it
/// \param camera  from where
/// \param floor   whether the floor y = 0 is drawn
/// \param around  around what the floor is seen, for several pictures by one camera; none: `boxes`
/// \return the areas, all inside the picture
/// \throws std::invalid_argument for a camera that Projection refuses, or a box that reaches
///         behind the eye or contains it, by its number
/// \par Cost
/// n² pairs of boxes: about 50 ms for 125 boxes, 0.2 s for 400.
Picture draw_boxes(std::span<const PictureBox> boxes, const Camera& camera, bool floor = true,
                   std::span<const PictureBox> around = {});

/// Writes a picture as commands of gnuplot, to be read after a terminal has been set; objects of
/// an earlier picture are taken away, so that several pictures can stand on one page (multiplot).
/// \param picture the areas
/// \return the commands
std::string to_gnuplot(const Picture& picture);

/// Writes a picture as an SVG file.
/// \param picture the areas
/// \return the bytes of the file
std::string to_svg(const Picture& picture);

}  // namespace tumble
