/// \file
/// \brief Files and folders of tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace tumble::test {

namespace fs = std::filesystem;

// Reads a whole file.
inline std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

// Reads the lines of a file.
inline std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// A folder of its own for a test and its process: not there at its start, and gone at its end.
struct Folder {
  // Makes sure that it is not there.
  explicit Folder(const std::string& name)
      : path(fs::temp_directory_path() / ("tumble_test_" + name + '_' + std::to_string(getpid()))) {
    fs::remove_all(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  // A path in the folder, which is made.
  [[nodiscard]] fs::path file(const std::string& name) const {
    fs::create_directories(path);
    return path / name;
  }
  // Names the folder.
  [[nodiscard]] std::string text() const { return path.string(); }
  fs::path path;  // where it is
};

}  // namespace tumble::test
