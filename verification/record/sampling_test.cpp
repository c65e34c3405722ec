/// \file
/// \brief Motions that are sampled until they meet the wishes of a scene.
#include "tumble/record/sampling.hpp"

#include "tumble/previous_work/parallel_chains.hpp"

#include "support/test.hpp"

namespace {

constexpr RunSettings kShort{.duration = 1.0};

// A die of 2 cm that falls from 20 cm.
Scene thrown_die() {
  Scene scene{.ground = SceneGround{}};
  scene.boxes.push_back({.name = "die",
                         .size = Vec3::Constant(0.02),
                         .mass = 0.01,
                         .position_w = {0.0, 0.2, 0.0},
                         .orientation_wb = Quat(0.8, 0.6, 0.0, 0.0),
                         .angular_velocity_w = {3.0, 10.0, 5.0},
                         .restitution = 0.3});
  scene.wishes = {{.kind = WishKind::face_up, .bodies = {"die"}, .face = 4}};
  return scene;
}

SceneSampler sampler_of(const Scene& scene, std::string_view technique = kDefaultTechnique,
                        const RunSettings& settings = kShort) {
  return {scene, make_technique(technique), settings, {}};
}

}  // namespace

TEST_CASE("What a chain finds meets the wishes when it is run again", "[unit][sampling]") {
  const SceneSampler sampler = sampler_of(thrown_die());
  std::atomic<bool> stop = false;
  std::vector<NoiseChain> chains = make_chains(2, 2, 10.0);
  run_chains(chains, {.found = 2, .proposals = 100}, sampler.simulate(stop), 2, stop);
  std::set<std::string> hashes;
  for (const NoiseChain& chain : chains) {
    REQUIRE(chain.found().size() == 2);
    for (const FoundMotion& found : chain.found()) {
      CHECK(sampler.motion(found.noise).violation == 0.0);
      const RunResult result = sampler.run(found.noise, {});
      CHECK(result.worst == StepStatus::done);
      hashes.insert(result.state_hash);
    }
  }
  CHECK(hashes.size() == 4);
}

TEST_CASE("Chains of a scene have the same bits on any number of cores",
          "[determinism][sampling]") {
  std::vector<std::string> tables;
  for (const int cores : {1, 2, 3}) {
    const SceneSampler sampler = sampler_of(thrown_die());
    std::atomic<bool> stop = false;
    std::vector<NoiseChain> chains = make_chains(4, 3, 10.0);
    run_chains(chains, {.found = 100, .proposals = 15}, sampler.simulate(stop), cores, stop);
    std::string all;
    for (const NoiseChain& chain : chains) all += chain_table(chain.proposals());
    tables.push_back(all);
  }
  CHECK(tables[0] == tables[1]);
  CHECK(tables[0] == tables[2]);
}

TEST_CASE("A motion that is no valid one has an infinite violation", "[unit][sampling]") {
  // The basic technique meets its cap on events, or repairs what does not rest.
  Scene scene = thrown_die();
  scene.boxes[0].restitution = 0.0;
  scene.wishes = {{.kind = WishKind::moves, .bodies = {"die"}, .distance = 1e-3}};
  const SceneSampler sampler = sampler_of(scene, "basic");
  const RunResult result = sampler.run(ImpactNoise(Random(1)), {});
  REQUIRE(result.worst != StepStatus::done);
  CHECK(sampler.motion(ImpactNoise(Random(1))).violation == kInfinity);
}

TEST_CASE("A motion that is asked to stop is not finished", "[unit][sampling]") {
  const SceneSampler sampler = sampler_of(thrown_die());
  int steps = 0;
  CHECK_FALSE(sampler.motion(ImpactNoise(), [&] { return ++steps > 10; }).finished);
  CHECK(steps == 11);
  std::atomic<bool> stop = true;
  CHECK_FALSE(sampler.simulate(stop)(ImpactNoise()).finished);
  stop = false;
  CHECK(sampler.simulate(stop)(ImpactNoise()).finished);
}

TEST_CASE("Sampling works with every technique that reports its impacts", "[unit][sampling]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    const NoisyMotion motion =
        sampler_of(thrown_die(), recipe.name, {.duration = 0.4}).motion(ImpactNoise(Random(1)));
    const std::set<std::string_view> silent = {"glued", "penalty", "settling"};
    INFO(recipe.name);
    CHECK(motion.finished);
    CHECK(motion.impacts.empty() == (silent.count(recipe.name) > 0));
  }
}

TEST_CASE("What cannot be sampled is refused before anything is simulated", "[unit][sampling]") {
  Scene scene = thrown_die();
  scene.wishes.clear();
  CHECK_THROWS_WITH(sampler_of(scene), Contains("the scene has no wish: add a table [[wish]]"));
  scene = thrown_die();
  scene.boxes.push_back({.name = "late", .position_w = {5.0, 2.0, 0.0}, .appears = 3.0});
  scene.wishes.push_back({.kind = WishKind::stays, .bodies = {"late"}});
  CHECK_THROWS_WITH(sampler_of(scene), Contains("wish[2].body = late: it appears at 3 s"));
  scene.boxes.back().appears = 0.0;
  scene.boxes.back().disappears = 0.5;
  CHECK_THROWS_WITH(sampler_of(scene), Contains("it disappears at 0.5 s"));
  CHECK_THROWS_AS(sampler_of(thrown_die(), kDefaultTechnique, {.dt = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(SceneSampler(thrown_die(), nullptr, kShort, {}), std::invalid_argument);
}
