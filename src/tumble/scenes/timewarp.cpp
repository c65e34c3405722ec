/// \file
/// \brief Scenes in which the order of collisions matters: boxes on a line without gravity.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/scenes/recipes.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

namespace tumble::recipes {
namespace {

Parameters line_parameters() {
  return {
      text("boxes", "0:2,1.5:0,3.4:-1", "place and speed of each cube, as x:v in edges and m/s"),
      number("size", 1.0, 1e-3, 1e3, "m", "edge of the cubes"),
      number("restitution", 1.0, 0.0, 1.0, "-", "0 sticks, 1 bounces back")};
}

// Reads a number that ends at a character or at the end of the text; takes it off the text.
double take_part(std::string_view& text, char end, const std::string& all) {
  const std::string_view part = text.substr(0, text.find(end));
  const std::optional<double> value = parse_number(part);
  if (!value || !(std::abs(*value) <= 1e6))
    refuse("boxes = " + all + ": '" + std::string(part) +
           "' is no number; expected x:v, as in 0:2,1.5:0");
  text.remove_prefix(part.size());
  return *value;
}

SceneBox cube_at(const std::string& name, double size, double x, double speed) {
  SceneBox box = box_at(name, Vec3::Constant(size), Vec3(x, 0.0, 0.0), 1.0);
  box.velocity_w.x() = speed;
  box.friction = 0.0;
  return box;
}

// Named a, b, c, ... as far as letters go, then box27, ...
std::string name_of_place(std::size_t k) {
  constexpr std::size_t kLetters = 26;
  if (k < kLetters) return std::string(1, static_cast<char>('a' + k));
  return numbered("box", {static_cast<int>(k) + 1});
}

Scene line(const Parameters& p, Random) {
  Scene scene{.title = "cubes on a line without gravity", .gravity_w = Vec3::Zero()};
  const std::string& all = p.text("boxes");
  std::string_view rest = all;
  for (;;) {
    const double x = take_part(rest, ':', all);
    require::that(!rest.empty(),
                  "boxes = " + all + ": a speed is missing; expected x:v, as in 0:2,1.5:0");
    rest.remove_prefix(1);
    const double speed = take_part(rest, ',', all);
    const double size = p.number("size");
    scene.boxes.push_back(cube_at(name_of_place(scene.boxes.size()), size, size * x, speed));
    if (rest.empty()) break;
    rest.remove_prefix(1);
  }
  for (SceneBox& box : scene.boxes) box.restitution = p.number("restitution");
  return scene;
}

Parameters fig5_1_parameters() {
  return {number("size", 0.1, 1e-3, 1e3, "m", "edge of the cubes"),
          number("fast", 24.0, 0.0, 1e4, "m/s", "speed of A"),
          number("slow", 1.2, 0.0, 1e4, "m/s", "speed of D"),
          number("gap_ab", 0.6, 0.0, 100.0, "-", "gap between A and B at the start, in edges"),
          number("gap_bc", 1.3, 0.0, 100.0, "-", "gap between B and C at the start, in edges"),
          number("gap_cd", 0.2, 0.0, 100.0, "-", "gap between C and D at the start, in edges"),
          number("gap_de", 0.13, 0.0, 100.0, "-", "gap between D and E at the start, in edges"),
          number("restitution", 1.0, 0.0, 1.0, "-", "0 sticks, 1 bounces back")};
}

// In a frame of 1/60 s the fast cube A flies over B and ends in C; D ends in E. With these gaps D
// meets E at 0.65 of the frame, before A would meet C at 0.725; in truth A meets B at 0.15, B meets C
// at 0.475, and C meets D at 0.553, which is before D is at E.
Scene fig5_1(const Parameters& p, Random) {
  Scene scene{.title = "five cubes on a line, and the order in which they collide (figure 5.1)",
              .gravity_w = Vec3::Zero()};
  const double size = p.number("size");
  double x = 0.0;
  scene.boxes.push_back(cube_at("A", size, x, p.number("fast")));
  x += (1.0 + p.number("gap_ab")) * size;
  scene.boxes.push_back(cube_at("B", size, x, 0.0));
  x += (1.0 + p.number("gap_bc")) * size;
  scene.boxes.push_back(cube_at("C", size, x, 0.0));
  x += (1.0 + p.number("gap_cd")) * size;
  scene.boxes.push_back(cube_at("D", size, x, p.number("slow")));
  x += (1.0 + p.number("gap_de")) * size;
  scene.boxes.push_back(cube_at("E", size, x, 0.0));
  for (SceneBox& box : scene.boxes) box.restitution = p.number("restitution");
  return scene;
}

}  // namespace

void add_lines(std::vector<SceneRecipe>& list) {
  list.push_back({"line", "5.1", "cubes on a line without gravity, each with a speed of its own",
                  line_parameters, line});
  list.push_back({"fig5_1", "5.1", "five cubes, a fast one flies over its neighbour in one frame",
                  fig5_1_parameters, fig5_1});
}

}  // namespace tumble::recipes
