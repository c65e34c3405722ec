/// \file
/// \brief Options described once: declared, checked and read back.
#include "tumble/base/options.hpp"

#include "support/test.hpp"

namespace {

using namespace tumble;

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
