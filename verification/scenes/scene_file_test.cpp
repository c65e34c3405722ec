/// \file
/// \brief Scene files: reading, refusals and their messages; texts that the TOML library does not survive.
#include "tumble/scenes/scene_file.hpp"

#include "scenes/refusal.hpp"
#include "support/files.hpp"
#include "support/test.hpp"

#include <filesystem>
#include <fstream>

namespace {

using tumble::test::kBox, tumble::test::refusal;

bool same_bits(const Scene& a, const Scene& b) {
  return build_world(a).hash().value() == build_world(b).hash().value();
}

}  // namespace

TEST_CASE("A scene file with every key is read as written", "[unit][scenes]") {
  const Scene scene = parse_scene(R"(
title = "all keys"
gravity = [0.0, -1.62, 0.0]
[ground]
friction = 0.25
restitution = 0.5
[[box]]
name = "die"
size = [1.0, 2.0, 3.0]
mass = 4.0
position = [0.0, 3.0, 0.5]
orientation = [0.6, 0.0, 0.8, 0.0]
velocity = [1.0, 0.0, -1.0]
angular_velocity = [0.5, 0.25, 0.125]
friction = 0.75
restitution = 0.125
appears = 1.5
disappears = 2.25
[[box]]
fixed = true
size = [1, 1, 1]
position = [9, 1, 0]
rotation_deg = [0, 90, 0]
)",
                                  "my.toml");
  CHECK(scene.title == "all keys");
  CHECK(scene.gravity_w == Vec3(0.0, -1.62, 0.0));
  REQUIRE(scene.ground.has_value());
  CHECK(scene.ground->friction == 0.25);
  CHECK(scene.ground->restitution == 0.5);
  REQUIRE(scene.boxes.size() == 2);
  const SceneBox& die = scene.boxes[0];
  CHECK(die.name == "die");
  CHECK(die.size == Vec3(1.0, 2.0, 3.0));
  CHECK(die.mass == 4.0);
  CHECK(die.position_w == Vec3(0.0, 3.0, 0.5));
  CHECK(die.orientation_wb.w() == 0.6);
  CHECK(die.orientation_wb.y() == 0.8);
  CHECK(die.velocity_w == Vec3(1.0, 0.0, -1.0));
  CHECK(die.angular_velocity_w == Vec3(0.5, 0.25, 0.125));
  CHECK(die.friction == 0.75);
  CHECK(die.restitution == 0.125);
  CHECK(die.appears == 1.5);
  CHECK(die.disappears == 2.25);
  const SceneBox& block = scene.boxes[1];
  CHECK(block.name == "box2");  // the default name
  CHECK(block.fixed);
  CHECK(block.appears == 0.0);
  CHECK(block.disappears == HUGE_VAL);  // never
  CHECK(block.orientation_wb.y() == near(std::sqrt(0.5)).epsilon(1e-15));
}

TEST_CASE("A mistake in a scene file is reported with file, line, key, value and remedy",
          "[unit][scenes]") {
  struct Case {
    std::string text;
    std::vector<std::string> message;
  };
  const std::vector<Case> cases = {
      {"", {"my.toml", "at least one [[box]]"}},
      {"[[box]]\nmass = 1\nposition = [0,1,0]\n", {"my.toml:1", "box[1].size", "missing"}},
      {"[[box]]\nsize = [1,1,1]\nmass = 1\n", {"my.toml:1", "box[1].position", "missing"}},
      {"[[box]]\nsize = [1,1,1]\nposition = [0,1,0]\n", {"box[1].mass", "fixed = true"}},
      {"[[box]]\nsize = [1,0,1]\nmass = 1\nposition = [0,1,0]\n",
       {"my.toml:2", "box[1].size", "0", "above 0 m"}},
      {"[[box]]\nsize = [1,1]\nmass = 1\nposition = [0,1,0]\n", {"my.toml:2", "3 finite numbers"}},
      {"[[box]]\nsize = [1,1,1]\nmass = -2.5\nposition = [0,1,0]\n",
       {"my.toml:3", "box[1].mass = -2.5", "above 0 kg"}},
      {"[[box]]\nsize = [1,1,1]\nmass = nan\nposition = [0,1,0]\n",
       {"my.toml:3", "box[1].mass = nan", "finite"}},
      {"[[box]]\nsize = [1,1,1]\nmass = 1\nposition = [0,inf,0]\n", {"my.toml:4", "position"}},
      {"[[box]]\nsize = [1,1,1]\nmass = \"heavy\"\nposition = [0,1,0]\n",
       {"my.toml:3", "box[1].mass", "heavy", "number"}},
      {kBox + "colour = \"red\"\n", {"my.toml:5", "colour", "unknown key", "angular_velocity"}},
      {"gravitiy = [0,0,0]\n" + kBox, {"my.toml:1", "gravitiy", "gravity"}},
      {kBox + "orientation = [1, 1, 0, 0]\n", {"my.toml:5", "orientation", "length 1"}},
      {kBox + "orientation = [1,0,0,0]\nrotation_deg = [1,2,3]\n", {"not both"}},
      {kBox + "restitution = 1.5\n", {"my.toml:5", "1.5", "from 0 to 1"}},
      {kBox + "friction = -0.5\n", {"my.toml:5", "-0.5", "0 or above"}},
      {kBox + "appears = -1\n", {"appears", "0 s or later"}},
      {kBox + "disappears = 0\n",
       {"my.toml:5: box[1].disappears = 0", "expected later than 0 s, when it appears"}},
      {kBox + "disappears = -2.5\n", {"my.toml:5: box[1].disappears = -2.5", "later than 0 s"}},
      {kBox + "disappears = 1.5\nappears = 1.5\n",
       {"my.toml:5: box[1].disappears = 1.5", "expected later than 1.5 s, when it appears"}},
      {kBox + "disappears = inf\n", {"my.toml:5: box[1].disappears = inf", "finite number"}},
      {kBox + "disappears = nan\n", {"my.toml:5: box[1].disappears = nan", "finite number"}},
      {kBox + "disappears = \"soon\"\n", {"my.toml:5: box[1].disappears", "soon", "number"}},
      {kBox + "dissappears = 2\n", {"my.toml:5: box[1].dissappears", "did you mean disappears?"}},
      {"[[box]]\nsize = [1,1,1]\nmass = 1e10\nposition = [0,1,0]\nvelocity = [0,0,1e300]\n",
       {"my.toml:5: box[1], box1", "velocity = [0, 0, 1e+300]",
        "expected at most 299792458 m/s, the speed of light: make it slower"}},
      {kBox + "fixed = true\n", {"box[1].mass", "a fixed box has none"}},
      {"[[box]]\nfixed = true\nsize=[1,1,1]\nposition=[0,1,0]\nvelocity=[1,0,0]\n",
       {"cannot move"}},
      {kBox + kBox,
       {"my.toml:8: box[2].position = [0, 2, 0]", "box2 and box1", "overlap by 1 m",
        "move them apart"}},
      {"[ground]\n" + std::string("[[box]]\nsize=[1,1,1]\nmass=1\nposition=[0,0.25,0]\n"),
       {"my.toml:5: box[1].position = [0, 0.25, 0]", "the ground", "overlap by 0.25 m"}},
      {kBox + "name = \"a\"\n[[box]]\nname=\"a\"\nsize=[1,1,1]\nmass=1\nposition=[5,1,0]\n",
       {"my.toml:7: box[2].name = a", "two boxes"}},
      {"[ground]\n" + kBox + "name = \"ground\"\n",
       {"my.toml:6: box[1].name = ground", "the ground has this name"}},
      {kBox + "name = \"a\\nb\"\n", {"my.toml:5", "control character"}},
      {"[[box]]\nsize = [1,1,1]\nmass = 1e-320\nposition = [0,1,0]\n",
       {"my.toml:1: box[1], box1", "mass = 1e-320: expected a number from 1e-30 to 1e+30"}},
      {kBox + "[[box]]\nname = \"sun\"\nsize=[1,1,1]\nmass=2e10\nposition=[5,1,0]\nappears = 3\n",
       {"my.toml:5: box[2], sun",
        "\"sun\" (2e+10 kg) is more than 1e+10 times as heavy as \"box1\" (1 kg)", "a fixed box"}},
      {kBox + "frction = 0.5\n", {"my.toml:5: box[1].frction", "did you mean friction?"}},
      {"[gruond]\n" + kBox, {"my.toml:1: gruond", "did you mean ground?"}},
      {kBox + "[box.x]\n", {"my.toml", "box[1].x = a table", "unknown key"}},
      {kBox + "orientation = [0, 0, 0, 0]\n", {"my.toml:5", "this has length 0"}},
      {kBox + "orientation = [nan, 0, 0, 0]\n", {"my.toml:5", "4 finite numbers"}},
      {kBox + "rotation_deg = [0, inf, 0]\n", {"my.toml:5", "3 finite numbers"}},
      {kBox + "fixed = \"yes\"\n", {"my.toml:5", "true or false"}},
      {kBox + "friction = true\n", {"my.toml:5", "friction = true", "finite number"}},
      {kBox + "mass = 2\n", {"my.toml:5", "not TOML"}},  // a key twice
      {kBox + "title = \"here it belongs to the box\"\n", {"my.toml:5: box[1].title"}},
      {"box = []\n", {"my.toml:1", "at least one [[box]]"}},
      {"box = [1, 2]\n", {"my.toml:1", "expected [[box]] tables"}},
      {"gravity = -9.81\n" + kBox, {"my.toml:1: gravity = -9.81", "3 finite numbers"}},
      {"gravity = [0, 1e400, 0]\n" + kBox, {"my.toml:1"}},
      {std::string(2000, '['), {"my.toml:1", "not TOML"}},
      {"x = " + std::string(100000, '[') + "\n", {"my.toml:1", "not TOML"}},
      {std::string("title = \"a\0b\"\n", 14) + kBox, {"my.toml:1", "not TOML"}},
      {"title = 3\n" + kBox, {"my.toml:1", "title = 3", "text in quotes"}},
      {"ground = 3\n" + kBox, {"my.toml:1", "[ground]"}},
      {"box = 3\n", {"my.toml:1", "[[box]]"}},
      {"[[box]\n", {"my.toml:1", "not TOML"}},
      {std::string(1000, '\x01'), {"my.toml:1", "not TOML"}},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    const std::string message = refusal(c.text);
    INFO("refused with: " << message);
    CHECK(!message.empty());
    CHECK(message.size() < 400);
    CHECK(message.find('\n') == std::string::npos);
    for (const std::string& part : c.message) {
      INFO("expected in the message: " << part);
      CHECK(message.find(part) != std::string::npos);
    }
  }
}

TEST_CASE("Ten megabytes of garbage are refused with one message", "[unit][scenes]") {
  std::string garbage(10 << 20, 'x');
  Random random(7);
  for (std::size_t i = 0; i < garbage.size(); i += 997)
    garbage[i] = static_cast<char>(random.below(256));
  const std::string message = refusal(garbage);
  CHECK(message.find("not TOML") != std::string::npos);
  CHECK(message.size() < 1000);
}

TEST_CASE("A long value in a scene file makes no long message", "[unit][scenes]") {
  const std::string message = refusal("title = [" + std::string(1 << 20, ' ') + "1]\n" + kBox);
  CHECK(message.find("text in quotes") != std::string::npos);
  CHECK(message.size() < 400);
  CHECK(refusal("gravity = \"" + std::string(1 << 20, 'g') + "\"\n" + kBox).size() < 400);
  CHECK(refusal(std::string(1 << 20, 'k') + " = 1\n" + kBox).size() < 400);
}

TEST_CASE("A file that is no scene file is refused by its name", "[unit][scenes]") {
  namespace fs = std::filesystem;
  const auto refused = [](const fs::path& path) {
    return refusal_of([&] { (void)read_scene(path); });
  };
  const test::Folder scratch("scene_files");
  const fs::path& folder = scratch.path;
  fs::create_directories(folder / "folder.toml");
  std::ofstream(folder / "empty.toml").close();
  std::ofstream(folder / "good.toml") << kBox;
  CHECK(refused(folder / "good.toml").empty());
  CHECK(refused(folder / "folder.toml").find("is a folder") != std::string::npos);
  CHECK(refused(folder / "empty.toml").find("empty.toml:1: box: a scene needs") !=
        std::string::npos);
  CHECK(refused(folder / "none.toml").find("no such file") != std::string::npos);
  if (fs::exists("/dev/zero"))  // never ends
    CHECK(refused("/dev/zero").find("at most 64 MiB") != std::string::npos);
}

TEST_CASE("A box without a name gets a number that is free", "[unit][scenes]") {
  const Scene scene = parse_scene(
      "[[box]]\nname=\"box2\"\nsize=[1,1,1]\nmass=1\nposition=[0,1,0]\n"
      "[[box]]\nsize=[1,1,1]\nmass=1\nposition=[5,1,0]\n"
      "[[box]]\nsize=[1,1,1]\nmass=1\nposition=[9,1,0]\n",
      "my.toml");
  CHECK(scene.boxes[0].name == "box2");
  CHECK(scene.boxes[1].name == "box3");
  CHECK(scene.boxes[2].name == "box4");
}

TEST_CASE("Boxes may overlap a little at the start, as typed numbers do", "[unit][scenes]") {
  const std::string upper = "[[box]]\nsize=[1,1,1]\nmass=1\nposition=[0,2.9995,0]\n";
  CHECK(refusal(kBox + upper).empty());  // 0.5 mm of 1 m; 1 mm is accepted
  const std::string deeper = "[[box]]\nsize=[1,1,1]\nmass=1\nposition=[0,2.9985,0]\n";
  CHECK(!refusal(kBox + deeper).empty());
  const std::string later = "[[box]]\nsize=[1,1,1]\nmass=1\nposition=[0,2,0]\nappears=1\n";
  CHECK(refusal(kBox + later).empty());  // is not there at the start
  const std::string fixed = "[[box]]\nfixed=true\nsize=[1,1,1]\nposition=[0,2,0]\n";
  CHECK(refusal(fixed + fixed).empty());  // of two that cannot move it does not matter
  CHECK(!refusal(kBox + fixed).empty());
}

TEST_CASE("A scene that is written and read again has the same bits", "[unit][scenes]") {
  for (const SceneRecipe& recipe : scene_library()) {
    INFO(recipe.name);
    const Scene scene = checked(recipe.build(recipe.parameters(), Random(5)));
    const Scene again = parse_scene(to_toml(scene), "again.toml");
    CHECK(same_bits(scene, again));
    CHECK(to_toml(again) == to_toml(scene));
  }
  Scene odd = parse_scene(kBox, "my.toml");
  odd.title = "quotes \" and \\ and a tab\t and umlauts äöü";
  CHECK(parse_scene(to_toml(odd), "odd.toml").title == odd.title);
}

TEST_CASE("A time at which a box comes or goes is written only if it has one, and to the last bit",
          "[unit][scenes]") {
  Scene scene = parse_scene(kBox, "my.toml");
  CHECK(to_toml(scene).find("appears") == std::string::npos);
  scene.boxes[0].disappears = 1.0 / 3.0;
  CHECK(to_toml(scene).find("\ndisappears = 0.3333333333333333\n") != std::string::npos);
  CHECK(to_toml(scene).find("\nappears") == std::string::npos);
  scene.boxes[0].appears = std::nextafter(1.0 / 3.0, 0.0);
  const Scene again = parse_scene(to_toml(scene), "again.toml");
  CHECK(again.boxes[0].appears == scene.boxes[0].appears);
  CHECK(again.boxes[0].disappears == scene.boxes[0].disappears);
  scene.boxes[0].disappears = 2.0;  // a float in TOML too
  CHECK(to_toml(scene).find("\ndisappears = 2.0\n") != std::string::npos);
}

TEST_CASE("A key with very many dots, which the TOML library does not survive, is refused",
          "[unit][scenes]") {
  std::string dots = "a";
  for (int k = 0; k < 300000; ++k) dots += k % 2 == 0 ? ".a" : ". \"a\"";
  for (const std::string& text : {dots + " = 1", "[" + dots + "]", "[[" + dots + "]]",
                                  "x = {" + dots + " = 1}", "x = [" + dots + "]"})
    CHECK_THAT(refusal(kBox + "\n" + text + "\n"), Contains("dots"));
  CHECK(refusal("title = \"a.b" + dots + "\"\n" + std::string(kBox)).find("dots") ==
        std::string::npos);
  CHECK(parse_scene("# " + dots + "\n" + std::string(kBox), "my.toml").boxes.size() == 1);
}

TEST_CASE("A letter that is not ASCII may stand in quotes and comments alone", "[unit][scenes]") {
  for (const char* text : {"größe = 1\n", "[größe]\n", "x = ö\n", "x.ö = 1\n"})
    CHECK_THAT(refusal(kBox + std::string("\n") + text), Contains("ASCII"));
  CHECK(parse_scene("title = \"größe ' = ö\" # größe\n" + std::string(kBox), "my.toml").title ==
        "größe ' = ö");
}

TEST_CASE("A quote in a number hides no letter from the check before the TOML library",
          "[unit][scenes]") {
  // U+FEFC and U+FEFF; the library looks through what begins like a number to its end, whatever is in it.
  for (const std::string letter :
       {"\xEF\xBB\xBC", "\xEF\xBB\xBF", "ö", "\xC2\x85", "\xF0\x9F\x98\x80"}) {
    for (const char* before : {"x = 0\"", "x = 1.\"", "x = -'", "x = 1[\"", "x = 1=\"", "x = [1{'",
                               "x = 1\"\"\"", "x = +1\"\"\"\n"})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter),
                 Contains("a number has a quote in it"));
    // Strings that end later than they seem to.
    for (const char* before : {"x = \"\"\"a\"\"\"\", 1", "x = ['''a''''', 1", "x = \"\\\\\", 1"})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter), Contains("ASCII"));
    for (const char* before : {"x = \"\\", "x = \"\"\"\\", "x = \"\"\"a\\ \r\n\n\t "})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter),
                 Contains("follows a backslash"));
    CHECK(parse_scene("title = \"\"\"1\"" + letter + "\"\"\"\"\"\n" + kBox, "my.toml").title ==
          "1\"" + letter + "\"\"");
  }
}
