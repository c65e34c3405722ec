/// \file
/// \brief The energy that pushes out of overlap add, and what the damping takes from a heap (thesis 4.4, 5.3).
#include "impulse_damped/damping_heap.hpp"

#include "tumble/impulse_damped/fix_contact_constraints.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "driver/played_scene.hpp"
#include "impulse_damped/settled_boxes.hpp"

namespace tumble::chapters {
namespace {

// What is booked while a heap settles.
struct Heap {
  double damping = 0.0;  // [J] added; below 0: taken
  double pushes = 0.0;   // [J] added
  double gains = 0.0;    // steps in which damping adds energy
  double steps = 0.0;
  std::vector<std::array<double, 3>> path = {};  // time, damping, pushes: sums
};

Heap heap_of(const Vec3& size, int seed, double duration) {
  World world = clump(3, seed);
  if (size != Vec3::Ones()) {
    World bricks;
    bricks.add_ground(0.5, 0.0);
    for (int k = 1; k < world.count(); ++k)
      bricks.add(box_properties(size, 1.0), world.states()[static_cast<std::size_t>(k)]);
    world = bricks;
  }
  Damped technique({.seed = static_cast<std::uint64_t>(seed)});
  Heap heap;
  while (world.time() < duration - 0.5 * kStep) {
    const StepReport report = finished(technique.step(world, kStep));
    heap.damping += report.energy.damping;
    heap.pushes += report.energy.repair;
    heap.gains += report.energy.damping > 0.0 ? 1.0 : 0.0;
    heap.steps += 1.0;
    heap.path.push_back({world.time(), heap.damping, heap.pushes});
  }
  return heap;
}

// [-] over m g L: what pushes out of the ground add to a cube beyond the end of the overlap, at
// most.
double push_too_far(int states, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  PairGatherer areas(NormalRule::separation, PointRule::area);
  FixContactConstraints fix;
  ContactList contacts;
  World world;
  world.add_ground(0.0, 0.0);
  world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  double most = 0.0;
  for (int n = 0; n < states; ++n) {
    const double depth = random.uniform(0.0, 3e-3);  // [m]: a fall through one step
    world.states()[1].position_w = Vec3(0.0, 0.5 - depth, 0.0);
    areas.gather(world, world.states(), world.states(), nullptr, 0.0, contacts);
    const double added = fix.run(world, contacts, DampedNumbers{}, kStep).energy;
    most = std::max(most, added / 9.81 - depth);
  }
  return most;
}

}  // namespace

Quantity largest_found(const std::string& name, std::span<const double> values) {
  return {name, "-", *std::ranges::max_element(values)};
}

void add_push_energy(int states, int seeds, Result& result) {
  std::vector<double> found;
  for (int seed = 1; seed <= seeds; ++seed) found.push_back(push_too_far(states, seed));
  result.add(largest_found(
      "potential energy that pushes add beyond the end of the overlap, over m g L", found));
}

void add_heap_energy(int seeds, double duration, Result& result) {
  Table table{"heap",
              {{"time_s", "s", "time"},
               {"cubes_damping_J", "J", "27 cubes: taken by the damping since the start"},
               {"cubes_pushes_J", "J", "27 cubes: added by pushes since the start"},
               {"bricks_damping_J", "J", "27 bricks: taken by the damping since the start"},
               {"bricks_pushes_J", "J", "27 bricks: added by pushes since the start"}}};
  std::array<std::vector<Heap>, 2> heaps;
  for (int seed = 1; seed <= seeds; ++seed) {
    heaps[0].push_back(heap_of(Vec3::Ones(), seed, duration));
    heaps[1].push_back(heap_of(Vec3(1.0, 0.5, 0.5), seed, duration));
  }
  for (std::size_t n = 0; n < heaps[0][0].path.size(); ++n) {
    const std::array<double, 3>& cubes = heaps[0][0].path[n];
    const std::array<double, 3>& bricks = heaps[1][0].path[n];
    table.add(cubes[0], -cubes[1], cubes[2], -bricks[1], bricks[2]);
  }
  result.tables.push_back(table);
  static constexpr std::array<const char*, 2> kNames{"cubes", "bricks"};
  for (std::size_t h = 0; h < 2; ++h) {
    const auto ratio = [&](const std::string& name, double Heap::*top, double Heap::*bottom,
                           double sign) {
      result.add(over_seeds(name, "-", seeds, [&](int left_out) {
        double above = 0.0;
        double below = 0.0;
        for (std::size_t k = 0; k < heaps[h].size(); ++k) {
          if (static_cast<int>(k) == left_out) continue;
          above += heaps[h][k].*top;
          below += heaps[h][k].*bottom;
        }
        return sign * above / below;
      }));
    };
    const std::string heap = std::string(", heap of 27 ") + kNames[h];
    ratio("steps in which damping adds energy, over all" + heap, &Heap::gains, &Heap::steps, 1.0);
    ratio("energy that pushes add over what damping takes" + heap, &Heap::pushes, &Heap::damping,
          -1.0);
  }
}

}  // namespace tumble::chapters
