/// \file
/// \brief The scenes that scenes.cpp measures: built-in ones, and boxes that only lie there.
#include "scene_list.hpp"

#include "tumble/scenes/library.hpp"

#include <array>
#include <string_view>

namespace scene_bench {
namespace {

using tumble::Scene;
// Cubes on the ground that touch nothing else.
Scene lying(int per_edge) {
  constexpr double kSpacing = 1.5;  // [m] centre to centre
  Scene scene{.title = "cubes that lie on the ground"};
  scene.ground.emplace();
  for (int i = 0; i < per_edge; ++i) {
    for (int k = 0; k < per_edge; ++k) {
      tumble::SceneBox box;
      const double middle = 0.5 * (per_edge - 1);
      box.position_w = {(i - middle) * kSpacing, 0.5, (k - middle) * kSpacing};
      scene.boxes.push_back(box);
    }
  }
  return scene;
}

}  // namespace

std::vector<SceneChoice> all_scenes() {
  std::vector<SceneChoice> out;
  const auto structure = [&out](const char* name, std::string_view recipe,
                                const std::vector<std::string>& settings = {}) {
    out.push_back({name, tumble::make_scene(recipe, settings)});
  };
  structure("stack10", "stack", {"count=10"});
  structure("pyramid10", "pyramid", {"rows=10"});
  structure("pyramid20", "pyramid", {"rows=20"});
  structure("pyramid3d8", "pyramid3d", {"rows=8"});
  structure("wall", "wall");
  structure("mass200", "stack", {"count=2", "top_mass=200"});
  structure("mass1000", "stack", {"count=2", "top_mass=1000"});
  for (const auto& [name, recipe, setting] : {std::array{"projectile", "projectile", "rows=10"},
                                              std::array{"clump125", "clump", "per_edge=5"},
                                              std::array{"clump1000", "clump", "per_edge=10"}}) {
    structure(name, recipe, {setting});
    out.back().structure = false;
  }
  structure("pyramid20_asleep", "pyramid", {"rows=20"});
  out.back().sleeping = true;
  out.push_back({"sleep10000", lying(100), 5.0});
  out.back().sleeping = true;
  return out;
}

}  // namespace scene_bench
