/// \file
/// \brief Films as animated GIF files.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// The most colours that a GIF of ours shows; one more number stands for pixels that stay.
inline constexpr int kGifColours = 255;

/// How long each frame is shown. Hundredths of a second are all that there is: rates that they do not divide
/// are kept on the average, and above 50 frames a second browsers slow down.
/// \param frames  how many, at least one
/// \param rate    [1/s] frames in a second, 1 to 50
/// \param pause   [s] for which the last one stays on top, 0 to 60
/// \return [1/100 s] for each frame
/// \throws std::invalid_argument naming the value that is out of range
std::vector<int> gif_delays(int frames, double rate, double pause);

/// Writes a film that begins anew when it is over.
///
/// All frames share one palette: the colours of frames from all over the film, in cells that are split
/// where they differ most, each by its most frequent colour, so that flat colours stay what
/// they are. Of a frame only the rectangle that has changed is written.
/// \param delays  [1/100 s] how long each frame is shown, 1 to 65535
/// \param frame   paints frame k, from 0; called twice for some
/// \return the bytes of the file, the same every time
/// \throws std::invalid_argument for no frames, a delay out of range, or frames of different sizes
/// \verified{A GIF that is read back has the pixels that were written}
/// \see Graphics Interchange Format, version 89a. CompuServe, 1990.
std::string to_gif(std::span<const int> delays, const std::function<Raster(int)>& frame);

}  // namespace tumble
