/// \file
/// \brief Marks that tie lines of source to lines of the thesis's listings.
#include "structure/marks.hpp"

#include <algorithm>

namespace tumble::structure {

std::vector<MarkedRegion> marked_regions(const std::vector<SourceFile>& files,
                                         Complaints& complaints) {
  std::vector<MarkedRegion> regions;
  for (const SourceFile& file : files) {
    const auto more = chapters::marked_regions(file.path, file.text, complaints);
    regions.insert(regions.end(), more.begin(), more.end());
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
        if (region.name != listing.name || region.as_printed() != as_printed) continue;
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
