/// \file
/// \brief Wishes: when they are met, and which ones are refused.
#include "tumble/scenes/wish.hpp"

#include "scenes/refusal.hpp"
#include "support/test.hpp"

namespace {

// A box of 1 x 2 x 4 m, and what a wish says of it somewhere else.
double missed(const Wish& asked, const Vec3& at_w, const Vec3& turn_deg, const Vec3& velocity_w) {
  Scene scene{.ground = SceneGround{}};
  scene.boxes.push_back(
      {.name = "die", .size = Vec3(1.0, 2.0, 4.0), .position_w = {0.0, 1.0, 0.0}});
  Wish wish = asked;
  wish.bodies = {"die"};
  scene.wishes = {wish};
  World world = build_world(scene);
  const BodyProperties body = world.bodies()[1];
  world.set_state(world.ids()[1],
                  make_state(body, at_w, rotation_from_degrees(turn_deg), velocity_w));
  CHECK(violation(wish, scene, world) == violation(scene, world));
  return violation(scene, world);
}

double missed_at(const Wish& wish, double x) {
  return missed(wish, Vec3(x, 1.0, 0.0), {0, 0, 0}, {0, 0, 0});
}
double missed_turned(const Wish& wish, double angle) {
  return missed(wish, Vec3(0.0, 1.0, 0.0), {0, 0, angle}, {0, 0, 0});
}

std::string refused(const std::string& wishes) {
  return refusal(
      "[ground]\n[[box]]\nname = \"die\"\nsize = [1, 2, 4]\nmass = 1\nposition = [0, 2, 0]\n"
      "[[box]]\nname = \"post\"\nsize = [1, 1, 1]\nfixed = true\nposition = [9, 2, 0]\n" +
      wishes);
}

std::string wish(const std::string& kind, const std::string& rest = "",
                 const std::string& body = "\"die\"") {
  return "[[wish]]\nkind = \"" + kind + "\"\nbody = " + body + "\n" + rest + "\n";
}

}  // namespace

TEST_CASE("Each kind of wish is met on one side of its limit and not on the other",
          "[unit][scenes][sampling]") {
  const Wish in{.kind = WishKind::ends_in, .low_w = {1.0, 0.0, -1.0}, .high_w = {2.0, 2.0, 1.0}};
  CHECK(missed_at(in, 0.99) > 0.0);
  CHECK(missed_at(in, 1.0) == 0.0);
  CHECK(missed_at(in, 2.0) == 0.0);
  CHECK(missed_at(in, 6.0) == Approx(0.5));  // a longest edge away

  const Wish moves{.kind = WishKind::moves, .distance = 2.0};
  CHECK(missed_at(moves, 1.5) == Approx(0.25));
  CHECK(missed_at(moves, -2.0) == 0.0);
  CHECK(missed_at({.kind = WishKind::moves}, 3.99) > 0.0);  // the longest edge
  CHECK(missed_at({.kind = WishKind::moves}, 4.0) == 0.0);
  const Wish stays{.kind = WishKind::stays, .distance = 2.0};
  CHECK(missed_at(stays, 2.0) == 0.0);
  CHECK(missed_at(stays, 8.0) == Approx(0.75));
  CHECK(missed_at({.kind = WishKind::stays}, 0.25) == 0.0);  // a quarter of the shortest edge
  CHECK(missed_at({.kind = WishKind::stays}, 0.26) > 0.0);

  for (const double limit : {45.0, 120.0}) {
    const Wish topples{.kind = WishKind::topples, .angle_deg = limit};
    const Wish stands{.kind = WishKind::stands, .angle_deg = limit};
    CHECK(missed_turned(topples, limit + 0.1) == 0.0);
    CHECK(missed_turned(topples, limit - 0.1) > 0.0);
    CHECK(missed_turned(topples, 0.0) == Approx(1.0));
    CHECK(missed_turned(stands, limit - 0.1) == 0.0);
    CHECK(missed_turned(stands, limit + 0.1) > 0.0);
    CHECK(missed_turned(stands, 180.0) == Approx(1.0));
  }

  // Turned by 90 degrees about z, the x axis of the body is up.
  for (int face = 0; face < 6; ++face) {
    const Wish up{.kind = WishKind::face_up, .face = face};
    CHECK((missed_turned(up, 90.0) == 0.0) == (face == 0));
    CHECK((missed_turned(up, 0.0) == 0.0) == (face == 2));
  }
  const Wish up{.kind = WishKind::face_up, .face = 2};
  CHECK(missed_turned(up, 7.0) == 0.0);
  CHECK(missed_turned(up, 9.0) > 0.0);
  CHECK(missed_turned(up, 180.0) == Approx(1.0));
  CHECK(missed(up, Vec3(0.0, 1.0, 0.0), {0, 0, 0}, Vec3(0.1, 0.0, 0.0)) == 0.0);
  CHECK(missed(up, Vec3(0.0, 1.0, 0.0), {0, 0, 0}, Vec3(0.2, 0.0, 0.0)) > 0.0);
}

TEST_CASE("A body that is not there adds one to what is missed", "[unit][scenes][sampling]") {
  Scene scene;
  scene.boxes.push_back({.name = "a"});
  scene.wishes = {{.kind = WishKind::stays, .bodies = {"a"}}};
  CHECK(violation(scene, World()) == 1.0);
}

TEST_CASE("Wishes are read from a scene file and written back", "[unit][scenes][sampling]") {
  const std::string text =
      kBox + wish("face_up", "face = \"-z\"", "\"box1\"") +
      wish("ends_in", "low = [0, 0.5, 0]\nhigh = [1, 2, 1]", "[\"box1\"]") +
      wish("topples", "angle = 30", "\"box1\"") + wish("stands", "angle = 170", "\"box1\"") +
      wish("moves", "distance = 0.1", "\"box1\"") + wish("stays", "distance = 7.5", "\"box1\"");
  const Scene scene = parse_scene(text, "my.toml");
  REQUIRE(scene.wishes.size() == 6);
  CHECK(scene.wishes[0].face == 5);
  CHECK(scene.wishes[1].high_w == Vec3(1.0, 2.0, 1.0));
  CHECK(scene.wishes[2].angle_deg == 30.0);
  CHECK(scene.wishes[5].distance == 7.5);
  CHECK(scene.wishes[5].bodies == std::vector<std::string>{"box1"});
  CHECK(to_toml(parse_scene(to_toml(scene), "again.toml")) == to_toml(scene));
}

TEST_CASE("A wish that cannot come true is refused with its line, the value and the remedy",
          "[unit][scenes][sampling]") {
  const std::string region = "low = [0, 0, 0]\nhigh = [1, 2, 1]";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {wish("stay"),
       "my.toml:13: wish[1].kind = \"stay\": did you mean stays? Expected one of: face_up"},
      {"[[wish]]\nbody = \"die\"\n", "wish[1].kind: missing"},
      {"[[wish]]\nkind = \"stays\"\n", "wish[1].body: missing: the name of a box"},
      {wish("stays", "", "[]"), "wish[1].body = []: expected a text in quotes"},
      {wish("stays", "", "[\"die\", 3]"), "expected texts in quotes in the list"},
      {wish("stays", "", "\"dye\""),
       "my.toml:14: wish[1].body = dye: there is no such box; did you mean die?"},
      {wish("stays", "", "\"ground\""), "wish[1].body = ground: there is no such box"},
      {wish("stays", "face = \"+x\""), "wish[1].face = \"+x\": unknown key"},
      {wish("stays", "distance = 0"), "wish[1].distance = 0: expected a number above 0 m"},
      {wish("face_up"), "wish[1].face: missing"},
      {wish("face_up", "face = \"+w\""),
       "wish[1].face = \"+w\": did you mean +x? Expected one of: +x, -x, +y"},
      {wish("face_up", "face = 6"), "wish[1].face = 6: expected a text in quotes"},
      {wish("ends_in", "low = [0, 0, 0]"), "wish[1].high: missing: [x, y, z] in m"},
      {wish("ends_in", "low = [0, 3, 0]\nhigh = [1, 2, 1]"),
       "my.toml:16: wish[1].high = [1, 2, 1]: the region is empty, since low = [0, 3, 0]"},
      {wish("ends_in", "low = [0, -3, 0]\nhigh = [1, 0.4, 1]"),
       "the centre of die is never lower than 0.5 m"},
      {wish("topples", "angle = 180"),
       "wish[1].angle = 180: expected degrees above 0 and below 180"},
      {wish("topples", "", "\"post\""),
       "wish[1].body = post: it is fixed and never moves: give it a mass"},
      {wish("moves", "", "[\"die\", \"post\"]"), "wish[1].body = post: it is fixed"},
      {wish("topples") + wish("stands"),
       "wish[2].kind = stands: contradicts wish[1]: die cannot rotate by 45 degrees"},
      {wish("stands") + wish("topples"), "wish[2].kind = topples: contradicts wish[1]"},
      {wish("moves") + wish("stays"),
       "contradicts wish[1]: die cannot move by 4 m or more and by at most 0.25 m"},
      {wish("face_up", "face = \"+x\"") + wish("face_up", "face = \"-x\""),
       "only one face of die can be up"},
      {wish("ends_in", region) + wish("ends_in", "low = [2, 0, 0]\nhigh = [3, 2, 1]"),
       "no point in common"},
      {wish("stays") + wish("ends_in", "low = [2, 0, 0]\nhigh = [3, 2, 1]"),
       "die begins 2 m from the region"},
      {"wish = 3\n", "wish = 3: expected [[wish]] tables"}};
  for (const auto& [text, message] : cases) {
    const std::string said = text[0] == 'w' ? refusal(text + kBox) : refused(text);
    INFO(text << said);
    CHECK(said.find(message) != std::string::npos);
    CHECK(said.find('\n') == std::string::npos);
  }
  // These can come true together.
  for (const std::string& text :
       {wish("topples", "angle = 20") + wish("stands", "angle = 60"),
        wish("moves", "distance = 1") + wish("stays", "distance = 2"),
        wish("ends_in", region) + wish("ends_in", "low = [1, 0, 0]\nhigh = [3, 2, 1]"),
        wish("face_up", "face = \"+x\"") + wish("face_up", "face = \"+x\"")})
    CHECK(refused(text).empty());
  Scene scene;
  scene.boxes.push_back({.name = "a"});
  scene.wishes = {{.kind = WishKind::stays, .bodies = {"a"}, .distance = -1.0}};
  CHECK_THROWS_AS(checked(scene), SceneMistake);
}

TEST_CASE("A box that is taken away before the first step takes its wishes with it",
          "[unit][scenes][sampling]") {
  Scene scene;
  scene.boxes = {{.name = "a"}, {.name = "b", .position_w = {5.0, 0.0, 0.0}}};
  scene.wishes = {{.kind = WishKind::stays, .bodies = {"a"}},
                  {.kind = WishKind::stands, .bodies = {"a", "b"}}};
  Simulation simulation(scene);
  simulation.take_away("a");
  REQUIRE(simulation.scene().wishes.size() == 1);
  CHECK(simulation.scene().wishes[0].bodies == std::vector<std::string>{"b"});
}
