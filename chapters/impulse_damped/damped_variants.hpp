/// \file
/// \brief The techniques that the experiments on damping compare (thesis 5.3).
#pragma once

#include "driver/played_scene.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// Damped integration, and the same with half and twice its thresholds and factors (thesis 5.3): a
/// verdict that hangs on constants which the thesis does not give has to hold for all of them.
struct DampedVariant {
  std::string words;          ///< for the names of quantities; empty: as it is
  PlayedTechnique technique;  ///< `damped` with its scales
};

/// The five of them, damped integration as it is being the first.
/// \return with eps_scale 0.5 and 2, and with k_scale 0.5 and 2
std::vector<DampedVariant> damped_variants();

/// The technique with Coulomb's friction that damped integration is compared with.
/// \return the default technique of the library
PlayedTechnique coulomb_technique();

}  // namespace tumble::chapters
