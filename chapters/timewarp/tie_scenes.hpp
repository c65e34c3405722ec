/// \file
/// \brief A cube that two others hit at nearly the same time (thesis 5.1).
#pragma once

#include "tumble/dynamics/pair_search.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Cubes of 1 m and 1 kg without gravity that bounce without loss: body 1 rests, body 0 hits it
// from the left and body 2 from the right.
struct TwoImpacts {
  World world;             // at the start of the frame
  bool left_first = true;  // body 0 comes before body 2
};

// The part of two impacts that is not random.
struct TwoImpactsOptions {
  double frame = 1.0 / 60.0;  // [s] the first impact is between a fifth and four fifths of it
  double delay = 0.0;         // [s] from the first impact to the second
  bool turning = false;       // all have any orientation and those that fly turn; else faces meet
};

inline constexpr double kAway =
    2.5;  // [m] between the centres where a flight begins; half diagonals 0.87
inline constexpr double kTieResolution = 1e-12;  // [s]

// When a cube in flight hits one that rests.
inline double hit_time(const BodyProperties& cube, const BodyState& resting,
                       const BodyState& flying, double latest) {
  const std::array<BodyProperties, 2> bodies = {cube, cube};
  const std::array<BodyState, 2> states = {resting, flying};
  const Flight flight{.bodies = bodies, .states = states, .gravity_w = Vec3::Zero()};
  const SearchOptions how{
      .method = SearchMethod::conservative, .resolution = kTieResolution, .cap = 1000000};
  const PairCollision found = find_collision(flight, {0, 1}, 0.0, latest, how);
  if (found.status != CollisionStatus::found)
    throw std::runtime_error("a cube that should hit another one does not");
  return found.time;
}

// A cube that hits the resting one at a time, from one side.
inline BodyState comer(const BodyProperties& cube, const BodyState& resting, double side,
                       double time, bool turning, Random& chance) {
  constexpr double aside = 0.3;  // [m] with half an edge of each always a hit
  const double speed = chance.uniform(1.0, 10.0);
  const double y = chance.uniform(-aside, aside);
  const double z = chance.uniform(-aside, aside);
  const Quat orientation_wb = turning ? chance.orientation() : Quat::Identity();
  Vec3 spin_w = Vec3::Zero();
  if (turning) {
    const double fast = chance.uniform(0.0, 10.0);
    spin_w = fast * chance.direction();
  }
  BodyState state = make_state(cube, Vec3(side * kAway, y, z), orientation_wb,
                               Vec3(-side * speed, 0.0, 0.0), spin_w);
  const double late = hit_time(cube, resting, state, kAway / speed) - time;
  fly(cube, state, Vec3::Zero(), late, RotationRule::splitting);
  return state;
}

// Draws speeds from 1 to 10 m/s, ways that pass the middle at up to 0.3 edges to each side,
// angular velocities up to 10 rad/s, the time of the first impact, and the side of it.
//
// The times of the impacts are right to a picosecond: a search finds when a cube that comes from a
// distance would hit, and the cube is then flown forth or back by what the time is off. The flight
// of a cube is exact in both directions, and the one that is hit rests.
inline TwoImpacts two_impacts(const TwoImpactsOptions& options, Random chance) {
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  TwoImpacts out{.left_first = chance.unit() < 0.5};
  const double first = options.frame * chance.uniform(0.2, 0.8);
  const double second = first + options.delay;
  const BodyState resting =
      make_state(cube, Vec3::Zero(), options.turning ? chance.orientation() : Quat::Identity());
  const BodyState left =
      comer(cube, resting, -1.0, out.left_first ? first : second, options.turning, chance);
  const BodyState right =
      comer(cube, resting, 1.0, out.left_first ? second : first, options.turning, chance);
  out.world.gravity_w = Vec3::Zero();
  out.world.add(cube, left);
  out.world.add(cube, resting);
  out.world.add(cube, right);
  return out;
}

}  // namespace tumble::chapters
