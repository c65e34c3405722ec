/// \file
/// \brief One mass on a spring and a damper.
#include "tumble/base/error.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/previous_work/penalty.hpp"

#include <cmath>
#include <numbers>

namespace tumble {
namespace {

constexpr int kHalvings = 52;  // of the interval from 0 to 1, down to rounding

}  // namespace

double stable_step(PenaltyScheme scheme, const PenaltyLaw& law) {
  require::positive(law.frequency, "frequency");
  require::not_negative(law.damping, "damping");
  const double zeta = law.damping;
  if (scheme == PenaltyScheme::semi_implicit)
    return 2.0 / (zeta + std::sqrt(1.0 + zeta * zeta)) / law.frequency;
  if (zeta <= 1.0) return 2.0 * zeta / law.frequency;
  return 2.0 / (zeta + std::sqrt(zeta * zeta - 1.0)) / law.frequency;
}

double penalty_restitution(double damping, bool pull) {
  require::not_negative(damping, "damping");
  const double root = std::sqrt(std::abs(1.0 - damping * damping));
  if (pull) return damping < 1.0 ? elementary::exp(-std::numbers::pi * damping / root) : 0.0;
  if (root == 0.0) return elementary::exp(-2.0);
  // Above critical damping the angle is imaginary: arcosh in place of arccos.
  const double angle = damping < 1.0 ? elementary::acos(damping) : elementary::log(damping + root);
  return elementary::exp(-2.0 * damping * angle / root);
}

double penalty_damping_for(double restitution, bool pull) {
  require::within(restitution, 0.0, 1.0, "restitution");
  if (restitution <= penalty_restitution(1.0, pull)) return 1.0;
  double low = 0.0, high = 1.0;  // the restitution falls as damping rises
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (penalty_restitution(middle, pull) > restitution ? low : high) = middle;
  }
  return restitution < 1.0 ? high : 0.0;
}

}  // namespace tumble
