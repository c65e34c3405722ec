/// \file
/// \brief The lower level: three boxes fall onto the ground, stepped by hand with contacts and impulses.
#include <cstdio>
#include <tumble/contact/gather.hpp>
#include <tumble/contact/impacts.hpp>
#include <tumble/dynamics/integrate.hpp>
#include <utility>

/// Steps contacts without restitution and prints a hash of all states. Equal
/// hashes mean equal bits: layers_hash.txt holds for every compiler and optimisation.
/// \return 0
int main() {
  using namespace tumble;
  const BodyProperties cube = box_properties(Vec3(1.0, 1.0, 1.0), 1.0);
  World world;
  world.add_ground();
  for (const double height : {0.6, 1.8, 3.0}) world.add(cube, Vec3(0.1 * height, height, 0.0));

  // So few bodies need no broad phase: every pair is a candidate.
  std::vector<IndexPair> candidates;
  for (int i = 0; i < world.count(); ++i)
    for (int k = i + 1; k < world.count(); ++k) candidates.push_back({i, k});

  std::vector<MovingBody> bodies;
  ContactList contacts;
  ContactList previous;
  ImpactSolver impacts;
  const double dt = 1.0 / 60.0;
  for (int step = 0; step < 120; ++step) {
    // Gravity, then impulses that end every approach, then the move with the new velocities.
    for (int i = 0; i < world.count(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (world.bodies()[k].movable())
        world.states()[k].linear_momentum_w += world.bodies()[k].mass * dt * world.gravity_w;
    }
    load_moving_bodies(world, bodies);
    std::swap(contacts, previous);
    gather_contacts(world, bodies, candidates, 0.0, previous, contacts);
    impacts.resolve(contacts, bodies, {.order = ImpactOrder::simultaneous});
    store_moving_bodies(bodies, world);
    for (std::size_t k = 0; k < world.states().size(); ++k)
      advance_pose(world.bodies()[k], world.states()[k], dt, RotationRule::splitting);
    world.finish_step(dt);
  }

  for (std::size_t k = 1; k < world.states().size(); ++k)
    std::printf("box %zu: y = %.6f m\n", k, world.states()[k].position_w.y());
  std::printf("state hash %s\n", world.hash().text().c_str());
}
