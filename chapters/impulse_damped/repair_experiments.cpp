/// \file
/// \brief The energy that the pass adds which ends overlap by moving bodies (thesis 4.4).
#include "tumble/contact/repair.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/impulse_damped/damped.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

enum class Pass { none, listing, ours };

World pressed_stack(int boxes, double restitution, double depth, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  World world;
  world.add_ground(0.5, restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.5, restitution);
  double height = 0.0;
  for (int k = 0; k < boxes; ++k) {
    height += 1.0 - depth * random.uniform(0.0, 1.0);
    world.add(cube, Vec3(0.0, height - 0.5, 0.0));
  }
  return world;
}

void run_pass(Pass pass, World& world) {
  if (pass == Pass::listing) {
    PairGatherer areas(NormalRule::separation, PointRule::area);
    ContactList contacts;
    areas.gather(world, world.states(), world.states(), nullptr, 0.0, contacts);
    FixContactConstraints fix;
    fix.run(world, contacts, DampedNumbers{}, kStep);
  } else if (pass == Pass::ours) {
    std::vector<Bounds> bounds;
    std::vector<IndexPair> pairs;
    repair_bounds(world, 0.0, bounds);
    BoundingTree().find_pairs(bounds, pairs);
    OverlapRepair repair;
    repair.run(world, pairs);
  }
}

// Energies after each step of a second [J]; potential energy from that before the pass on.
struct Second {
  std::vector<double> kinetic;
  std::vector<double> potential;
  double added = 0.0;  // potential energy by the pass
};

// The second goes on without further passes: pushes of length 0 move no body.
DampedOptions thesis() {
  DampedOptions options;
  options.numbers.eps1 = 0.0;
  options.noise.where = Randomness::off;
  return options;
}

// Shock propagation by impulses, the method that the pass takes the place of.
DampedOptions velocities_stopped() {
  DampedOptions options = thesis();
  options.damping = damping_parts_from("none");
  options.stable_boxes = StableRule::off;
  options.shock = decltype(options.shock)::velocity;
  return options;
}

Second watch(World world, Pass pass, const DampedOptions& options) {
  Damped technique(options);
  const double before = energy_of(world).potential;
  run_pass(pass, world);
  Second out;
  out.added = energy_of(world).potential - before;
  for (int step = 0; step <= 60; ++step) {
    const Energy energy = energy_of(world);
    out.kinetic.push_back(energy.kinetic);
    out.potential.push_back(energy.potential - before);
    finished(technique.step(world, kStep));
  }
  return out;
}

// Largest kinetic energy that the run without the pass does not have [J].
double appeared(const Second& with, const Second& without) {
  return largest_of(with.kinetic, without.kinetic, std::minus<>());
}

// Over stacks: what appears and what was added.
struct Ratio {
  std::vector<double> kinetic;    // [J] of each stack
  std::vector<double> potential;  // [J]
  double velocity = 0.0;          // [J] largest kinetic energy without a pass
  double at_once = 0.0;           // [J] largest kinetic energy just after the pass
};

Ratio ratio_of(int boxes, double restitution, double depth, int seeds, Pass pass,
               const DampedOptions& options, int after = 0) {
  Ratio out;
  for (int seed = after + 1; seed <= after + seeds; ++seed) {
    const World world = pressed_stack(boxes, restitution, depth, seed);
    const Second without = watch(world, Pass::none, options);
    const Second with = watch(world, pass, options);
    out.kinetic.push_back(appeared(with, without));
    out.potential.push_back(with.added);
    out.velocity = std::max(out.velocity, *std::ranges::max_element(without.kinetic));
    out.at_once = std::max(out.at_once, with.kinetic.front());
  }
  return out;
}

double over(const Ratio& ratio) {
  return sum_without(ratio.kinetic, -1) / sum_without(ratio.potential, -1);
}

Result measure_push_energy(const Parameters& settings) {
  const int boxes = settings.count("boxes");
  const double restitution = settings.number("restitution");
  const double depth = settings.number("depth");
  const int seeds = settings.count("seeds");

  Table time{"",
             {{"time_s", "s", "after the pass"},
              {"kinetic_J", "J", "after the pass of the listing"},
              {"potential_J", "J", "the same, above that before the pass"},
              {"potential_ours_J", "J", "after OverlapRepair, above that before it"},
              {"kinetic_stopped_J", "J", "without a pass: velocities are stopped only"}}};
  const World first = pressed_stack(boxes, restitution, depth, 1);
  const std::array<Second, 3> runs = {watch(first, Pass::listing, thesis()),
                                      watch(first, Pass::ours, thesis()),
                                      watch(first, Pass::none, velocities_stopped())};
  for (std::size_t k = 0; k < runs[0].kinetic.size(); ++k)
    time.add(kStep * static_cast<double>(k), runs[0].kinetic[k], runs[0].potential[k],
             runs[1].potential[k], runs[2].kinetic[k]);

  Table sweep{"depth",
              {{"depth_m", "m", "largest overlap of two cubes"},
               {"ratio", "-", "kinetic energy that appears, over potential energy that is added"},
               {"ratio_ours", "-", "the same with OverlapRepair"}}};
  for (double d = 1e-4; d < 0.2; d *= std::sqrt(10.0)) {
    const Ratio listing = ratio_of(boxes, restitution, d, seeds, Pass::listing, thesis());
    const Ratio ours = ratio_of(boxes, restitution, d, seeds, Pass::ours, thesis());
    sweep.add(d, over(listing), over(ours));
  }

  const Ratio listing = ratio_of(boxes, restitution, depth, seeds, Pass::listing, thesis());
  const Ratio dull = ratio_of(boxes, 0.0, depth, seeds, Pass::listing, thesis());
  const Ratio ours = ratio_of(boxes, restitution, depth, seeds, Pass::ours, thesis());
  const Ratio stopped =
      ratio_of(boxes, restitution, depth, seeds, Pass::none, velocities_stopped());
  const auto quantity = [](const std::string& name, const Ratio& ratio) {
    return ratio_of_sums(name, "-", ratio.kinetic, ratio.potential);
  };
  return {{time, sweep},
          {quantity("kinetic energy that appears within a second because of the pass, over the "
                    "potential energy that it adds",
                    listing),
           quantity("kinetic energy that appears within a second because of the pass, over the "
                    "potential energy that it adds, fresh seeds",
                    ratio_of(boxes, restitution, depth, seeds, Pass::listing, thesis(), seeds)),
           quantity("the same without restitution", dull),
           quantity("the same with our repair, which leaves no gap", ours),
           {"kinetic energy just after the pass", "J", listing.at_once},
           {"kinetic energy if velocities are stopped in place of the pass", "J", stopped.velocity},
           {"potential energy that the pass adds to a stack, mean", "J",
            sum_without(listing.potential, -1) / seeds}}};
}

const Registered claim_4_4a_push_energy_figure{
    {.name = "claim_4_4a_push_energy",
     .parameters =
         {whole("boxes", 5, 1, 50, "in the stack"),
          number("restitution", 0.9, 0.0, 1.0, "-", "of boxes and ground: the thesis's"),
          number("depth", 9.81 / 3600, 1e-6, 0.5, "m",
                 "largest overlap of two cubes; the default is what gravity moves in a step, g h²"),
          whole("seeds", 20, 2, 1000, "stacks")},
     .quick = {"seeds=3"},
     .experiment = measure_push_energy}};

}  // namespace
}  // namespace tumble::chapters
