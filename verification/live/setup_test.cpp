/// \file
/// \brief Requests: what their words make, and in which sentence a mistake is reported.
#include "tumble/record/run.hpp"

#include "session.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

using namespace tumble::live;

const std::string kBox = "[[box]]\nsize = [1, 1, 1]\nmass = 2\nposition = [0, 3, 0]\n";

std::string hash_of(Technique& technique, const Scene& scene) {
  return run_scene(scene, technique, {.duration = 0.25}, {}).state_hash;
}

}  // namespace

TEST_CASE("A request makes the scene and the technique that its words name", "[unit][live]") {
  const Setup plain = make_setup("scene pyramid");
  CHECK(to_toml(plain.scene) == to_toml(built("pyramid")));
  CHECK(plain.technique->name() == kDefaultTechnique);

  // In any order, with empty lines, and with a line break at the end or without.
  for (const char* request :
       {"scene dice\nset scene.count=3\nseed 7\ntechnique impulse",
        "set scene.count=3\n\ntechnique impulse\nseed 7\n\nscene dice\n",
        "scene stack\nseed 2\nset scene.count=9\nseed 7\nset scene.count=3\nscene dice\ntechnique "
        "impulse\n"}) {
    INFO(request);
    const Setup setup = make_setup(request);
    CHECK(to_toml(setup.scene) == to_toml(built("dice", {{"count", "3"}}, 7)));
    CHECK(setup.technique->name() == "impulse");
  }
  CHECK(to_toml(make_setup("scene dice\nseed 0").scene) == to_toml(built("dice", {}, 0)));
  CHECK(to_toml(make_setup("scene dice\nseed 18446744073709551615").scene) ==
        to_toml(built("dice", {}, 18446744073709551615U)));
}

TEST_CASE("A request without a seed is made with seed 1, as tumble run does", "[unit][live]") {
  CHECK(to_toml(make_setup("scene dice").scene) == to_toml(built("dice", {}, 1)));
  CHECK(to_toml(make_setup("scene dice").scene) != to_toml(built("dice", {}, 2)));
}

TEST_CASE("Settings of a request reach the technique", "[unit][live]") {
  const Setup separate =
      make_setup("scene fig6_1\nset technique.pose=separate\nset technique.sweeps=7");
  const TechniqueRecipe& recipe = technique_recipe("contact_damped");
  Parameters options = recipe.options();
  const auto standard = recipe.make(options, 1);
  options.set("pose", "separate");
  options.set("sweeps", "7");
  const auto same = recipe.make(options, 1);
  const Scene scene = built("fig6_1");
  const std::string hash = hash_of(*separate.technique, scene);
  CHECK(hash == hash_of(*same, scene));
  CHECK(hash != hash_of(*standard, scene));
}

TEST_CASE("All that follows the word toml is the scene file", "[unit][live]") {
  const std::string file = "title = \"scene dice\"\n" + kBox + "name = \"set\"\n";
  const Setup setup = make_setup("technique basic\ntoml\n" + file);
  CHECK(setup.technique->name() == "basic");
  CHECK(to_toml(setup.scene) == to_toml(parse_scene(file, "any")));
  CHECK(setup.scene.title == "scene dice");
  CHECK(setup.scene.boxes[0].name == "set");
}

TEST_CASE("A mistake in a request is reported in a sentence that says what would be right",
          "[unit][live]") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "unknown scene : expected one of: box_drop, bouncing_box"},
      {"technique basic\nseed 3", "unknown scene : expected one of: box_drop"},
      {"scene", "unknown scene : expected one of: box_drop"},
      {"scene piramid", "unknown scene piramid: did you mean pyramid? Expected one of: box_drop"},
      {"scene dice box_drop", "unknown scene dice box_drop: expected one of: box_drop"},
      {"scene dice\ntechnique bsic", "unknown technique bsic: did you mean basic?"},
      {"scene dice\ntechnique", "unknown technique : expected one of: contact_damped"},
      {"Scene dice", "unknown word Scene: expected scene, technique, seed, set or toml"},
      {"scene dice\ntoml\n[[box]]", "scene dice and toml: expected a name or a text, not both"},
      {"scene dice\nplay 1", "unknown word play: expected scene, technique, seed, set or toml"},
      {"scene dice\nseed -1", "seed -1: expected a whole number from 0"},
      {"scene dice\nseed 1.5", "seed 1.5: expected a whole number from 0"},
      {"scene dice\nseed", "seed : expected a whole number from 0"},
      {"scene dice\nseed 7 ", "seed 7 : expected a whole number from 0"},
      {"scene dice\nseed 18446744073709551616",
       "seed 18446744073709551616: expected a whole number from 0"},
      {"scene dice\nset", "set : expected scene.KEY=VALUE or technique.KEY=VALUE"},
      {"scene dice\nset count=3", "set count=3: expected scene.KEY=VALUE or technique.KEY=VALUE"},
      {"scene dice\nset scene.count", "set scene.count: expected scene.KEY=VALUE"},
      {"scene dice\nset box.count=3", "set box.count=3: expected scene.KEY=VALUE"},
      {"scene dice\nset scene=1.5", "set scene=1.5: expected scene.KEY=VALUE"},
      {"scene dice\nset scene.cuont=3", "unknown setting cuont: did you mean count?"},
      {"scene dice\nset scene.=3", "unknown setting : expected one of: count"},
      {"scene dice\nset scene.count=", "count = : expected a whole number from 1"},
      {"scene dice\nset scene.count=2.5", "count = 2.5: expected a whole number from 1"},
      {"scene dice\nset scene.count=0", "count = 0: expected a whole number from 1"},
      {"scene dice\nset scene.friction=nan", "friction = nan: expected a number from 0"},
      {"scene dice\nset technique.sweps=3", "unknown setting sweps: did you mean sweeps?"},
      {"scene dice\nset technique.sleeping=maybe", "sleeping = maybe: expected on or off"},
      {"scene dice\ntechnique basic\nset technique.sweeps=3", "unknown setting sweeps: expected"},
      {"scene cradle\nset scene.moving=5", "moving = 5: expected fewer than count = 5"},
      {"toml", "scene.toml:1: box: a scene needs at least one [[box]] table, in two brackets"},
      {"toml\n[[box]\n", "scene.toml:1: not TOML"},
      {"toml\n" + kBox + "frction = 1\n",
       "scene.toml:5: box[1].frction = 1: unknown key; did you mean friction?"},
      {"toml\n" + kBox + kBox, "scene.toml:8: box[2].position = [0, 3, 0]: box2 and box1 overlap"},
      {"set scene.count=3\ntoml\n" + kBox, "unknown setting count: there are none"},
  };
  for (const auto& [request, message] : cases) {
    INFO(request);
    try {
      (void)make_setup(request);
      FAIL_CHECK("not refused");
    } catch (const std::invalid_argument& error) {
      CHECK_THAT(std::string(message_of(error)), Catch::Matchers::StartsWith(message));
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
}
