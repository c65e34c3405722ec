/// \file
/// \brief Reading a file of text, with a limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tumble {

/// Reads all of a file; a pipe will do.
/// \param wanted    the kind of file, for messages, for example "a scene file, *.toml"
/// \param most_mib  [MiB] largest size
/// \throws std::invalid_argument if there is no such file, it is a folder, cannot be read, or is larger
std::string read_text(const std::filesystem::path& path, const std::string& wanted,
                      std::size_t most_mib);

}  // namespace tumble
