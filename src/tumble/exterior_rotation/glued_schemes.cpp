/// \file
/// \brief Names of the schemes of the glued technique.
#include "tumble/exterior_rotation/glued.hpp"

#include <array>

namespace tumble {
namespace {

constexpr std::array kSchemes = {GluedScheme::rk4,           GluedScheme::dormand_prince,
                                 GluedScheme::midpoint,      GluedScheme::forward_euler,
                                 GluedScheme::semi_implicit, GluedScheme::impulse,
                                 GluedScheme::leapfrog};

}  // namespace

std::span<const GluedScheme> glued_schemes() { return kSchemes; }

std::string_view name_of(GluedScheme scheme) {
  switch (scheme) {
    case GluedScheme::rk4: return "rk4";
    case GluedScheme::dormand_prince: return "dormand_prince";
    case GluedScheme::midpoint: return "midpoint";
    case GluedScheme::forward_euler: return "forward_euler";
    case GluedScheme::semi_implicit: return "semi_implicit";
    case GluedScheme::impulse: return "impulse";
    case GluedScheme::leapfrog: return "leapfrog";
  }
  return "";
}

}  // namespace tumble
