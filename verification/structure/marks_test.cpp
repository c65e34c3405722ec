/// \file
/// \brief The listings of the thesis are in the source, line by line.
#include "structure/marks.hpp"

#include "support/catch.hpp"

namespace tumble::structure {
namespace {

// The nine listings of appendix A. A listing waits for its chapter, and leaves this list's third
// column when the chapter comes: covered as a whole or not at all.
const std::vector<Listing>& listings() {
  static const std::vector<Listing> all{
      {"SIMPLESYNCTIMEWARP", 23, ""},    {"SAFERSYNCTIMEWARP", 34, ""},
      {"DAMPEDINTEGRATION", 7, ""},      {"COLLIDE", 15, ""},
      {"RESOLVECOLLISIONS", 7, ""},      {"RESOLVECONTACTS", 7, ""},
      {"DAMPENOBJECTS", 29, ""},         {"FIXCONTACTCONSTRAINTS", 8, ""},
      {"SETGEOMETRICALLYSTABLE", 21, ""}};
  return all;
}

Complaints complaints_of(const std::string& text) {
  Complaints complaints;
  marked_regions({{"a.cpp", text}}, complaints);
  return complaints;
}

}  // namespace

TEST_CASE("Marks are found with their lines", "[structure]") {
  Complaints complaints;
  const auto regions = marked_regions(
      {{"a.cpp",
        "  // [COLLIDE:1-4]\nx();\n  // [COLLIDE:1-4]\n// [S4.3:tail]\ny();\n// [S4.3:tail]\n"},
       {"b.cpp", "// [COLLIDE:7]\nz();\n// [COLLIDE:7]\n// see [COLLIDE:8]\n"}},
      complaints);
  CHECK(complaints.empty());
  REQUIRE(regions.size() == 3);
  CHECK(regions[0].name == "COLLIDE");
  CHECK(regions[0].first_line == 1);
  CHECK(regions[0].last_line == 4);
  CHECK(regions[0].to == 3);
  CHECK(regions[1].name == "S4.3:tail");
  CHECK(regions[1].first_line == 0);
  CHECK(regions[2].first_line == 7);
  CHECK(regions[2].last_line == 7);
}

TEST_CASE("A mark without twin, within another one or backwards is found", "[structure]") {
  CHECK(complaints_of("// [COLLIDE:1-4]\nx();\n") == Complaints{"a.cpp:1: the mark has no twin"});
  CHECK(complaints_of("// [COLLIDE:1-4]\n// [S4.3]\n// [COLLIDE:1-4]\n") ==
        Complaints{"a.cpp:2: the mark stands within that of line 1"});
  CHECK(complaints_of("// [COLLIDE:4-1]\n// [COLLIDE:4-1]\n").size() == 2);
}

TEST_CASE("A missing line of a listing is found", "[structure]") {
  const std::vector<Listing> short_one{{"COLLIDE", 3, ""}};
  const MarkedRegion meant{"a.cpp", 1, 5, "COLLIDE", 1, 3};
  const MarkedRegion printed{"as_printed/a.cpp", 1, 5, "COLLIDE", 1, 3};
  MarkedRegion part = printed;
  part.last_line = 2;
  CHECK(listing_gaps({meant, printed}, short_one).empty());
  CHECK(listing_gaps({meant, part}, short_one) ==
        Complaints{"COLLIDE, line 3: not covered as printed"});
  CHECK(listing_gaps({printed}, short_one).size() == 3);
  CHECK(listing_gaps({}, short_one).size() == 6);
}

TEST_CASE("A mark that no listing has is found", "[structure]") {
  const MarkedRegion region{"a.cpp", 1, 5, "COLLIDE", 1, 4};
  CHECK(listing_gaps({region}, {{"COLLIDE", 9, "later"}}).size() == 1);  // pending, but marked
  CHECK(listing_gaps({region}, {}).size() == 1);                         // unknown
  CHECK(listing_gaps({region}, {{"COLLIDE", 3, ""}}).size() == 4);  // one too far, 3 not as printed
}

TEST_CASE("Marks in the source come in pairs and are not nested", "[structure]") {
  Complaints complaints;
  marked_regions(code_in(project_files(), ""), complaints);
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Each listing of the thesis is covered line by line or waits for its chapter",
          "[structure]") {
  Complaints complaints;
  complaints =
      listing_gaps(marked_regions(code_in(project_files(), "src/"), complaints), listings());
  INFO(joined(complaints));
  CHECK(complaints.empty());

  int lines = 0;
  for (const Listing& listing : listings()) lines += listing.lines;
  CHECK(listings().size() == 9);
  CHECK(lines == 151);
}

}  // namespace tumble::structure
