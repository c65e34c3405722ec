/// \file
/// \brief Running the command `tumble` from a test.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

#ifndef TUMBLE_COMMAND
#define TUMBLE_COMMAND "tumble"  // where the build does not say: the one that is installed
#endif

namespace tumble::test {

/// How a command ended.
struct Outcome {
  int code = -1;     ///< exit code; 128 + signal if it was killed
  std::string text;  ///< both streams
};

/// Runs a line of a shell.
/// \param line what to run
/// \return how it ended
inline Outcome shell(const std::string& line) {
  const std::string command = "(" + line + ") 2>&1";
  Outcome out;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    out.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  out.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return out;
}

/// Runs the command.
/// \param arguments as typed after its name
/// \return how it ended
inline Outcome run_tumble(const std::string& arguments) {
  return shell(std::string(TUMBLE_COMMAND) + " " + arguments);
}

/// The content of a file.
/// \param path the file
/// \return its bytes; empty if there is none
inline std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// A folder of its own for a test: not there at its start, and gone at its end.
struct Folder {
  /// Makes sure that it is not there.
  /// \param name no other test's
  explicit Folder(const char* name)
      : path(std::filesystem::temp_directory_path() / (std::string("tumble_command_") + name)) {
    std::filesystem::remove_all(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  /// Where it is.
  /// \return as the command line takes it
  [[nodiscard]] std::string text() const { return path.string(); }
  std::filesystem::path path;  ///< where it is
};

/// The hash in a run's summary.
/// \param folder of the run
/// \return 16 digits, or "none"
inline std::string hash_of(const std::filesystem::path& folder) {
  const std::string text = content(folder / "summary.json");
  const std::size_t at = text.find("\"state_hash\": \"");
  return at == std::string::npos ? "none" : text.substr(at + 15, 16);
}

/// Whether a table is whole: it ends with a line, and all lines have as many commas as the first.
/// \param path a table without quoted cells
/// \return false for a table that is cut
inline bool whole_lines(const std::filesystem::path& path) {
  const std::string text = content(path);
  if (text.empty() || text.back() != '\n') return false;
  std::istringstream in(text);
  std::ptrdiff_t commas = -1;
  for (std::string line; std::getline(in, line);) {
    const auto here = std::count(line.begin(), line.end(), ',');
    if (commas >= 0 && here != commas) return false;
    commas = here;
  }
  return true;
}

}  // namespace tumble::test
