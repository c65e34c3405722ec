/// \file
/// \brief Films as animated GIF files.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// The most colours of a GIF written here; one more index stands for unchanged pixels.
inline constexpr int kGifColours = 255;

/// Duration of each frame. The unit is a hundredth of a second: other rates are kept on average; above 50
/// frames a second browsers slow down.
/// \param frames  number of frames, at least one
/// \param rate    [1/s] frames in a second, 1 to 50
/// \param pause   [s] extra duration of the last frame, 0 to 60
/// \return [1/100 s] for each frame
/// \throws std::invalid_argument naming the value that is out of range
std::vector<int> gif_delays(int frames, double rate, double pause);

/// Writes a film that repeats endlessly.
///
/// All frames share one palette: the colours of sampled frames, in cells that are split where the spread
/// is largest, each represented by its most frequent colour, so that flat colours are kept exactly.
/// Only the rectangle of a frame that has changed is written.
/// \param delays  [1/100 s] duration of each frame, 1 to 65535
/// \param frame   paints frame k, from 0; called twice for some
/// \return the bytes of the file, the same every time
/// \throws std::invalid_argument for no frames, a delay out of range, or frames of different sizes
/// \verified{A GIF that is read back has the pixels that were written}
/// \see Graphics Interchange Format, version 89a. CompuServe, 1990.
std::string to_gif(std::span<const int> delays, const std::function<Raster(int)>& frame);

}  // namespace tumble
