/// \file
/// \brief Motions of a scene that are sampled until they meet its wishes (thesis 2.4.2).
#pragma once

#include "tumble/previous_work/noise_chain.hpp"
#include "tumble/previous_work/noisy_impacts.hpp"
#include "tumble/record/run.hpp"

#include <atomic>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// A scene and a technique that are run many times, each time with other noise in the impacts.
///
/// The violation of a motion is that of the scene's wishes at its end. It is infinite if a step was not done or a check of
/// the run failed.
/// \verified{What a chain finds meets the wishes when it is run again}
class SceneSampler {
 public:
  /// Makes a sampler.
  /// \param scene      with one wish or more
  /// \param technique  at its start; every motion gets a copy
  /// \throws SceneMistake as checked() does
  /// \throws std::invalid_argument for a scene without wishes, a wish about a box that is not there at the end,
  ///         no technique, or settings or options out of range
  SceneSampler(Scene scene, std::unique_ptr<Technique> technique, const RunSettings& settings,
               const ImpactNoiseOptions& noise);

  /// The motion of some noise. Several threads may call it at once.
  /// \param stop   ends it unfinished; may be empty
  /// \return its impacts and its violation
  /// \throws std::invalid_argument if the technique refuses the scene
  [[nodiscard]] NoisyMotion motion(const ImpactNoise& noise,
                                   const std::function<bool()>& stop = {}) const;

  /// Runs the motion of some noise as run_simulation() does.
  /// \throws std::invalid_argument as run_scene() does
  RunResult run(const ImpactNoise& noise, std::span<RunObserver* const> observers) const;

  /// motion(), for chains.
  /// \param stop  ends motions unfinished; has to live as long as the function returned
  /// \return a function that calls it
  [[nodiscard]] SimulateNoise simulate(const std::atomic<bool>& stop) const;

  /// The scene.
  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  std::unique_ptr<Technique> technique_;
  RunSettings settings_;
  ImpactNoiseOptions noise_;
};

/// Chains with streams of their own.
/// \param seed        names all of them
/// \param count       how many, at least 1
/// \param strictness  [-] see NoiseChain
/// \return without states
/// \throws std::invalid_argument for a count or a strictness out of range
std::vector<NoiseChain> make_chains(std::uint64_t seed, int count, double strictness);

/// The proposals of a chain as a comma-separated table.
/// \param proposals  the start first
/// \return the content of a file; read_chain() gives the same bits
std::string chain_table(std::span<const NoiseProposal> proposals);

/// Reads the proposals of a chain.
/// \param path  a file of chain_table(), of at most 256 MiB
/// \return the start first
/// \throws std::invalid_argument "FILE:LINE: what would be right", or if it cannot be read
std::vector<NoiseProposal> read_chain(const std::filesystem::path& path);

}  // namespace tumble
