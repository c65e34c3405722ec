/// \file
/// \brief The techniques that the experiments on damping compare.
#include "impulse_damped/damped_variants.hpp"

namespace tumble::chapters {

std::vector<DampedVariant> damped_variants() {
  return {{"", {"damped"}},
          {"half the epsilons", {"damped", {"eps_scale=0.5"}}},
          {"twice the epsilons", {"damped", {"eps_scale=2"}}},
          {"half the damping", {"damped", {"k_scale=0.5"}}},
          {"twice the damping", {"damped", {"k_scale=2"}}}};
}

PlayedTechnique coulomb_technique() { return {"contact_damped"}; }

}  // namespace tumble::chapters
