/// \file
/// \brief The scenes that scenes.cpp measures.
#pragma once

#include "tumble/scenes/scene.hpp"

#include <string>
#include <vector>

namespace scene_bench {

// A scene that engines are measured on.
struct SceneChoice {
  std::string name;       // as a user writes it and as it is printed
  tumble::Scene scene;    // what all engines start from
  double seconds = 10.0;  // [s] how long it runs
  bool structure = true;  // whether it is to stay as it is; drift means nothing elsewhere
  bool sleeping = false;  // whether bodies may fall asleep
};

// Builds all scenes. Friction is 0.5 and restitution 0 everywhere.
std::vector<SceneChoice> all_scenes();

}  // namespace scene_bench
