/// \file
/// \brief The first example: a stack of ten cubes that falls, rests, and is read by name.

// [stack]
#include <cstdio>
#include <tumble/tumble.hpp>

int main() {
  tumble::Scene scene{.title = "stack", .ground = tumble::SceneGround{.friction = 0.6}};
  for (int k = 1; k <= 10; ++k)  // unit cubes, 20 cm apart: they fall onto each other
    scene.boxes.push_back({.name = "cube" + std::to_string(k), .position_w = {0.0, 1.2 * k, 0.0}});
  tumble::Simulation simulation(scene);  // steps it with the default technique, contact_damped
  simulation.run_for(10.0);              // [s]
  const tumble::BodyView top = simulation.body("cube10");
  std::printf("%s rests at %.3f m\n", top.name().c_str(), top.position_w().y());
}
// [stack]
