/// \file
/// \brief The techniques that the experiments on damping compare (thesis 5.3).
///
/// A verdict that depends on constants which the thesis does not give has to hold for half and twice their
/// values too.
#pragma once

#include "tumble/impulse_damped/damped.hpp"

#include "driver/experiment.hpp"
#include "driver/side_by_side.hpp"

namespace tumble::chapters {

// Damped integration with other constants.
struct DampedVariant {
  std::string words;          // for the names of quantities; empty: as it is
  PlayedTechnique technique;  // `damped` with its scales
};

// Damped integration as it is, then with half and twice its thresholds and its factors.
inline std::vector<DampedVariant> damped_variants() {
  return {{"", {"damped"}},
          {"half the epsilons", {"damped", {"eps_scale=0.5"}}},
          {"twice the epsilons", {"damped", {"eps_scale=2"}}},
          {"half the damping", {"damped", {"k_scale=0.5"}}},
          {"twice the damping", {"damped", {"k_scale=2"}}}};
}

// What all thresholds and all factors of damped integration are scaled by.
struct DampedScales {
  const char* words = "";  // for the names of quantities; empty: as it is
  double eps = 1.0;        // [-] see DampedNumbers
  double k = 1.0;          // [-] ditto
};

// The same variants, for experiments that make the technique themselves.
inline constexpr std::array<DampedScales, 4> other_scales{{{"thresholds halved", 0.5, 1.0},
                                                           {"thresholds doubled", 2.0, 1.0},
                                                           {"damping half as fast", 1.0, 0.5},
                                                           {"damping twice as fast", 1.0, 2.0}}};

// Options of damped integration.
inline DampedOptions damped_options(const std::string& parts, const DampedScales& scales,
                                    int seed) {
  DampedOptions options{.damping = damping_parts_from(parts)};
  options.numbers.eps_scale = scales.eps;
  options.numbers.k_scale = scales.k;
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

// The technique with Coulomb's friction that damped integration is compared with.
inline PlayedTechnique coulomb_technique() { return {"contact_damped"}; }

// A film of both on one scene, seen from the side, the damped one on the left.
// duration: [s] of the runs
inline std::string film_of_both(const Scene& scene, double duration) {
  return film_beside(frames_of_run(scene, {"damped"}, 0.0, duration),
                     frames_of_run(scene, coulomb_technique(), 0.0, duration), Vec3(0.1, 0.3, 1.0),
                     240, 120);
}

}  // namespace tumble::chapters
