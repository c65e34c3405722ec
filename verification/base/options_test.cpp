/// \file
/// \brief Options described once: declared, checked and read back; lists of errata; guesses about mistyped names.
#include "tumble/base/options.hpp"

#include "tumble/base/errata_set.hpp"
#include "tumble/base/suggestion.hpp"

#include "support/test.hpp"

namespace {

enum class Colour { red, green, blue };

struct PaintOptions {
  double thickness = 0.25;
  int coats = 2;
  bool glossy = true;
  Colour colour = Colour::green;
  std::string label = "none";
};

template <class Visitor>
void describe(PaintOptions& o, Visitor& v) {
  v.number("thickness", o.thickness, 0.0, 1.0, "m", "thickness of a coat");
  v.whole("coats", o.coats, 1, 9, "number of coats");
  v.flag("glossy", o.glossy, "whether it shines");
  v.word("colour", o.colour,
         {{"red", Colour::red}, {"green", Colour::green}, {"blue", Colour::blue}}, "its colour");
  v.text("label", o.label, "text on the tin");
}

const ErrataList& known_here() {
  static const ErrataList list(std::array<ErrataGroup, 3>{{{"C", 12}, {"RK", 4}, {"D", 2}}});
  return list;
}

using Set = ErrataSetOf<known_here>;

constexpr std::array<std::string_view, 4> kKnown = {"gravity", "ground", "pyramid", "pyramid3d"};

}  // namespace

TEST_CASE("Options are declared with the struct's values as defaults, the default word first",
          "[unit][parameters]") {
  const Parameters p = declared_options<PaintOptions>();
  REQUIRE(p.all().size() == 5);
  CHECK(p.all()[0].key == "thickness");
  CHECK(p.all()[0].unit == "m");
  CHECK(p.all()[0].meaning == "thickness of a coat");
  CHECK(p.number("thickness") == 0.25);
  CHECK(p.count("coats") == 2);
  CHECK(p.flag("glossy"));
  CHECK(p.all()[3].choices == std::vector<std::string>{"green", "red", "blue"});
  CHECK(p.text("label") == "none");
}

TEST_CASE("Options that a user changes arrive in the struct, each word as its value",
          "[unit][parameters]") {
  Parameters p = declared_options<PaintOptions>();
  for (const char* setting : {"thickness=0.5", "coats=3", "glossy=off", "label=tin=1"})
    p.assign(setting);
  const auto read = read_options<PaintOptions>(p);
  CHECK(read.thickness == 0.5);
  CHECK(read.coats == 3);
  CHECK_FALSE(read.glossy);
  CHECK(read.colour == Colour::green);
  CHECK(read.label == "tin=1");
  p.set("colour", "blue");
  CHECK(read_options<PaintOptions>(p).colour == Colour::blue);
  p.set("colour", "red");
  CHECK(read_options<PaintOptions>(p).colour == Colour::red);

  CHECK_THROWS_WITH(p.assign("coats"), "tumble: coats: expected key=value");
  CHECK_THROWS_WITH(p.assign("coats=10"), Contains("expected a whole number from 1 to 9"));
  CHECK_THROWS_WITH(p.set("colour", "pink"), Contains("expected one of: green, red, blue"));
  CHECK_THROWS_WITH(p.set("color", "red"), Contains("did you mean colour?"));
}

TEST_CASE("A list of errata holds what it names and nothing else", "[unit][base]") {
  const Set set(" C1, D2,RK1 ,C1");
  CHECK(set.text() == "C1,RK1,D2");
  for (const std::string& id : Set::known())
    CHECK(set.has(id) == (id == "C1" || id == "RK1" || id == "D2"));
  CHECK(Set(set.text()) == set);
  CHECK(Set("").text() == "none");
  CHECK(Set("none") == Set());
  CHECK(Set("all") == Set::all());
  CHECK(Set::all().without("D2").with("D2") == Set::all());
  CHECK_FALSE(Set::all().without("C10").has("C10"));
  CHECK(Set::all().without("C10").has("C1"));
}

TEST_CASE("Ids of errata are numbered in the order of their groups", "[unit][base]") {
  CHECK(Set::known().size() == 18);
  CHECK(Set::known().front() == "C1");
  CHECK(Set::known().back() == "D2");
}

TEST_CASE("An unknown erratum is refused with the known ones", "[unit][base]") {
  for (const char* list : {"C13", "C0", "c1", "C1,,C2", "C1,", ",", "C1 C2", "none,C1", "all,C1"}) {
    INFO(list);
    CHECK_THROWS_AS(Set(list), std::invalid_argument);
  }
  CHECK_THROWS_AS(Set().has("T1"), std::invalid_argument);
  CHECK_THROWS_AS(Set().with(""), std::invalid_argument);
  CHECK_THROWS_WITH(
      Set("C1,Q7"),
      "tumble: erratum 'Q7': expected C1 to C12, RK1 to RK4 or D1 to D2, or none, or all");
}

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
