/// \file
/// \brief Videos by ffmpeg, which runs as a program of its own.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <filesystem>
#include <functional>

namespace tumble::app {

/// Writes a video (H.264 in MP4). Frames go to ffmpeg one by one, so that none is ever in a file; a video
/// that cannot be finished is not left half written.
/// \param path    of the video, its folder there
/// \param frames  how many, above 0
/// \param rate    [1/s] frames in a second
/// \param frame   paints frame k, from 0; widths and heights even
/// \throws CannotWrite if ffmpeg is missing, naming its package, or fails; and whatever `frame` throws
void write_video(const std::filesystem::path& path, int frames, double rate,
                 const std::function<Raster(int)>& frame);

}  // namespace tumble::app
