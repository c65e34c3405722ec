/// \file
/// \brief The built-in scenes: all can be built, none begins with overlap, parameters do something.
#include "tumble/scenes/library.hpp"

#include "tumble/base/error.hpp"

#include "support/scenes.hpp"
#include "support/test.hpp"

TEST_CASE("Every built-in scene is accepted with its defaults", "[unit][scenes]") {
  std::set<std::string_view> names;
  for (const SceneRecipe& recipe : scene_library()) {
    INFO(recipe.name);
    CHECK(names.insert(recipe.name).second);
    CHECK(!recipe.summary.empty());
    const Scene scene = checked(recipe.build(recipe.parameters(), Random(1)));
    CHECK(!scene.title.empty());
    CHECK(build_world(scene).count() >= 1);
  }
}

TEST_CASE("Piles have the number of boxes that their names promise", "[unit][scenes]") {
  CHECK(built("stack", {{"count", "10"}}).boxes.size() == 10);
  CHECK(built("pyramid", {{"rows", "10"}}).boxes.size() == 55);
  CHECK(built("pyramid3d", {{"rows", "8"}}).boxes.size() == 204);
  CHECK(built("wall", {}).boxes.size() == 400);
  CHECK(built("clump", {{"per_edge", "5"}}).boxes.size() == 125);
}

TEST_CASE("The seed changes scenes with chance in them and no others", "[unit][scenes]") {
  for (const SceneRecipe& recipe : scene_library()) {
    INFO(recipe.name);
    const auto hash = [&](std::uint64_t seed) {
      return build_world(checked(recipe.build(recipe.parameters(), Random(seed)))).hash().value();
    };
    const bool chance = recipe.name == "clump" || recipe.name == "fig6_7" ||
                        recipe.name == "dice" || recipe.name == "cage" || recipe.name == "toss";
    CHECK((hash(1) != hash(2)) == chance);
    CHECK(hash(3) == hash(3));
  }
}

TEST_CASE("Boxes come and go at their times, and one with no time in between is never there",
          "[unit][scenes]") {
  Scene scene;
  const auto box = [&](const char* name, double appears, double disappears) {
    const auto place = static_cast<double>(2 * scene.boxes.size());
    scene.boxes.push_back(SceneBox{.name = name,
                                   .position_w = Vec3(place, 0.0, 0.0),
                                   .appears = appears,
                                   .disappears = disappears});
  };
  box("stays", 0.0, HUGE_VAL);
  box("goes", 0.0, 1.0);
  box("comes", 1.0, HUGE_VAL);
  box("short", 1.25, 1.75);
  box("between", 1.5, 2.5);
  const auto names = [](const World& world) {
    std::string all;
    for (int i = 0; i < world.count(); ++i) all += (i > 0 ? " " : "") + world.name(i);
    return all;
  };
  World world = build_world(scene);
  CHECK(names(world) == "stays goes");
  update_boxes(scene, 0.0, 0.0, world);
  CHECK(names(world) == "stays goes");
  update_boxes(scene, 0.0, 0.99, world);
  CHECK(names(world) == "stays goes");
  update_boxes(scene, 0.99, 1.0, world);  // at the time itself
  CHECK(names(world) == "stays comes");
  update_boxes(scene, 1.0, 2.0, world);
  CHECK(names(world) == "stays comes between");
  // No body has got the id of the one that was never there.
  CHECK(number_of(world.ids().back()) == 3);
  update_boxes(scene, 2.0, 2.5, world);
  CHECK(names(world) == "stays comes");
  update_boxes(scene, 2.5, 99.0, world);
  CHECK(names(world) == "stays comes");

  // All of it within one step: a body that goes does so before another one comes.
  World coarse = build_world(scene);
  update_boxes(scene, 0.0, 99.0, coarse);
  CHECK(names(coarse) == "stays comes");
}

TEST_CASE("A scene in which a box goes before it comes is refused with its place",
          "[unit][scenes]") {
  Scene scene;
  scene.boxes = {SceneBox{}, SceneBox{.name = "b", .position_w = Vec3(3.0, 0.0, 0.0)}};
  for (const double disappears : {0.5, 0.25, -1.0, kNan}) {
    INFO(disappears);
    scene.boxes[1].appears = 0.5;
    scene.boxes[1].disappears = disappears;
    try {
      (void)checked(scene);
      FAIL("not refused");
    } catch (const SceneMistake& mistake) {
      CHECK(mistake.box() == 1);
      CHECK_THAT(mistake.what(),
                 Contains("box[2], b: disappears = ") && Contains("expected later than 0.5 s"));
    }
  }
}

TEST_CASE("An unknown scene or setting is refused with the list of what there is",
          "[unit][scenes]") {
  CHECK_THROWS_WITH(scene_recipe("piramid"), Contains("pyramid3d"));
  CHECK_THROWS_WITH(built("stack", {{"hight", "3"}}), Contains("count"));
  CHECK_THROWS_WITH(built("stack", {{"count", "0"}}), Contains("from 1"));
  CHECK_THROWS_WITH(built("stack", {{"count", "2.5"}}), Contains("whole"));
  CHECK_THROWS_WITH(built("clump", {{"toward", "moon"}}), Contains("axis"));
}

TEST_CASE("Every scene can be built at both ends of each of its parameters", "[unit][scenes]") {
  for (const SceneRecipe& recipe : scene_library()) {
    const Parameters standard = recipe.parameters();
    for (const Parameter& parameter : standard.all()) {
      if (parameter.kind == ParameterKind::text) continue;  // has no ends
      std::vector<std::string> values = parameter.choices;
      if (values.empty()) values = {shortest_text(parameter.low), shortest_text(parameter.high)};
      for (const std::string& value : values) {
        INFO(recipe.name << ", " << parameter.key << " = " << value);
        Parameters p = recipe.parameters();
        if (recipe.name == "cradle" && parameter.key == "moving") p.set("count", "1000");
        if (recipe.name == "projectile" && parameter.key == "per_edge") p.set("target", "clump");
        CHECK_NOTHROW(p.set(parameter.key, value));
        Scene scene;
        CHECK_NOTHROW(scene = checked(recipe.build(p, Random(2))));  // no overlap, above all
        CHECK(!scene.boxes.empty());
        CHECK(scene.boxes.size() <= 10000);
        if (scene.boxes.size() <= 1000) CHECK_NOTHROW(build_world(scene));
      }
    }
  }
}

TEST_CASE("Cubes on a line stand where they are put, and what is no list of them is refused",
          "[unit][scenes]") {
  const Scene scene = built("line", {{"boxes", "0:1,-2.5:0.25,1e1:-3"}, {"size", "0.5"}});
  REQUIRE(scene.boxes.size() == 3);
  CHECK(scene.boxes[1].position_w == Vec3(-1.25, 0.0, 0.0));  // [m] places are in edges
  CHECK(scene.boxes[2].position_w == Vec3(5.0, 0.0, 0.0));
  CHECK(scene.boxes[2].velocity_w == Vec3(-3.0, 0.0, 0.0));
  CHECK(scene.boxes[2].name == "c");
  CHECK_THROWS_WITH(built("line", {{"boxes", "0:1,2"}}), Contains("speed"));
  for (const char* text : {"0:1,", "0:x", ":1", "0:1;2:1", "0:inf", "0:1,,2:0", "1:2:3"}) {
    INFO(text);
    CHECK_THROWS_WITH(built("line", {{"boxes", text}}), Contains("0:2,1.5:0"));
  }
}

TEST_CASE("Figures 6.6 and 6.7 are scenes by their numbers", "[unit][scenes]") {
  const auto hash = [](const Scene& scene) { return build_world(scene).hash().text(); };
  CHECK(hash(built("fig6_6", {})) == hash(built("projectile", {})));
  CHECK(hash(built("fig6_7", {})) == hash(built("clump", {{"toward", "origin"}})));
}
