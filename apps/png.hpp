/// \file
/// \brief Pictures as PNG files, by stb_image_write.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <filesystem>

namespace tumble::app {

/// Writes pixels as a PNG.
/// \param path    of the picture, its folder there
/// \throws CannotWrite if it cannot be written, or if the command was built without stb, naming its package
void write_png(const std::filesystem::path& path, const Raster& pixels);

}  // namespace tumble::app
