/// \file
/// \brief Guesses about mistyped names.
#include "tumble/base/suggestion.hpp"

#include "support/test.hpp"

namespace {

using namespace tumble;

constexpr std::array<std::string_view, 4> kKnown = {"gravity", "ground", "pyramid", "pyramid3d"};

}  // namespace

TEST_CASE("A mistyped name is guessed from one letter too many, missing, wrong or swapped",
          "[unit][suggestion]") {
  CHECK(closest_name("gravitiy", kKnown) == "gravity");
  CHECK(closest_name("gavity", kKnown) == "gravity");
  CHECK(closest_name("grovity", kKnown) == "gravity");
  CHECK(closest_name("rgavity", kKnown) == "gravity");  // a swap is one change: 1 of 7 letters
  CHECK(closest_name("gorund", kKnown) == "ground");
  CHECK(closest_name("piramid", kKnown) == "pyramid");
  CHECK(closest_name("pyramid3", kKnown) == "pyramid");  // as near as pyramid3d, and earlier
  CHECK(closest_name("ground", kKnown) == "ground");
}

TEST_CASE("A mistyped beginning of a name is guessed", "[unit][suggestion]") {
  constexpr std::array<std::string_view, 3> known = {"basic", "contact_damped", "timewarp_simple"};
  CHECK(closest_name("contct", known) == "contact_damped");
  CHECK(closest_name("timewarp", known) == "timewarp_simple");
  CHECK(closest_name("timwrap", known).empty());  // two changes of seven letters
  CHECK(closest_name("con", known).empty());      // too short
}

TEST_CASE("A name that is like none of the known ones is not guessed", "[unit][suggestion]") {
  CHECK(closest_name("colour", kKnown).empty());
  CHECK(closest_name("", kKnown).empty());
  CHECK(closest_name("x", kKnown).empty());
  CHECK(closest_name(std::string(100000, 'g'), kKnown).empty());
  CHECK(closest_name("gravity", {}).empty());
}

TEST_CASE("A message about an unknown name has the guess and all names", "[unit][suggestion]") {
  CHECK(expected_names("groun", kKnown) ==
        "did you mean ground? Expected one of: gravity, ground, pyramid, pyramid3d");
  CHECK(expected_names("colour", kKnown) == "expected one of: gravity, ground, pyramid, pyramid3d");
}
