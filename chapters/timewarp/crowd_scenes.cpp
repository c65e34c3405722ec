/// \file
/// \brief Bodies of which many meet in one frame, at random: a crowded cage, and chains on a line
///        (thesis 5.1).
#include "timewarp/crowd_scenes.hpp"

#include "tumble/scenes/library.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "driver/common_numbers.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace tumble::chapters {
namespace {

constexpr int kStirred = 30;  // steps: an edge at the speed of the scene, 2 m/s

World cage(int count, double room, std::uint64_t seed) {
  const SceneRecipe& recipe = scene_recipe("cage");
  Parameters parameters = recipe.parameters();
  parameters.set("count", std::to_string(count));
  parameters.set("room", std::to_string(room));
  return build_world(recipe.build(parameters, Random(seed)));
}

// Even in a ball of radius 1.
Vec3 in_ball(Random& chance) {
  Vec3 point = chance.in_cube(1.0);
  while (point.squaredNorm() > 1.0) point = chance.in_cube(1.0);
  return point;
}

}  // namespace

StirredCage::StirredCage(int count, double room, std::uint64_t seed)
    : world_(cage(count, room, seed)) {
  stir();
  stir();
}

void StirredCage::stir() {
  TimewarpSwept technique;
  for (int k = 0; k < kStirred; ++k) technique.step(world_, kStep);
}

World StirredCage::with_speeds(double speed, Random chance) const {
  World world = world_;
  for (int k = 0; k < world.count(); ++k) {
    const auto place = static_cast<std::size_t>(k);
    if (!world.bodies()[place].movable()) continue;
    const Vec3 velocity_w = speed * in_ball(chance);
    world.set_velocity(world.ids()[place], velocity_w, speed * in_ball(chance));
  }
  return world;
}

Chain random_chain(int count, double relative, Random chance) {
  Chain chain;
  double centre = 0.0;
  for (int k = 0; k < count; ++k) {
    chain.centres.push_back(centre);
    centre += 1.0 + chance.unit();
    chain.velocities.push_back(chance.uniform(-0.5 * relative, 0.5 * relative));
  }
  return chain;
}

World world_of(const Chain& chain) {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  for (std::size_t k = 0; k < chain.centres.size(); ++k)
    world.add(cube, make_state(cube, Vec3(chain.centres[k], 0.0, 0.0), Quat::Identity(),
                               Vec3(chain.velocities[k], 0.0, 0.0)));
  return world;
}

std::vector<Collision> exact_story(const Chain& chain, double duration) {
  const std::size_t count = chain.centres.size();
  struct Crossing {
    double time = 0.0;
    std::size_t left = 0;  // the line that was to the left of the other
    std::size_t right = 0;
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double gap = chain.centres[j] - chain.centres[i] - static_cast<double>(j - i);
      const double closing = chain.velocities[i] - chain.velocities[j];
      if (closing > 0.0 && gap < closing * duration) crossings.push_back({gap / closing, i, j});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.time < b.time; });

  std::vector<int> place(count);  // by line: which cube goes along it
  std::iota(place.begin(), place.end(), 0);
  std::vector<Collision> story;
  for (const Crossing& crossing : crossings) {
    story.push_back({crossing.time, place[crossing.left], place[crossing.right]});
    std::swap(place[crossing.left], place[crossing.right]);
  }
  return story;
}

}  // namespace tumble::chapters
