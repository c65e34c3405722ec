/// \file
/// \brief Scenes as TOML files.
#pragma once

#include "tumble/scenes/scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace tumble {

/// Reads a scene from the text of a TOML file.
///
/// A misspelt key is an error; no key is ignored.
/// \param file  its name, for messages
/// \throws std::invalid_argument "FILE:LINE: KEY = VALUE: what would be right"
Scene parse_scene(std::string_view text, std::string_view file);

/// Reads a scene file.
/// \param path  a TOML file of at most 64 MiB
/// \throws std::invalid_argument if it cannot be read, or as parse_scene()
Scene read_scene(const std::filesystem::path& path);

/// Writes a scene as a TOML file that reads back to the same bits.
std::string to_toml(const Scene& scene);

}  // namespace tumble
