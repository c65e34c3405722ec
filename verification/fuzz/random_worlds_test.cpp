/// \file
/// \brief Promises of the techniques, on random worlds: few in each run, thousands in the long tests.
#include "tumble/dynamics/tolerances.hpp"

#include "fuzz/random_world.hpp"
#include "support/test.hpp"

namespace tumble::fuzz {
namespace {

struct Worst {
  double unbooked = 0.0, momentum = 0.0;
  int unfinished = 0, gained = 0, overlapping = 0;
};

Worst worst_of(std::string_view technique, std::uint64_t first, std::uint64_t count) {
  Worst worst;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    CAPTURE(technique, seed);
    const WorldVerdict v = judge(random_world(seed), technique);
    CHECK(v.thrown.empty());
    CHECK(v.finite);
    worst.unfinished += v.status == StepStatus::done ? 0 : 1;
    worst.unbooked = std::max(worst.unbooked, v.unbooked_rise);
    worst.momentum = std::max(worst.momentum, v.momentum_change);
    worst.gained += v.energy_rise > 0.01 ? 1 : 0;
    worst.overlapping += v.overlap > 0.1 ? 1 : 0;
  }
  return worst;
}

// Worlds with the largest ratio of masses, as they are and near the largest and the smallest mass.
void check_masses(std::string_view technique, std::uint64_t worlds) {
  WorldRange range{.mass_ratio = 0.99 * tolerance::largest_mass_ratio};
  for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
    for (const double scale : {1.0, 1e20, 1e-20}) {
      RandomWorld world = random_world(seed, range);
      for (SceneBox& box : world.scene.boxes) box.mass *= scale;
      const WorldVerdict v = judge(world, technique, {}, 5);
      CAPTURE(technique, seed, scale);
      CHECK(v.thrown.empty());
      CHECK(v.finite);
    }
  }
}

}  // namespace

TEST_CASE("The default technique keeps momentum and books all energy in random worlds",
          "[unit][fuzz]") {
  const Worst worst = worst_of("contact_damped", 1, 400);
  CHECK(worst.unfinished == 0);
  CHECK(worst.momentum < 1e-9);
  CHECK(worst.unbooked < 0.01);
  CHECK(worst.gained == 0);
  CHECK(worst.overlapping <= 1);  // a gram between tons
}

TEST_CASE("Boxes with unlike masses do not go deep into each other in a step", "[unit][fuzz]") {
  WorldRange range{.most_boxes = 30, .mass_ratio = 1e4, .edge_ratio = 100.0};
  // Towers in which every second box moves, and a plate whose corner turns into another box in step 36.
  const std::vector<std::pair<std::uint64_t, int>> worlds = {{41, 1}, {77, 1}, {199, 1}, {0, 37}};
  for (const auto& [seed, steps] : worlds) {
    CAPTURE(seed, steps);
    const WorldVerdict v = judge(random_world(seed, range), "contact_damped", {}, steps);
    CHECK(v.status == StepStatus::done);
    CHECK(v.overlap < 0.05);
  }
}

TEST_CASE("Boxes that turn while they touch do not sink into each other", "[unit][fuzz]") {
  WorldRange range{.most_boxes = 30, .mass_ratio = 1e4, .edge_ratio = 100.0};
  // Boxes that slide along each other while both turn: without a look at where they come to, up to a tenth of an edge.
  const std::vector<std::pair<std::uint64_t, int>> worlds = {{123, 60}, {211, 48}, {399, 12},
                                                             {799, 60}, {876, 60}, {1347, 60}};
  for (const auto& [seed, steps] : worlds) {
    CAPTURE(seed, steps);
    CHECK(judge(random_world(seed, range), "contact_damped", {}, steps).overlap < 0.02);
  }
}

TEST_CASE("Light boxes under heavy ones do not sink step by step", "[unit][fuzz]") {
  WorldRange range{.most_boxes = 30, .mass_ratio = 1e4, .edge_ratio = 100.0};
  // Towers that neither sweeps nor the direct solver finish: without normal impulses by themselves, 1.5 to 6.6 % of an edge.
  for (const std::uint64_t seed :
       {432ULL, 542ULL, 758ULL, 1142ULL, 1391ULL, 2288ULL, 2295ULL, 2382ULL, 3618ULL, 3806ULL}) {
    CAPTURE(seed);
    CHECK(judge(random_world(seed, range), "contact_damped").overlap < 0.01);
  }
}

TEST_CASE("Masses up to the limits give finite steps", "[unit][fuzz]") {
  check_masses("contact_damped", 8);
}

TEST_CASE("Masses up to the limits give finite steps with every technique", "[.long][unit][fuzz]") {
  for (const TechniqueRecipe& technique : technique_library()) check_masses(technique.name, 4);
}

TEST_CASE("The default technique in ten thousand random worlds", "[.long][unit][fuzz]") {
  const Worst worst = worst_of("contact_damped", 1000, 10000);
  CHECK(worst.unfinished == 0);
  CHECK(worst.momentum < 1e-9);
  CHECK(worst.unbooked < 0.01);
  CHECK(worst.gained <= 40);
  CHECK(worst.overlapping <= 80);
}

TEST_CASE(
    "Techniques that move with the velocities of a step's end book the energy that contacts add",
    "[unit][fuzz]") {
  for (const std::string_view technique : {"impulse", "damped", "penalty", "faure"}) {
    double unbooked = worst_of(technique, 1, 20).unbooked;
    for (const std::uint64_t seed : {346ULL, 458ULL, 558ULL, 8881ULL, 9070ULL})
      unbooked = std::max(unbooked, worst_of(technique, seed, 1).unbooked);
    CAPTURE(technique);
    CHECK(unbooked < 0.01);
  }
}

TEST_CASE("Time stepping turns no light box into a heavy one beside the one point that is known",
          "[unit][fuzz]") {
  // Light boxes that touch on one pair of edges: repair of what they turned into once lifted tons by up to all energy.
  for (const std::uint64_t seed : {77ULL, 557ULL, 1491ULL})
    CHECK(worst_of("time_stepping", seed, 1).gained == 0);
}

TEST_CASE("Timewarps keep the energy of grams that tons make turn by radians in a frame",
          "[unit][fuzz]") {
  // In one go grams turned by up to ten radians, and gained up to 21 % of all energy.
  CHECK(worst_of("timewarp_swept", 6786, 1).unbooked < 0.01);
  for (const std::uint64_t seed : {251ULL, 466ULL, 637ULL, 2955ULL})
    CHECK(worst_of("timewarp_full", seed, 1).unbooked < 0.01);
}

TEST_CASE("Sweeps that have not settled in an impact add no energy", "[unit][fuzz]") {
  // A ton that hits another one by way of grams: the lift in the step of the impact was 3.5 % of all energy.
  for (const std::uint64_t seed : {8913ULL, 9885ULL})
    CHECK(worst_of("time_stepping", seed, 1).gained == 0);
}

TEST_CASE("An impact whose friction and pushes drive each other up stays finite", "[unit][fuzz]") {
  CHECK(worst_of("timewarp_swept", 294, 1).overlapping == 0);  // 0.002 kg under 550 kg
}

TEST_CASE("Event-driven techniques keep momentum and energy in random worlds", "[unit][fuzz]") {
  const Worst analytic = worst_of("analytic", 1, 12);
  CHECK(analytic.momentum < 1e-9);
  CHECK(analytic.unbooked < 0.01);
  CHECK(analytic.gained == 0);
  // Six grams between a ton and the ground: forces of the middle of a flight once gave it a fifth of all energy by friction.
  CHECK(worst_of("analytic", 826, 1).gained == 0);
  // Light boxes that turn far in the rest of a step once lifted heavy ones by a sixth of all energy.
  CHECK(worst_of("analytic", 1172, 1).gained == 0);
  const Worst stepping = worst_of("time_stepping", 1, 20);
  CHECK(stepping.momentum < 1e-9);
}

}  // namespace tumble::fuzz
