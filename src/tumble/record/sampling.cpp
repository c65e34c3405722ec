/// \file
/// \brief Motions of a scene with noise.
#include "tumble/record/sampling.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"

#include <algorithm>
#include <utility>

namespace tumble {
namespace {

constexpr std::uint64_t kStreamOfChains = 242;  // apart from those of scenes and techniques

// Wishes are about the end, and so are their boxes.
void require_there_at_the_end(const Scene& scene, double duration) {
  for (std::size_t i = 0; i < scene.wishes.size(); ++i) {
    for (const SceneBox& box : scene.boxes) {
      const std::vector<std::string>& names = scene.wishes[i].bodies;
      if (std::find(names.begin(), names.end(), box.name) == names.end()) continue;
      const std::string begin = "wish[" + std::to_string(i + 1) + "].body = " + box.name + ": it ";
      const std::string end = " s, and wishes are about the end, at " + shortest_text(duration) +
                              " s: change the duration";
      require::that(box.appears < duration || box.appears == 0.0,
                    begin + "appears at " + shortest_text(box.appears) + end);
      require::that(box.disappears > duration,
                    begin + "disappears at " + shortest_text(box.disappears) + end);
    }
  }
}

}  // namespace

SceneSampler::SceneSampler(Scene scene, std::unique_ptr<Technique> technique,
                           const RunSettings& settings, const ImpactNoiseOptions& noise)
    : scene_(checked(std::move(scene))),
      technique_(std::move(technique)),
      settings_(settings),
      noise_(noise) {
  require::that(technique_ != nullptr, "technique is null: expected one");
  require_run_settings(settings_);
  require_valid(noise_);
  require::that(!scene_.wishes.empty(),
                "the scene has no wish: add a table [[wish]] with kind and body to its file");
  require_there_at_the_end(scene_, settings_.duration);
}

NoisyMotion SceneSampler::motion(const ImpactNoise& noise,
                                 const std::function<bool()>& stop) const {
  auto technique = std::make_unique<NoisyImpacts>(technique_->clone(), noise, noise_);
  const NoisyImpacts& impacts = *technique;
  Simulation simulation(scene_, std::move(technique));
  const RunResult result = run_simulation(simulation, settings_, {}, stop);
  NoisyMotion motion;
  motion.impacts.assign(impacts.impacts().begin(), impacts.impacts().end());
  motion.finished = result.end != RunEnd::interrupted;
  if (result.worst == StepStatus::done && result.refusal.empty())
    motion.violation = violation(scene_, simulation.world());
  return motion;
}

RunResult SceneSampler::run(const ImpactNoise& noise,
                            std::span<RunObserver* const> observers) const {
  NoisyImpacts technique(technique_->clone(), noise, noise_);
  return run_scene(scene_, technique, settings_, observers);
}

SimulateNoise SceneSampler::simulate(const std::atomic<bool>& stop) const {
  return [this, &stop](const ImpactNoise& noise) {
    return motion(noise, [&stop] { return stop.load(); });
  };
}

std::vector<NoiseChain> make_chains(std::uint64_t seed, int count, double strictness) {
  require::that(count >= 1, "chains = " + std::to_string(count) + ": expected 1 or more");
  const Random all = Random(seed).fork(kStreamOfChains);
  std::vector<NoiseChain> chains;
  for (int k = 0; k < count; ++k)
    chains.emplace_back(all.fork(static_cast<std::uint64_t>(k)), strictness);
  return chains;
}

}  // namespace tumble
