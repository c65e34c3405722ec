/// \file
/// \brief Marks in the source that tie lines of it to lines of the thesis's listings.
#include "driver/marks.hpp"

#include <regex>
#include <sstream>

namespace tumble::chapters {

bool MarkedRegion::as_printed() const { return path.find("as_printed/") != std::string::npos; }

std::vector<MarkedRegion> marked_regions(const std::string& path, const std::string& text,
                                         std::vector<std::string>& complaints) {
  static const std::regex form(
      R"(^\s*// \[(?:(S\d[\d.]*(?::[a-z_]+)?)|([A-Z]{3,}):(\d+)(?:-(\d+))?)\]\s*$)");
  const auto complain = [&](std::size_t line, const std::string& what) {
    complaints.push_back(path + ':' + std::to_string(line) + ": " + what);
  };
  std::vector<MarkedRegion> regions;
  MarkedRegion open;  // from == 0: none
  std::istringstream in(text);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, form)) continue;
    MarkedRegion here{path, number, 0, match[1].matched ? match[1] : match[2], 0, 0};
    if (match[3].matched) {
      here.first_line = std::stoi(match[3]);
      here.last_line = match[4].matched ? std::stoi(match[4]) : here.first_line;
    }
    if (here.last_line < here.first_line) complain(number, "the mark ends before it begins");

    if (open.from == 0) {
      open = here;
      continue;
    }
    const bool twin = open.name == here.name && open.first_line == here.first_line &&
                      open.last_line == here.last_line;
    if (!twin) {
      complain(number, "the mark stands within that of line " + std::to_string(open.from));
      continue;
    }
    open.to = number;
    regions.push_back(open);
    open = {};
  }
  if (open.from != 0) complain(open.from, "the mark has no twin");
  return regions;
}

}  // namespace tumble::chapters
