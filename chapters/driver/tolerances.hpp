/// \file
/// \brief The small numbers of the library, read from their headers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// One constant of a `tolerances.hpp`.
struct Tolerance {
  std::string layer;    // of the library
  std::string name;     // of the constant
  std::string value;    // as the source writes it
  std::string unit;     // "-" for a ratio
  std::string meaning;  // what it decides
  std::string reason;   // why it has that size
  std::string section;  // of the thesis, or what else it belongs to
};

// Reads all constants of the header.
//
// A constant is a docstring `[unit] what it decides. Reason: why. (section)` and the line
// `inline constexpr double name = value;` (or int); a comment `// --- layer ---` begins a layer. Anything
// else within the namespace is a mistake.
std::vector<Tolerance> read_tolerances(const std::filesystem::path& path);

// Reads all constants of the library, of the `tolerances.hpp` in each of its folders.
std::vector<Tolerance> read_all_tolerances(const std::filesystem::path& library);

}  // namespace tumble::chapters
