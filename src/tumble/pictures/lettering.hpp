/// \file
/// \brief Numbers drawn into a picture, for films.
#pragma once

#include "tumble/pictures/picture.hpp"

#include <string_view>

namespace tumble {

/// Draws a time or another number as an area of a picture, in strokes, since a raster has no font.
/// \param text    digits, points, hyphens, blanks and the letter s
/// \param corner  [px] upper left corner of the first letter
/// \param height  [px] of a digit, above 0
/// \param colour  0xRRGGBB
/// \throws std::invalid_argument naming an unknown letter
/// \verified{Each digit has its own strokes, and an unknown character is refused}
PictureArea lettering(std::string_view text, const Vec2& corner, double height,
                      std::uint32_t colour);

}  // namespace tumble
