/// \file
/// \brief Marks that tie lines of source to lines of the thesis's listings.
#include "structure/marks.hpp"

#include <algorithm>
#include <regex>

namespace tumble::structure {

std::vector<MarkedRegion> marked_regions(const std::vector<SourceFile>& files,
                                         Complaints& complaints) {
  static const std::regex form(
      R"(^\s*// \[(?:(S\d[\d.]*(?::[a-z_]+)?)|([A-Z]{3,}):(\d+)(?:-(\d+))?)\]\s*$)");
  std::vector<MarkedRegion> regions;
  for (const SourceFile& file : files) {
    MarkedRegion open;  // from == 0: none
    const std::vector<std::string> lines = lines_of(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_match(lines[i], match, form)) continue;
      MarkedRegion here{file.path, i + 1, 0, match[1].matched ? match[1] : match[2], 0, 0};
      if (match[3].matched) {
        here.first_line = std::stoi(match[3]);
        here.last_line = match[4].matched ? std::stoi(match[4]) : here.first_line;
      }
      if (here.last_line < here.first_line)
        complaints.push_back(place(file, i + 1) + "the mark ends before it begins");

      if (open.from == 0) {
        open = here;
        continue;
      }
      const bool twin = open.name == here.name && open.first_line == here.first_line &&
                        open.last_line == here.last_line;
      if (!twin) {
        complaints.push_back(place(file, i + 1) + "the mark stands within that of line " +
                             std::to_string(open.from));
        continue;
      }
      open.to = i + 1;
      regions.push_back(open);
      open = {};
    }
    if (open.from != 0) complaints.push_back(place(file, open.from) + "the mark has no twin");
  }
  return regions;
}

Complaints listing_gaps(const std::vector<MarkedRegion>& regions,
                        const std::vector<Listing>& listings) {
  Complaints complaints;
  for (const MarkedRegion& region : regions) {
    if (region.first_line == 0) continue;
    const auto listing = std::find_if(listings.begin(), listings.end(),
                                      [&](const Listing& l) { return l.name == region.name; });
    const std::string said = region.path + ':' + std::to_string(region.from) + ": " + region.name;
    if (listing == listings.end()) {
      complaints.push_back(said + " is no listing of the thesis");
    } else if (!listing->pending.empty()) {
      complaints.push_back(said + " has marks: it is pending no longer");
    } else if (region.last_line > listing->lines || region.first_line < 1) {
      complaints.push_back(said + " has " + std::to_string(listing->lines) + " lines only");
    }
  }
  for (const Listing& listing : listings) {
    if (!listing.pending.empty()) continue;
    for (const bool as_printed : {false, true}) {
      std::set<int> covered;
      for (const MarkedRegion& region : regions) {
        const bool printed = region.path.find("_as_printed.cpp") != std::string::npos;
        if (region.name != listing.name || printed != as_printed) continue;
        for (int line = region.first_line; line <= region.last_line; ++line) covered.insert(line);
      }
      for (int line = 1; line <= listing.lines; ++line) {
        if (covered.count(line) == 0)
          complaints.push_back(listing.name + ", line " + std::to_string(line) + ": not covered " +
                               (as_printed ? "as printed" : "as meant"));
      }
    }
  }
  return complaints;
}

}  // namespace tumble::structure
