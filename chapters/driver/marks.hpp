/// \file
/// \brief Marks in the source that tie lines of it to lines of the thesis's listings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tumble::chapters {

// A region of source between a mark and its twin.
struct MarkedRegion {
  std::string path;    // the file
  std::size_t from{};  // line of the first mark
  std::size_t to{};    // line of the second
  std::string name;    // a listing's name, or a section such as "S4.3" or "S4.3:what"
  int first_line = 0;  // of the listing; 0 for a section
  int last_line = 0;   // of the listing; 0 for a section

  // Whether it follows the listing as printed.
  [[nodiscard]] bool as_printed() const;
};

// Finds the marks of a file, lines with nothing but `// [NAME:from-to]`, `// [NAME:line]`, `// [S4.3]` or
// `// [S4.3:what]`.
std::vector<MarkedRegion> marked_regions(const std::string& path, const std::string& text,
                                         std::vector<std::string>& complaints);

}  // namespace tumble::chapters
