/// \file
/// \brief The energy that each stage of the damping adds at random states (thesis 5.3).
#include "tumble/impulse_damped/dampen_objects.hpp"

#include "impulse_damped/damped_variants.hpp"
#include "impulse_damped/damping_heap.hpp"

namespace tumble::chapters {
namespace {

// The stages of the damping, by its parts, in the order in which they are done: scaling, settling of aligned boxes,
// turning upright, slow components, small moves undone.
constexpr std::array<std::string_view, 5> kStages{"scale", "align", "tilt", "small", "freeze"};

// [any] 10^x with x uniform between those of two numbers, and a random sign.
double any_size(double low, double high, Random& random) {
  const double size = low * elementary::pow(high / low, random.unit());
  return random.unit() < 0.5 ? -size : size;
}

// A random state of a box. Sizes of momenta reach from well below the thresholds to well above.
BodyState random_state(const BodyProperties& box, Random& random) {
  const DampedThresholds eps = thresholds_of(DampedNumbers{}, box, 9.81, kStep);
  BodyState state{.position_w = Vec3(0.0, 10.0, 0.0), .orientation_wb = random.orientation()};
  if (random.unit() < 0.5) {
    // A face nearly level: put upright, then turned by a small angle.
    const Quat upright = tilted_towards_y_axis(state.orientation_wb, 10.0);
    state.orientation_wb =
        normalised(rotation_from_vector(2.0 * eps.aligned * random.in_cube(1.0)) * upright);
  }
  for (int i = 0; i < 3; ++i) {
    state.linear_momentum_w[i] = any_size(0.01 * eps.still, 10.0 * eps.slow, random);
    state.angular_momentum_w[i] = any_size(0.01 * eps.still_spin, 10.0 * eps.slow_spin, random);
  }
  return state;
}

// One box in the air that has been touched, and the damping of one step.
class Bench {
 public:
  Bench(const Vec3& size, const DampedNumbers& numbers) : numbers_(numbers) {
    world_.add(box_properties(size, 1.0), BodyState{});
  }
  const BodyProperties& box() const { return world_.bodies()[0]; }

  // [-] kinetic energy after a stage over that before.
  double factor(const BodyState& state, std::string_view stage) {
    const double before = kinetic_energy(box(), state);
    world_.states()[0] = state;
    if (stage != "freeze") return (before + run(damping_parts_from(stage)).energy) / before;
    run(damping_parts_from("none"));
    const double moved = kinetic_energy(box(), world_.states()[0]);
    world_.states()[0] = state;
    if (run(damping_parts_from("freeze")).frozen == 0) return 0.0;
    return kinetic_energy(box(), world_.states()[0]) / moved;
  }

 private:
  DampingReport run(const DampingParts& parts) {
    const char touched = 1;
    return damping_.run(world_, {&touched, 1}, numbers_, parts, kStep, RotationRule::splitting);
  }

  World world_;
  DampedNumbers numbers_;
  ObjectDamping damping_;
};

// The largest factor of a stage that each seed finds.
std::vector<double> largest(const Vec3& size, std::string_view stage, const DampedNumbers& numbers,
                            int states, int seeds, int after = 0) {
  Bench bench(size, numbers);
  std::vector<double> found;
  for (int seed = after + 1; seed <= after + seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    double most = 0.0;
    for (int n = 0; n < states; ++n)
      most = std::max(most, bench.factor(random_state(bench.box(), random), stage));
    found.push_back(most);
  }
  return found;
}

// Of each seed the largest of both.
std::vector<double> larger(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = std::max(a[k], b[k]);
  return a;
}

Result measure_damping_energy(const Parameters& settings) {
  const int states = settings.count("states");
  const int seeds = settings.count("seeds");
  const Vec3 cube = Vec3::Ones();
  const Vec3 brick(2.0, 1.0, 1.0);
  Result result;

  // Each stage, cubes and bricks.
  Table table{"",
              {{"stage", "-",
                "1 scaling, 2 settling, 3 turning upright, 4 slow components, 5 moves "
                "undone"},
               {"cube", "-", "largest factor of the kinetic energy of a cube"},
               {"brick", "-", "the same, brick of 2 x 1 x 1"}}};
  std::vector<double> most(static_cast<std::size_t>(seeds), 0.0);
  for (std::size_t s = 0; s < kStages.size(); ++s) {
    const auto of_cube = largest(cube, kStages[s], DampedNumbers{}, states, seeds);
    const auto of_brick = largest(brick, kStages[s], DampedNumbers{}, states, seeds);
    table.add(s + 1, largest_found("", of_cube).value, largest_found("", of_brick).value);
    most = larger(larger(most, of_cube), of_brick);
  }
  result.add(largest_found(
      "largest factor by which a stage of the damping raises the kinetic energy of a body", most));
  std::vector<double> fresh(static_cast<std::size_t>(seeds), 0.0);
  for (const std::string_view stage : kStages)
    for (const Vec3& size : {cube, brick})
      fresh = larger(fresh, largest(size, stage, DampedNumbers{}, states, seeds, seeds));
  result.add(largest_found(
      "largest factor by which a stage of the damping raises the kinetic energy of a body, fresh "
      "seeds",
      fresh));

  // Other constants: the stage that decides is the one of slow components.
  const std::string_view slow = kStages[3];
  for (const DampedScales& scales : other_scales)
    result.add(largest_found(
        std::string("the same, slow components, ") + scales.words,
        largest(brick, slow, damped_options("all", scales, 1).numbers, states, seeds)));

  // Bricks of several lengths. Of a spin in the plane of two axes with moments Ia and Ib, tilted by
  // 45 degrees, one component is left as it is and the other one becomes k times as large. With
  // c = (Ia + Ib)² / (4 Ia Ib) the energy grows by t + sqrt(t² - k²) at most, where
  // t = (c (1 - k)² + 2 k) / 2.
  Table shapes{"shape",
               {{"length", "-", "of a brick, over its other edges"},
                {"largest", "-", "largest factor found, slow components"},
                {"shrunk", "-", "in closed form, one component of a plane spin shrunk"},
                {"ended", "-", "in closed form, one component ended"}}};
  for (int length = 1; length <= settings.count("longest"); ++length) {
    const Vec3 size(length, 1.0, 1.0);
    const auto found = largest(size, slow, DampedNumbers{}, states, seeds);
    const Vec3 moments = box_properties(size, 1.0).inertia_b;
    const double c = (moments.x() + moments.y()) * (moments.x() + moments.y()) /
                     (4.0 * moments.x() * moments.y());
    const double k = factors_of(DampedNumbers{}, kStep).slow_spin;
    const double t = 0.5 * (c * (1.0 - k) * (1.0 - k) + 2.0 * k);
    const double shrunk = t + std::sqrt(t * t - k * k);
    const Quantity most_found =
        largest_found("largest factor, slow components, brick of 4 x 1 x 1", found);
    shapes.add(length, most_found.value, shrunk, c);
    if (length == 1) result.add(largest_found("largest factor, slow components, cube", found));
    if (length == 2)
      result.add("the same in closed form, slow components, brick of 2 x 1 x 1", "-", shrunk);
    if (length != 4) continue;
    result.add(most_found);
    result.add("the same in closed form, one component shrunk", "-", shrunk);
    result.add("the same in closed form, one component ended", "-", c);
  }
  result.tables = {table, shapes};

  add_push_energy(states, seeds, result);
  add_heap_energy(seeds, settings.number("duration"), result);
  return result;
}

const Registered claim_5_3a_energy_figure{
    {.name = "claim_5_3a_energy",
     .parameters = {whole("states", 5000, 10, 10000000, "random states of each seed and stage"),
                    whole("seeds", 20, 2, 1000, "streams of random states, and heaps"),
                    whole("longest", 8, 1, 100,
                          "length of the longest brick, over its other edges"),
                    number("duration", 3.0, 0.1, 60.0, "s", "of the heaps")},
     .quick = {"states=2000", "seeds=2", "longest=4", "duration=1.5"},
     .experiment = measure_damping_energy}};

}  // namespace
}  // namespace tumble::chapters
