/// \file
/// \brief Bodies of which many meet in one frame, at random: a crowded cage, and chains on a line
///        (thesis 5.1).
#pragma once

#include "tumble/timewarp/timewarp_swept.hpp"

#include "driver/experiment.hpp"
#include "timewarp/event_story.hpp"

namespace tumble::chapters {

inline constexpr int kStirred = 30;  // steps: an edge at the speed of the scene, 2 m/s

// Even in a ball of radius 1.
inline Vec3 in_ball(Random& chance) {
  Vec3 point = chance.in_cube(1.0);
  while (point.squaredNorm() > 1.0) point = chance.in_cube(1.0);
  return point;
}

// Lets the cubes of a cage fly and collide for half a second, about an edge each. With swept volumes,
// so that no two are left in each other.
inline void stir(World& cage) {
  TimewarpSwept technique;
  for (int k = 0; k < kStirred; ++k) finished(technique.step(cage, kStep));
}

// Cubes of 1 m in a closed cage, without gravity and friction, on a grid as the scene `cage` has them
// and then stirred twice: their places and orientations are left to chance.
// room: [m] edge of the space that each cube has, at least 1.8
inline World stirred_cage(int count, double room, std::uint64_t seed) {
  World cage = build_world(
      make_scene("cage", {"count=" + std::to_string(count), setting("room", room)}, seed));
  stir(cage);
  stir(cage);
  return cage;
}

// The cubes of a cage where they are, with velocities of their own.
// speed: [m/s] largest speed: velocities are even in a ball of this radius, angular velocities in one of
// speed / edge
inline World with_speeds(World cage, double speed, Random chance) {
  for (const BodyId id : cage.ids()) {
    if (!cage.bodies()[static_cast<std::size_t>(cage.index_of(id))].movable()) continue;
    const Vec3 velocity_w = speed * in_ball(chance);
    cage.set_velocity(id, velocity_w, speed * in_ball(chance));
  }
  return cage;
}

// Cubes of 1 m and 1 kg on a line, without gravity, that bounce without loss.
struct Chain {
  std::vector<double> centres;     // [m] ascending, more than 1 m apart
  std::vector<double> velocities;  // [m/s] along the line
};

// A chain as chance has it.
// relative: [m/s] largest relative speed: velocities are even up to half of it
inline Chain random_chain(int count, double relative, Random chance) {
  Chain chain;
  double centre = 0.0;
  for (int k = 0; k < count; ++k) {
    chain.centres.push_back(centre);
    centre += 1.0 + chance.unit();
    chain.velocities.push_back(chance.uniform(-0.5 * relative, 0.5 * relative));
  }
  return chain;
}

// The bodies of a chain.
inline World world_of(const Chain& chain) {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  for (std::size_t k = 0; k < chain.centres.size(); ++k)
    world.add(cube, Vec3(chain.centres[k], 0.0, 0.0), Quat::Identity(),
              Vec3(chain.velocities[k], 0.0, 0.0));
  return world;
}

// The collisions of a chain in closed form.
//
// Equal cubes that bounce without loss exchange velocities. Take the edges away, and they are
// points that pass through one another, each on a straight line: two lines cross at most once, and
// at each crossing the cubes collide that are at this place in the row.
// duration: [s] from the start
inline std::vector<Collision> exact_story(const Chain& chain, double duration) {
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
  std::ranges::sort(crossings,
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
