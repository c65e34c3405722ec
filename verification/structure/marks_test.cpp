/// \file
/// \brief The listings of the thesis are in the source, line by line.
#include "driver/marks.hpp"

#include "structure/source_tree.hpp"
#include "support/catch.hpp"

namespace tumble::structure {
namespace {

using chapters::MarkedRegion;

struct Listing {
  std::string name;  // as in marks
  int lines = 0;
};

// The nine listings of appendix A and how many lines they have.
const std::vector<Listing>& listings() {
  static const std::vector<Listing> all{{"SIMPLESYNCTIMEWARP", 23},    {"SAFERSYNCTIMEWARP", 34},
                                        {"DAMPEDINTEGRATION", 7},      {"COLLIDE", 15},
                                        {"RESOLVECOLLISIONS", 7},      {"RESOLVECONTACTS", 7},
                                        {"DAMPENOBJECTS", 29},         {"FIXCONTACTCONSTRAINTS", 8},
                                        {"SETGEOMETRICALLYSTABLE", 21}};
  return all;
}

std::vector<MarkedRegion> marked_regions(const std::vector<SourceFile>& files,
                                         Complaints& complaints) {
  std::vector<MarkedRegion> regions;
  for (const SourceFile& file : files) {
    const auto more = chapters::marked_regions(file.path, file.text, complaints);
    regions.insert(regions.end(), more.begin(), more.end());
  }
  return regions;
}

// Lines of listings that are not covered twice, in the source that follows what was meant and in folders named
// as_printed, and marks of listings or lines that do not exist.
Complaints listing_gaps(const std::vector<MarkedRegion>& regions,
                        const std::vector<Listing>& listings) {
  Complaints complaints;
  for (const MarkedRegion& region : regions) {
    if (region.first_line == 0) continue;
    const auto listing =
        std::ranges::find_if(listings, [&](const Listing& l) { return l.name == region.name; });
    const std::string said = region.path + ':' + std::to_string(region.from) + ": " + region.name;
    if (listing == listings.end()) {
      complaints.push_back(said + " is no listing of the thesis");
    } else if (region.last_line > listing->lines || region.first_line < 1) {
      complaints.push_back(said + " has " + std::to_string(listing->lines) + " lines only");
    }
  }
  for (const Listing& listing : listings) {
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

}  // namespace

TEST_CASE("A mark without twin, within another one or backwards is found", "[structure]") {
  const auto complaints_of = [](const char* text) {
    Complaints complaints;
    marked_regions({{"a.cpp", text}}, complaints);
    return complaints;
  };
  CHECK(complaints_of("// [COLLIDE:1-4]\nx();\n") == Complaints{"a.cpp:1: the mark has no twin"});
  CHECK(complaints_of("// [COLLIDE:1-4]\n// [S4.3]\n// [COLLIDE:1-4]\n") ==
        Complaints{"a.cpp:2: the mark stands within that of line 1"});
  CHECK(complaints_of("// [COLLIDE:4-1]\n// [COLLIDE:4-1]\n").size() == 2);
}

TEST_CASE("A missing line of a listing and a mark that no listing has are found", "[structure]") {
  const std::vector<Listing> short_one{{"COLLIDE", 3}};
  const MarkedRegion meant{"a.cpp", 1, 5, "COLLIDE", 1, 3};
  MarkedRegion part{"as_printed/a.cpp", 1, 5, "COLLIDE", 1, 2};
  CHECK(listing_gaps({meant, part}, short_one) ==
        Complaints{"COLLIDE, line 3: not covered as printed"});
  part.last_line = 3;
  CHECK(listing_gaps({meant, part}, short_one).empty());
  CHECK(listing_gaps({meant}, {}).size() == 1);
}

TEST_CASE("Each listing of the thesis is covered line by line", "[structure]") {
  Complaints complaints;
  const auto files = project_files();
  marked_regions(code_in(files, ""), complaints);
  expect_none(complaints);
  const auto regions = marked_regions(code_in(files, "src/"), complaints);
  expect_none(listing_gaps(regions, listings()));
  int lines = 0;
  for (const Listing& listing : listings()) lines += listing.lines;
  CHECK(lines == 151);
}

}  // namespace tumble::structure
