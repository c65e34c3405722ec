/// \file
/// \brief Running the command `tumble` from a test.
#pragma once

#include "support/catch.hpp"
#include "support/files.hpp"

#include <cstdio>
#include <filesystem>
#include <sys/wait.h>

#ifndef TUMBLE_COMMAND
#define TUMBLE_COMMAND "tumble"  // where the build does not say: the one that is installed
#endif

namespace tumble::test {

// How a command ended.
struct Outcome {
  int code = -1;     // exit code; 128 + signal if it was killed
  std::string text;  // both streams
};

// Runs a line of a shell.
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

// Runs the command.
inline Outcome run_tumble(const std::string& arguments) {
  return shell(std::string(TUMBLE_COMMAND) + " " + arguments);
}

// Runs a line of a shell that has to end with a code.
inline Outcome shell_ends(int code, const std::string& line) {
  Outcome outcome = shell(line);
  INFO(line << '\n' << outcome.text);
  CHECK(outcome.code == code);
  return outcome;
}

// Runs the command, which has to end with a code.
inline Outcome tumble_ends(int code, const std::string& arguments) {
  return shell_ends(code, std::string(TUMBLE_COMMAND) + " " + arguments);
}

// A command line that is wrong, and what its answer has to contain.
struct Refusal {
  std::string arguments;  // as typed after the command's name
  std::string message;    // a part of the answer
};

// Checks that each command line is refused with one line and exit code 2.
inline void check_refused(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    const Outcome outcome = run_tumble(refusal.arguments);
    INFO(refusal.arguments << '\n' << outcome.text);
    CHECK(outcome.code == 2);
    CHECK(outcome.text.find(refusal.message) != std::string::npos);
    CHECK(outcome.text.find("tumble: tumble:") == std::string::npos);
    CHECK(std::ranges::count(outcome.text, '\n') == 1);
  }
}

// The hash in a run's summary.
inline std::string hash_of(const std::filesystem::path& folder) {
  const std::string text = content(folder / "summary.json");
  const std::size_t at = text.find("\"state_hash\": \"");
  return at == std::string::npos ? "none" : text.substr(at + 15, 16);
}

// Whether a table is whole: it ends with a line, and all lines have as many commas as the first.
inline bool whole_lines(const std::filesystem::path& path) {
  const std::string text = content(path);
  if (text.empty() || text.back() != '\n') return false;
  std::istringstream in(text);
  std::ptrdiff_t commas = -1;
  for (std::string line; std::getline(in, line);) {
    const auto here = std::ranges::count(line, ',');
    if (commas >= 0 && here != commas) return false;
    commas = here;
  }
  return true;
}

}  // namespace tumble::test
