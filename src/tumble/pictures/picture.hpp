/// \file
/// \brief Pictures of boxes in three dimensions: exact hidden surfaces, shading, soft shadows.
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
  Box box;                          ///< its pose and size
  std::uint32_t colour = 0x0072b2;  ///< 0xRRGGBB
  bool die = false;                 ///< with pips on its faces, see pips_of_side()
};

/// The pips on a side of a die: 1, 2 and 3 at its positive axes; opposite sides have 7 together.
/// \param side 0 to 5, see Box
/// \return 1 to 6
int pips_of_side(int side);

/// Value of PictureArea::box for areas of no box.
inline constexpr int kNoBox = -1;

/// A filled area.
struct PictureArea {
  /// [px] from the upper left corner, y down. Convex, all in the same sense of rotation; their union is
  /// filled. Two points are a line.
  std::vector<Polygon> loops;
  std::uint32_t colour = 0;   ///< 0xRRGGBB
  double opacity = 1.0;       ///< [-] 0 to 1
  std::uint32_t outline = 0;  ///< 0xRRGGBB of a thin line around
  bool outlined = false;      ///< whether there is such a line
  bool shadow = false;        ///< whether it is a shadow on areas drawn before
  int box = kNoBox;           ///< index of its box; kNoBox: on the floor
};

/// Areas to be drawn from first to last.
struct Picture {
  double width = 0.0;              ///< [px]
  double height = 0.0;             ///< [px]
  std::vector<PictureArea> areas;  ///< floor and its shadows, then faces and theirs
};

/// A camera that has boxes and their shadows in the picture, seen from a direction.
/// \param boxes        at least one; for several pictures by one camera, the boxes of all of them
/// \param direction_w  [-] from the boxes to the eye, any length but 0, not vertical
/// \param width        [px] above 0
/// \param height       [px] above 0
/// \param floor        whether shadows fall on the floor y = 0
/// \throws std::invalid_argument naming the value that is out of range
Camera camera_for(std::span<const PictureBox> boxes, const Vec3& direction_w, double width,
                  double height, bool floor);

/// Draws boxes.
///
/// Back faces are omitted, the others are drawn box by box in painter's order. Boxes that overlap or cover
/// each other in a ring are drawn together, their faces cut by each other, so that no pixel is wrong. The
/// floor fades into the white of the page; shadows fall on it and on faces.
/// \param boxes   in front of the eye
/// \param floor   whether the floor y = 0 is drawn
/// \param around  the floor is drawn around these, for several pictures by one camera; none: `boxes`
/// \return the areas, all inside the picture
/// \throws std::invalid_argument for a camera that Projection rejects, or a box that reaches
///         behind the eye or contains it, by its index
/// \par Cost
/// n² pairs of boxes: less than 0.1 s for 125 and for 343 boxes, whose shadows are coarser; 0.2 s for 54 in each other.
Picture draw_boxes(std::span<const PictureBox> boxes, const Camera& camera, bool floor = true,
                   std::span<const PictureBox> around = {});

/// Writes a picture as gnuplot commands, to be read after a terminal has been set; objects of an
/// earlier picture are removed, so that several pictures can be on one page (multiplot).
std::string to_gnuplot(const Picture& picture);

/// Writes a picture as an SVG file.
std::string to_svg(const Picture& picture);

}  // namespace tumble
