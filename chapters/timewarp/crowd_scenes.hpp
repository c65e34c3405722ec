/// \file
/// \brief Bodies of which many meet in one frame, at random: a crowded cage, and chains on a line
///        (thesis 5.1).
#pragma once

#include "driver/experiment.hpp"
#include "timewarp/event_story.hpp"

namespace tumble::chapters {

// Lets the cubes of a cage fly and collide for half a second, about an edge each. With swept volumes,
// so that no two are left in each other.
void stir(World& cage);

// Cubes of 1 m in a closed cage, without gravity and friction, on a grid as the scene `cage` has them
// and then stirred twice: their places and orientations are left to chance.
// room: [m] edge of the space that each cube has, at least 1.8
World stirred_cage(int count, double room, std::uint64_t seed);

// The cubes of a cage where they are, with velocities of their own.
// speed: [m/s] largest speed: velocities are even in a ball of this radius, angular velocities in one of
// speed / edge
World with_speeds(World cage, double speed, Random chance);

// Cubes of 1 m and 1 kg on a line, without gravity, that bounce without loss.
struct Chain {
  std::vector<double> centres;     // [m] ascending, more than 1 m apart
  std::vector<double> velocities;  // [m/s] along the line
};

// A chain as chance has it.
// relative: [m/s] largest relative speed: velocities are even up to half of it
Chain random_chain(int count, double relative, Random chance);

// The bodies of a chain.
World world_of(const Chain& chain);

// The collisions of a chain in closed form.
//
// Equal cubes that bounce without loss exchange velocities. Take the edges away, and they are
// points that pass through one another, each on a straight line: two lines cross at most once, and
// at each crossing the cubes collide that are at this place in the row.
// duration: [s] from the start
std::vector<Collision> exact_story(const Chain& chain, double duration);

}  // namespace tumble::chapters
