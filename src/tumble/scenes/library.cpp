/// \file
/// \brief The list of built-in scenes.
#include "tumble/scenes/library.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/scenes/recipes.hpp"

#include <string>

namespace tumble {

const std::vector<SceneRecipe>& scene_library() {
  static const std::vector<SceneRecipe> library = [] {
    std::vector<SceneRecipe> list;
    recipes::add_single(list);
    recipes::add_structures(list);
    recipes::add_sliding(list);
    recipes::add_balanced(list);
    recipes::add_stability(list);
    recipes::add_thrown(list);
    recipes::add_lines(list);
    recipes::add_turning(list);
    recipes::add_jointed(list);
    return list;
  }();
  return library;
}

const SceneRecipe& scene_recipe(std::string_view name) {
  std::vector<std::string_view> names;
  for (const SceneRecipe& recipe : scene_library()) {
    if (recipe.name == name) return recipe;
    names.push_back(recipe.name);
  }
  refuse("unknown scene " + std::string(name) + ": " + expected_names(name, names));
}

Scene make_scene(std::string_view name, const std::vector<std::string>& settings,
                 std::uint64_t seed) {
  const SceneRecipe& recipe = scene_recipe(name);
  Parameters parameters = recipe.parameters();
  for (const std::string& setting : settings) parameters.assign(setting);
  return recipe.build(parameters, Random(seed));
}

SceneBox recipes::box_at(std::string_view name, const Vec3& size, const Vec3& position_w,
                         double mass) {
  return SceneBox{.name = std::string(name), .size = size, .mass = mass, .position_w = position_w};
}

SceneBox recipes::fixed_at(std::string_view name, const Vec3& size, const Vec3& position_w) {
  SceneBox box = box_at(name, size, position_w, 1.0);
  box.fixed = true;
  return box;
}

Parameter recipes::friction() {
  return number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient of all bodies");
}

Parameters recipes::with_surface(Parameters p, double friction, double restitution) {
  p.add(number("friction", friction, 0.0, 10.0, "-", "Coulomb coefficient"));
  return p.add(number("restitution", restitution, 0.0, 1.0, "-", "0 sticks, 1 bounces back"));
}

void recipes::set_surfaces(const Parameters& p, Scene& scene) {
  for (SceneBox& box : scene.boxes) {
    box.friction = p.number("friction");
    box.restitution = p.number("restitution");
  }
}

void recipes::add_bouncing_ground(const Parameters& p, Scene& scene) {
  set_surfaces(p, scene);
  scene.ground = SceneGround{p.number("friction"), p.number("restitution")};
}

void recipes::add_ground(const Parameters& p, Scene& scene) {
  for (SceneBox& box : scene.boxes) box.friction = p.number("friction");
  scene.ground = SceneGround{p.number("friction"), 0.0};
}

std::string recipes::numbered(std::string_view stem, std::initializer_list<int> places) {
  std::string name(stem);
  bool first = true;
  for (const int place : places) {
    if (!first) name += '_';
    name += std::to_string(place);
    first = false;
  }
  return name;
}

}  // namespace tumble
