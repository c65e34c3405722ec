/// \file
/// \brief Scenes of boxes piled up at rest.
#include "tumble/scenes/recipes.hpp"

#include <string>

namespace tumble::recipes {
namespace {

Parameters stack_parameters() {
  return with_scatter({friction(), whole("count", 10, 1, 10000, "boxes"),
                       number("size", 1.0, 1e-3, 1e3, "m", "edge of a cube"),
                       number("mass", 1.0, 1e-6, 1e6, "kg", "mass of a cube"),
                       number("top_mass", 1.0, 1e-6, 1e6, "kg", "mass of the uppermost cube")});
}

Scene stack(const Parameters& p, Random random) {
  Scene scene;
  scene.title = "a stack of " + std::to_string(p.count("count")) + " cubes";
  const double size = p.number("size");
  for (int k = 0; k < p.count("count"); ++k) {
    scene.boxes.push_back(box_at(numbered("level", {k + 1}), Vec3::Constant(size),
                                 Vec3(0.0, (k + 0.5) * size, 0.0),
                                 p.number(k + 1 == p.count("count") ? "top_mass" : "mass")));
  }
  add_ground(p, scene);
  scatter(p, random, scene);
  return scene;
}

Parameters pyramid_parameters() {
  return with_scatter(
      {friction(), whole("rows", 10, 1, 100, "boxes in the lowest row"),
       number("spacing", 1.05, 1.0, 1.9, "-", "distance of centres in a row, in edges")});
}

Scene pyramid(const Parameters& p, Random random) {
  Scene scene;
  scene.title = "a flat pyramid of " + std::to_string(p.count("rows")) + " rows";
  build_pyramid(p.count("rows"), p.number("spacing"), scene);
  add_ground(p, scene);
  scatter(p, random, scene);
  return scene;
}

Parameters pyramid3d_parameters() {
  return with_scatter(
      {friction(), whole("rows", 10, 1, 30, "layers, and boxes along each edge of the lowest one"),
       number("spacing", 1.05, 1.0, 1.9, "-", "distance of centres in a layer, in edges")});
}

// Square layers, each box over the middle of the four below it.
Scene pyramid3d(const Parameters& p, Random random) {
  Scene scene;
  const int layers = p.count("rows");
  const double spacing = p.number("spacing");
  scene.title = "a square pyramid of " + std::to_string(layers) + " layers";
  for (int layer = 0; layer < layers; ++layer) {
    const int edge = layers - layer;
    for (int i = 0; i < edge; ++i) {
      for (int k = 0; k < edge; ++k) {
        const double middle = 0.5 * (edge - 1);
        scene.boxes.push_back(
            box_at(numbered("l", {layer + 1, i + 1, k + 1}), Vec3::Ones(),
                   Vec3((i - middle) * spacing, layer + 0.5, (k - middle) * spacing), 1.0));
      }
    }
  }
  add_ground(p, scene);
  scatter(p, random, scene);
  return scene;
}

Parameters wall_parameters() {
  return with_scatter({friction(), whole("courses", 20, 1, 200, "rows of bricks"),
                       whole("bricks", 20, 1, 200, "bricks in a row"),
                       number("gap", 0.01, 0.0, 0.2, "m", "gap between neighbours in a row")});
}

// Quarter bond: every other course is shifted by a quarter of a brick. With half bond the free
// bricks at the ends would overhang by more than half, and the wall would fall by itself.
Scene wall(const Parameters& p, Random random) {
  Scene scene{.title = "a wall in quarter bond"};
  const Vec3 size(1.0, 0.5, 0.5);
  for (int course = 0; course < p.count("courses"); ++course) {
    for (int i = 0; i < p.count("bricks"); ++i) {
      const double shift = course % 2 == 0 ? 0.0 : 0.25 * size.x();
      const double x = (i - 0.5 * (p.count("bricks") - 1)) * (size.x() + p.number("gap")) + shift;
      scene.boxes.push_back(box_at(numbered("c", {course + 1, i + 1}), size,
                                   Vec3(x, (course + 0.5) * size.y(), 0.0), 0.25));
    }
  }
  add_ground(p, scene);
  scatter(p, random, scene);
  return scene;
}

}  // namespace

void build_pyramid(int rows, double spacing, Scene& scene) {
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const double x = (i - 0.5 * (rows - row - 1)) * spacing;
      scene.boxes.push_back(
          box_at(numbered("r", {row + 1, i + 1}), Vec3::Ones(), Vec3(x, row + 0.5, 0.0), 1.0));
    }
  }
}

void add_structures(std::vector<SceneRecipe>& list) {
  list.push_back({"stack", "4.4, 6.3.1", "cubes on top of each other", stack_parameters, stack});
  list.push_back({"pyramid", "5.4, 6.1", "a flat pyramid of cubes, each row one shorter",
                  pyramid_parameters, pyramid});
  list.push_back(
      {"pyramid3d", "6.1", "a pyramid of square layers of cubes", pyramid3d_parameters, pyramid3d});
  list.push_back({"wall", "6.1", "a wall of bricks in quarter bond", wall_parameters, wall});
}

}  // namespace tumble::recipes
