/// \file
/// \brief The folder of published data sets that are not part of this project.
#pragma once

#include "support/catch.hpp"

#include <filesystem>
#include <system_error>

#ifndef TUMBLE_SHARED_DATA
#define TUMBLE_SHARED_DATA ""
#endif

namespace tumble {

// Looks for a folder of published data; a test that needs one that is missing returns at once.
inline std::optional<std::filesystem::path> shared_data(std::string_view folder) {
  const std::string root = TUMBLE_SHARED_DATA;
  const std::filesystem::path path = std::filesystem::path(root) / folder;
  std::error_code ignored;
  if (!root.empty() && std::filesystem::is_directory(path, ignored)) return path;
  WARN("not compared: the data \"" + std::string(folder) + "\" are missing " +
       (root.empty() ? "(no folder was given)" : "in \"" + root + "\"") +
       "; give the folder that has them: cmake -DTUMBLE_SHARED_DATA=DIR");
  return std::nullopt;
}

}  // namespace tumble
