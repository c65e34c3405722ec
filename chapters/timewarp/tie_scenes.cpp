/// \file
/// \brief A cube that two others hit at nearly the same time (thesis 5.1).
#include "timewarp/tie_scenes.hpp"

#include "tumble/dynamics/pair_search.hpp"

namespace tumble::chapters {
namespace {

constexpr double kAway = 2.5;  // [m] between the centres where a flight begins; half diagonals 0.87
constexpr double kExact = 1e-12;  // [s]

// When a cube in flight hits one that rests.
double hit_time(const BodyProperties& cube, const BodyState& resting, const BodyState& flying,
                double latest) {
  const std::array<BodyProperties, 2> bodies = {cube, cube};
  const std::array<BodyState, 2> states = {resting, flying};
  const Flight flight{.bodies = bodies, .states = states, .gravity_w = Vec3::Zero()};
  const SearchOptions how{
      .method = SearchMethod::conservative, .resolution = kExact, .cap = 1000000};
  const PairCollision found = find_collision(flight, {0, 1}, 0.0, latest, how);
  if (found.status != CollisionStatus::found)
    throw std::runtime_error("a cube that should hit another one does not");
  return found.time;
}

// A cube that hits the resting one at a time, from one side.
BodyState comer(const BodyProperties& cube, const BodyState& resting, double side, double time,
                bool turning, Random& chance) {
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

}  // namespace

TwoImpacts two_impacts(const TwoImpactsOptions& options, Random chance) {
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  TwoImpacts out;
  out.left_first = chance.unit() < 0.5;
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
