/// \file
/// \brief Pictures by gnuplot and videos by ffmpeg, which run as programs of their own, and pixels as PNG.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace tumble::app {

/// Draws a picture. The script stays beside it, so that it can be changed by hand; a picture that
/// cannot be finished is not left half drawn.
/// \param folder    where script and picture go
/// \param commands  gnuplot commands, from the terminal on; they need not set the output
/// \throws CannotWrite if gnuplot is missing, naming its package, or fails
void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& script,
                       const std::string& commands, const std::string& picture);

/// Writes a video (H.264 in MP4). Frames go to ffmpeg one by one, so that none is ever in a file; a video
/// that cannot be finished is not left half written.
/// \param path    of the video, its folder there
/// \param frames  how many, above 0
/// \param rate    [1/s] frames in a second
/// \param frame   paints frame k, from 0; widths and heights even
/// \throws CannotWrite if ffmpeg is missing, naming its package, or fails; and whatever `frame` throws
void write_video(const std::filesystem::path& path, int frames, double rate,
                 const std::function<Raster(int)>& frame);

/// Writes pixels as a PNG.
/// \param path    of the picture, its folder there
/// \throws CannotWrite if it cannot be written, or if the command was built without stb, naming its package
void write_png(const std::filesystem::path& path, const Raster& pixels);

}  // namespace tumble::app
