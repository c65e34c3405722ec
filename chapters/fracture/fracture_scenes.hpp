/// \file
/// \brief The two scenes of fracture: a plank that falls on a bar, a wall that is hit by a cube (thesis 2.4.1).
#pragma once

#include "tumble/fracture/fracture.hpp"

#include <array>

namespace tumble::chapters {

inline const Vec3 kPlank(1.0, 0.05, 0.1);  // [m]
inline const Vec3 kWall(1.0, 0.8, 0.1);    // [m]
inline const Vec3 kBar(0.05, 0.1, 0.3);    // [m] lies under the middle of the plank
constexpr double kGap = 0.001;             // [m] from there to the plank
constexpr double kCube = 0.2;              // [m] that hits the wall

// A material as soft as films use: its wave takes as many steps for a length as glass, and three milliseconds for a metre.
inline ElasticMaterial soft_material(double strength = 1e6) {
  return elastic_material(0.26e9, 0.25, 2600.0, strength, 1e-5);
}

// The bar on which it falls.
inline void add_bar(World& world) {
  world.add(fixed_box_properties(kBar), Vec3(0.0, 0.5 * kBar.y(), 0.0));
}

// A plank that has come down to just above the bar.
inline Fracture falling_plank(const ElasticMaterial& material, double speed,
                              const std::array<int, 3>& cells, double gap = kGap) {
  ElasticMesh plank =
      elastic_box(kPlank, cells, material, Vec3(0.0, kBar.y() + gap + 0.5 * kPlank.y(), 0.0));
  for (ElasticNode& node : plank.nodes) node.velocity_w.y() = -speed;
  World around;
  around.add_ground();
  add_bar(around);
  const double least = least_height(plank);
  return Fracture(std::move(plank), std::move(around), least);
}

// A wall on the ground, its lowest nodes held, and a cube of the same density on its way.
inline Fracture hit_wall(const ElasticMaterial& material, double speed,
                         const std::array<int, 3>& cells) {
  ElasticMesh wall = elastic_box(kWall, cells, material, Vec3(0.0, 0.5 * kWall.y(), 0.0));
  for (ElasticNode& node : wall.nodes)
    if (node.position_w.y() < 0.25 * kWall.y() / cells[1]) node.moves.setZero();
  World around;
  around.add_ground();
  const BodyProperties cube =
      box_properties(Vec3::Constant(kCube), material.density * kCube * kCube * kCube);
  around.add(cube, Vec3(0.03, 0.55 * kWall.y(), 0.5 * (kWall.z() + kCube) + 0.001),
             Quat::Identity(), Vec3(0.0, 0.0, -speed));
  const double least = least_height(wall);
  return Fracture(std::move(wall), std::move(around), least);
}

}  // namespace tumble::chapters
