/// \file
/// \brief Noise in the impacts of a technique.
#include "tumble/previous_work/noisy_impacts.hpp"

#include "support/test.hpp"

namespace {

// Two boxes that fly into each other without gravity, or one onto the ground with it.
World meeting(std::uint64_t seed, bool ground) {
  Random chance(seed);
  World world;
  if (ground) world.add_ground(0.4, 0.3);
  if (!ground) world.gravity_w = Vec3::Zero();
  for (int k = 0; k < 2; ++k) {
    const double mass = chance.uniform(0.5, 3.0);
    const double e = chance.uniform(0.0, 0.9);
    const Quat turned = chance.orientation();
    const Vec3 spin_w = chance.in_cube(3.0);
    const Vec3 at_w(0.0, ground ? 0.8 + k : 1.0, ground ? 2.0 * k : 1.2 * k);
    const Vec3 fast_w(0.3, ground ? -2.0 : 0.0, ground ? 0.0 : 2.0 - 4.0 * k);
    world.add(box_properties(Vec3(0.5, 0.7, 0.4), mass, 0.4, e), at_w, turned, fast_w, spin_w);
  }
  return world;
}

}  // namespace

TEST_CASE("Noise in impacts keeps momentum and never adds energy beyond restitution",
          "[unit][sampling]") {
  int impacts = 0;
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const char* name : {"contact_damped", "time_stepping", "basic"}) {
      const bool ground = seed % 2 == 0;
      World world = meeting(seed, ground);
      World plain = world;
      // Far more noise than is the default: every bound has work to do.
      NoisyImpacts noisy(make_technique(name), ImpactNoise(Random(seed)),
                         {.normal = 0.5, .restitution = 0.5});
      const auto quiet = make_technique(name);
      double energy = energy_of(world).total();
      const Vec3 momentum_w = linear_momentum(world);
      for (int k = 0; k < 40 && noisy.impacts().empty(); ++k) {
        const StepReport report = noisy.step(world, kFrame);
        quiet->step(plain, kFrame);
        const double after = energy_of(world).total();
        INFO(name << ", seed " << seed << ", step " << k);
        // Rounding, and what the technique itself adds as it turns bodies and repairs overlap; measured 1e-5 J.
        CHECK(after <= energy + 1e-3);
        CHECK(std::abs(after - energy - report.energy.total()) < 2e-2);
        energy = after;
      }
      if (!ground) CHECK((linear_momentum(world) - momentum_w).norm() < 1e-12);
      impacts += static_cast<int>(noisy.impacts().size());
      changed += world.hash().value() != plain.hash().value() ? 1 : 0;
    }
  }
  CHECK(impacts > 100);
  CHECK(changed > 100);  // so noise is not just left out
}

TEST_CASE("Without noise a wrapped technique has its own bits", "[determinism][sampling]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    World world = meeting(2, true);
    World plain = world;
    NoisyImpacts noisy(make_technique(recipe.name), ImpactNoise(Random(1)), {.speed = 1e9});
    const auto alone = make_technique(recipe.name);
    for (int k = 0; k < 60; ++k) {
      noisy.step(world, kFrame);
      alone->step(plain, kFrame);
    }
    INFO(recipe.name);
    CHECK(world.hash().text() == plain.hash().text());
    CHECK(noisy.impacts().empty());
  }
}

TEST_CASE("A copy of a technique with noise goes on with the same bits",
          "[determinism][sampling]") {
  World world = meeting(4, true);
  NoisyImpacts noisy(make_technique("contact_damped"), ImpactNoise(Random(9)));
  for (int k = 0; k < 25; ++k) noisy.step(world, kFrame);
  REQUIRE_FALSE(noisy.impacts().empty());
  World other = world;
  const auto copy = noisy.clone();
  for (int k = 0; k < 60; ++k) {
    noisy.step(world, kFrame);
    copy->step(other, kFrame);
  }
  CHECK(world.hash().text() == other.hash().text());
}

TEST_CASE("The values of one impact change nothing before it", "[unit][sampling]") {
  const auto run_with = [](const ImpactNoise& noise, std::vector<std::string>& hashes) {
    World world = meeting(4, true);
    NoisyImpacts noisy(make_technique("contact_damped"), noise);
    for (int k = 0; k < 120; ++k) {
      noisy.step(world, kFrame);
      hashes.push_back(world.hash().text());
      if (noisy.impacts().size() > 1) break;
    }
    return std::vector<ImpactName>(noisy.impacts().begin(), noisy.impacts().end());
  };
  std::vector<std::string> before;
  std::vector<std::string> after;
  ImpactNoise noise(Random(2));
  const auto impacts = run_with(noise, before);
  REQUIRE(impacts.size() > 1);
  noise.set(impacts[1], {0.1, 0.9, 0.3});
  noise.set({impacts[0].first, impacts[0].second, 1}, {0.1, 0.9, 0.3});
  CHECK(run_with(noise, after) == impacts);
  REQUIRE(after.size() == before.size());
  before.pop_back();
  after.pop_back();
  CHECK(after == before);
}

TEST_CASE("Noise out of range is refused", "[unit][sampling]") {
  for (const ImpactNoiseOptions& options :
       {ImpactNoiseOptions{.speed = -1.0}, ImpactNoiseOptions{.normal = 2.0},
        ImpactNoiseOptions{.restitution = -0.1}, ImpactNoiseOptions{.normal = kNan}})
    CHECK_THROWS_AS(NoisyImpacts(make_technique("basic"), ImpactNoise(), options),
                    std::invalid_argument);
  CHECK_THROWS_AS(NoisyImpacts(nullptr, ImpactNoise()), std::invalid_argument);
}
