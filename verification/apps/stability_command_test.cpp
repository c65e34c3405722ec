/// \file
/// \brief `tumble stability` from outside: stable boxes, levels, initial motion, messages.

#include "apps/command.hpp"
#include "support/test.hpp"

namespace {

// The line of the table that begins with a name.
std::string line_of(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, name.size() + 1, name + " ") == 0) return line;
  return "no line for " + name;
}

// A scene file in a folder of its own.
struct SceneFile {
  Folder folder;
  std::string path;
  SceneFile(const char* name, const std::string& text) : folder(name) {
    path = folder.file("scene.toml").string();
    std::ofstream(path) << text;
  }
};

// Two unit cubes; the second one's place and motion are to follow.
const std::string kTwoBoxes =
    "[ground]\n[[box]]\nname = \"lower\"\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 0.5, 0]\n"
    "[[box]]\nname = \"upper\"\nsize = [1, 1, 1]\nmass = 1\nposition = ";

}  // namespace

TEST_CASE("The command reports which boxes are stable, by which level and why", "[unit][command]") {
  const SceneFile file("stability_levels", kTwoBoxes + "[0.3, 1.5, 0]\n");
  const Outcome hull = tumble_ends(0, "stability " + file.path + " --rule hull");
  CHECK_THAT(line_of(hull.text, "lower"),
             Contains(" yes ") && Contains(" hull ") && Contains("supports any load"));
  CHECK_THAT(line_of(hull.text, "upper"),
             Contains(" no ") && Contains(" - ") && Contains("the corner at x = 0.8 m, z = "));
  CHECK_THAT(hull.text, Contains("1 of 2 movable boxes are stable by hull") &&
                            Contains("\nin equilibrium under the weights, without friction"));
  const Outcome equilibrium = tumble_ends(0, "stability " + file.path);
  CHECK_THAT(line_of(equilibrium.text, "upper"), Contains(" yes ") && Contains(" tower "));
  CHECK_THAT(equilibrium.text, Contains("2 of 2 movable boxes are stable by equilibrium"));
  CHECK_THAT(run_tumble("stability " + file.path + " --rule corners").text,
             Contains("1 of 2 movable boxes are stable by corners"));
}

TEST_CASE("The command prints the boxes that begin to move, and how fast", "[exact][command]") {
  // The centre is d = 0.6 from the middle of the lower cube and 0.1 beyond its edge: about the edge,
  // which slides, a cube turns with g d / (I/m + d²) = 9.81 * 0.1 / (1/6 + 0.01) and its centre sinks
  // with a tenth of that.
  const SceneFile file("stability_moves", kTwoBoxes + "[0.6, 1.5, 0]\n");
  const Outcome outcome = tumble_ends(0, "stability " + file.path);
  CHECK_THAT(line_of(outcome.text, "upper"), Contains("begins to move, see below"));
  CHECK_THAT(outcome.text,
             Contains("not in equilibrium under the weights, without friction, nor with it") &&
                 Contains("upper     0.0000   -0.5553    0.0000      0.0000    0.0000   -5.5528"));
  // A slope needs friction.
  const Outcome slope = run_tumble("stability slope --set angle=10");
  INFO(slope.text);
  CHECK_THAT(slope.text, Contains("with friction there are forces that balance them"));
  // g sin 10 cos 10 and g sin² 10
  CHECK_THAT(slope.text, Contains("1.6776   -0.2958    0.0000"));
}

TEST_CASE("The levels of the command are hull, balance and loads on top", "[unit][command]") {
  const Outcome bridge = tumble_ends(0, "stability fig6_5");
  const Outcome pyramid = run_tumble("stability fig5_6 --set rows=5");
  INFO(pyramid.text);
  CHECK_THAT(line_of(pyramid.text, "r1_1"), Contains(" yes ") && Contains(" hull "));
  CHECK_THAT(line_of(pyramid.text, "r2_2"), Contains(" yes ") && Contains(" balance "));
  CHECK_THAT(pyramid.text, Contains("14 of 14 movable boxes"));
  const Outcome loads = run_tumble("stability fig5_6 --set rows=5 --rule load_proof");
  INFO(loads.text);
  CHECK_THAT(line_of(loads.text, "r2_2"), Contains(" no "));
  CHECK_THAT(loads.text, Contains("6 of 14 movable boxes are stable by load_proof"));
  // Boxes side by side are no hull of each other, and carry what is put on them.
  const SceneFile pair("stability_pair", kTwoBoxes + "[1, 0.5, 0]\n");
  const Outcome side = run_tumble("stability " + pair.path + " --rule load_proof");
  INFO(side.text);
  CHECK_THAT(line_of(side.text, "upper"), Contains(" yes ") && Contains(" load_proof "));
  CHECK_THAT(line_of(run_tumble("stability " + pair.path + " --rule hull").text, "upper"),
             Contains("the contact of lower and upper is not vertical"));
}

TEST_CASE("Scenes that move, without ground or with gravity from the side are reported too",
          "[unit][command]") {
  const Outcome drop = tumble_ends(0, "stability box_drop");
  CHECK_THAT(drop.text, Contains("0 of 1 movable boxes") && Contains("-9.8100"));
  const SceneFile aside("stability_aside",
                        "gravity = [9.81, 0, 0]\n" + kTwoBoxes + "[0, 1.5, 0]\n");
  const Outcome side = tumble_ends(0, "stability " + aside.path + " --rule hull");
  CHECK_THAT(line_of(side.text, "lower"), Contains("gravity does not act straight down"));
  const SceneFile rising("stability_rising", kTwoBoxes + "[0, 1.5, 0]\nvelocity = [0, 1, 0]\n");
  CHECK_THAT(line_of(run_tumble("stability " + rising.path).text, "upper"),
             Contains("moves, or touches a box that moves"));
  CHECK_THAT(line_of(run_tumble("stability " + rising.path + " --rule hull").text, "upper"),
             Contains("rises, sinks or tips"));
}

TEST_CASE("Mistakes in a request for stability end with code 2 and one line", "[unit][command]") {
  const Folder folder("stability_bad");
  std::ofstream(folder.file("bad.toml")) << "[[box]]\nsize = [1, 1, -1]\n";
  check_refused({
      {"stability", "scene is required"},
      {"stability nosuch", "unknown scene nosuch"},
      {"stability stack --rule hulls", "--rule hulls: did you mean hull?"},
      {"stability stack --rule", "--rule"},
      {"stability stack --set rows=3", "unknown key"},
      {"stability stack --set count", "expected key=value"},
      {"stability stack --set technique.k_scale=2", "k_scale"},
      {"stability stack --set count=0", "count = 0"},
      {"stability " + folder.text() + "/none.toml", "there is no such file"},
      {"stability " + folder.text() + "/bad.toml", "bad.toml:2"},
      {"stability " + folder.text() + "/bad.toml --set count=2", "count"},
      {"stability stack --seed x", "expected a whole number"},
      {"stabilty stack", "did you mean stability?"},
  });
}

TEST_CASE("Every built-in scene can be asked for its stability", "[unit][command]") {
  std::istringstream names(run_tumble("scenes").text);
  int count = 0;
  for (std::string line; std::getline(names, line); ++count) {
    const std::string name = line.substr(0, line.find(' '));
    INFO(name);
    std::string small;
    if (name == "wall") small = " --set courses=4 --set bricks=4";
    if (name == "pyramid3d" || name == "pyramid") small = " --set rows=4";
    if (name == "fig5_6") small = " --set rows=5";
    const Outcome outcome = run_tumble("stability " + name + small);
    INFO(outcome.text);
    const tumble::SceneRecipe& recipe = tumble::scene_recipe(name);
    const bool joints = !recipe.build(recipe.parameters(), tumble::Random(1)).joints.empty();
    CHECK(outcome.code == (joints ? 2 : 0));
    CHECK_THAT(outcome.text, Contains(joints ? "tumble stability does not support joints"
                                             : "boxes are stable by equilibrium"));
  }
  CHECK(count >= 16);
}
