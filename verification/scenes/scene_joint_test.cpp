/// \file
/// \brief Joints of scene files: reading, writing, refusals, and techniques that know none.

#include "scenes/refusal.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

// A fixed box, one that hangs below it, and one that comes later; then the tables that follow.
std::string hung(const std::string& more) {
  return "[[box]]\nname = \"hook\"\nfixed = true\nsize = [1, 1, 1]\nposition = [0, 4, 0]\n"  // 1
         "[[box]]\nname = \"lamp\"\nmass = 2\nsize = [1, 1, 1]\nposition = [0, 3, 0]\n"      // 6
         "[[box]]\nname = \"late\"\nmass = 2\nsize = [1, 1, 1]\nposition = [5, 3, 0]\n"      // 11
         "appears = 1\n" +                                                                   // 16
         more;                                                                               // 17
}

std::string joint(const std::string& keys) { return hung("[[joint]]\n" + keys); }

const std::string kAnchor = "anchor = [0, 3.5, 0]\n";
const std::string kBodies = "first = \"hook\"\nsecond = \"lamp\"\n";

}  // namespace

TEST_CASE("Joints of a scene file are read, and written so that they read back", "[unit][joints]") {
  const Scene scene = parse_scene(
      joint("name = \"upper\"\nkind = \"hinge\"\n" + kBodies + kAnchor + "axis = [0, 0, 2]\n") +
          "[[joint]]\nkind = \"ball\"\nfirst = \"lamp\"\nsecond = \"hook\"\nanchor = [0.5, 3.5, "
          "0]\n",
      "my.toml");
  REQUIRE(scene.joints.size() == 2);
  CHECK(scene.joints[0].name == "upper");
  CHECK(scene.joints[0].kind == JointKind::hinge);
  CHECK(scene.joints[0].first == "hook");
  CHECK(scene.joints[0].second == "lamp");
  CHECK(scene.joints[0].anchor_w == Vec3(0.0, 3.5, 0.0));
  CHECK(scene.joints[0].axis_w == Vec3(0.0, 0.0, 2.0));
  CHECK(scene.joints[1].name == "joint2");
  const std::string text = to_toml(scene);
  CHECK(to_toml(parse_scene(text, "again.toml")) == text);
  const World world = build_world(scene);
  REQUIRE(world.joints().size() == 2);
  CHECK(world.joints()[0].axes_b[1] == Vec3::UnitZ());
  CHECK(world.joints()[1].bodies[0] == *world.find("hook"));  // the smaller id
  CHECK(world.joined(*world.find("lamp"), *world.find("hook")));
}

TEST_CASE("A joint that is wrong is refused with its line, the value and what would be right",
          "[unit][joints]") {
  const auto check = [](const std::string& keys, const std::string& message) {
    CHECK(refusal(joint(keys)) == message);
  };
  const std::string ball = "kind = \"ball\"\n";
  check(kBodies + kAnchor,
        "my.toml:17: joint[1].kind: missing: expected one of: ball, hinge, fixed");
  check("kind = \"hing\"\n" + kBodies + kAnchor,
        "my.toml:18: joint[1].kind = \"hing\": did you mean hinge? Expected one of: ball, hinge, "
        "fixed");
  check(ball + "first = \"hook\"\n" + kAnchor,
        "my.toml:17: joint[1].second: missing: the name of a box, or \"ground\"");
  check(ball + "first = \"hook\"\nsecond = \"lmap\"\n" + kAnchor,
        "my.toml:20: joint[1].second = lmap: no box has this name: did you mean lamp?");
  check(ball + "first = \"ground\"\nsecond = \"lamp\"\n" + kAnchor,
        "my.toml:19: joint[1].first = ground: the scene has none: write a table [ground], or join "
        "a fixed box");
  check(ball + "first = \"hook\"\nsecond = \"late\"\n" + kAnchor,
        "my.toml:20: joint[1].second = late: it appears later: a joint holds boxes that are there "
        "at the start");
  check(ball + "first = \"lamp\"\nsecond = \"lamp\"\n" + kAnchor,
        "my.toml:20: joint[1].second = lamp: the same body twice: name another one");
  check(ball + kBodies,
        "my.toml:17: joint[1].anchor: missing: [x, y, z] in m, the joint's point at "
        "the start");
  check("kind = \"hinge\"\n" + kBodies + kAnchor,
        "my.toml:17: joint[1].axis: missing or 0: a hinge needs the direction of its axis");
  check("kind = \"hinge\"\n" + kBodies + kAnchor + "axis = [0, 0, 0]\n",
        "my.toml:22: joint[1].axis: missing or 0: a hinge needs the direction of its axis");
  check(
      ball + kBodies + kAnchor + "axis = [0, 0, 1]\n",
      "my.toml:22: joint[1].axis: a ball joint has none: leave it out, or write kind = \"hinge\"");
  check(ball + kBodies + "anchor = [0, 3.5]\n",
        "my.toml:21: joint[1].anchor = [0, 3.5]: expected 3 finite numbers in brackets");
  check(ball + kBodies + kAnchor + "limit = 3\n",
        "my.toml:22: joint[1].limit = 3: unknown key; expected one of: name, kind, first, second, "
        "anchor, axis");
  check("name = \"a\"\n" + ball + kBodies + kAnchor + "[[joint]]\nname = \"a\"\n" + ball + kBodies +
            kAnchor,
        "my.toml:24: joint[2].name = a: two joints have this name: choose another one");
  CHECK(refusal("joint = 3\n" + kBox) == "my.toml:1: joint = 3: expected [[joint]] tables");
  const std::string wall =
      "[[box]]\nname = \"wall\"\nfixed = true\nsize = [1, 1, 1]\nposition = [9, 1, 0]\n";
  CHECK(
      refusal(hung(wall + "[[joint]]\nkind = \"fixed\"\nfirst = \"wall\"\nsecond = \"hook\"\n" +
                   kAnchor)) ==
      "my.toml:25: joint[1].second = hook: neither it nor wall can move: give one of them a mass, "
      "or leave the joint out");
}

TEST_CASE("The ground is the world to which a box can be joined, and joined bodies may overlap",
          "[unit][joints]") {
  const std::string in_ground =
      "[ground]\n[[box]]\nname = \"post\"\nmass = 1\nsize = [1, 1, 1]\nposition = [0, 0.2, 0]\n";
  CHECK_THAT(refusal(in_ground), Contains("overlap by 0.3 m"));
  const std::string held = in_ground +
                           "[[joint]]\nkind = \"hinge\"\nfirst = \"ground\"\nsecond = \"post\"\n"
                           "anchor = [0, 0, 0]\naxis = [0, 0, 1]\n";
  CHECK(refusal(held).empty());
  CHECK(parse_scene(held, "my.toml").joints[0].name == "joint1");
}

TEST_CASE("Every technique but glued refuses joints by its own name, with the remedy",
          "[unit][joints]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    INFO(recipe.name);
    Simulation run(built("chain", {{"count", "2"}}), recipe.name);
    if (recipe.name == "glued") {
      CHECK_NOTHROW(run.step());
      continue;
    }
    CHECK_THROWS_WITH(run.step(),
                      "tumble: technique " + std::string(recipe.name) +
                          " does not support joints, and the scene has 2, the first called "
                          "joint1: choose glued (--technique glued --set contacts=collide, so that "
                          "boxes collide), or leave out "
                          "[[joint]]");
    CHECK(run.world().steps() == 0);
  }
}

TEST_CASE("What is taken away takes its joints along, before the first step and after it",
          "[unit][joints]") {
  Simulation early(built("chain", {{"count", "3"}}), "glued");
  early.take_away("link2");
  CHECK(early.scene().joints.size() == 1);
  CHECK(early.world().joints().size() == 1);
  Simulation late(built("chain", {{"count", "3"}}), "glued");
  late.step();
  late.step();
  late.take_away("link2");
  CHECK(late.world().joints().size() == 1);
  CHECK_NOTHROW(late.step());
  CHECK(late.body("link3").velocity_w().y() < 0.0);
  // A run of what is left goes through the same bits.
  Simulation again(late.scene(), "glued");
  for (int k = 0; k < 3; ++k) again.step();
  CHECK(again.world().hash().value() == late.world().hash().value());
}

TEST_CASE("A world refuses a joint that holds nothing or cannot be", "[unit][joints]") {
  World world;
  const BodyId ground = world.add_ground();
  const BodyId a = world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 3.0, 0.0));
  const BodyProperties wall = fixed_box_properties(Vec3::Ones());
  const BodyId w = world.add(wall, Vec3(3.0, 3.0, 0.0));
  const Vec3 at = Vec3(1.0, 3.0, 0.0), axis = Vec3::UnitX();
  CHECK_THROWS_WITH(world.join(JointKind::ball, a, a, at), Contains("with itself"));
  CHECK_THROWS_WITH(world.join(JointKind::ball, ground, w, at),
                    Contains("both bodies are immovable"));
  CHECK_THROWS_WITH(world.join(JointKind::hinge, a, w, at), Contains("axis_w is 0"));
  CHECK_THROWS_WITH(world.join(JointKind::fixed, a, w, at, axis),
                    Contains("a fixed joint has no axis"));
  CHECK_THROWS_WITH(world.join(JointKind::ball, a, BodyId{77}, at), Contains("no body with id 77"));
  CHECK_THROWS_WITH(world.join(JointKind::ball, a, w, Vec3(kNan, 0.0, 0.0)), Contains("anchor_w"));
  CHECK(world.joints().empty());
  world.join(JointKind::hinge, w, a, at, 5.0 * axis, "door");
  CHECK(world.joints()[0].name == "door");
  CHECK(world.joints()[0].axes_b[0] == axis);
  CHECK_FALSE(world.joined(ground, a));
  world.remove(w);
  CHECK(world.joints().empty());
}
