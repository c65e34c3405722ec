/// \file
/// \brief The pressure of a contact patch, about whose centre friction acts (thesis 6.3.1).
#pragma once

#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_patches/contact_patch.hpp"

#include <cmath>

namespace tumble {

/// Where the pressure of a patch acts, and the lever of friction about that.
struct PatchPressure {
  double normal = 0.0;  ///< [N s] its sum
  double along = 0.0;   ///< [m] its centre
  double across = 0.0;  ///< [m] ditto
  double lever = 0.0;   ///< [N m s] sum of \f$p_i\,|s_i - c|\f$
};

/// The pressure of a patch.
/// \param patch  with the impulses of its points
/// \return all 0 if none pushes
[[nodiscard]] inline PatchPressure pressure_of(const ContactPatch& patch) {
  PatchPressure total;
  for (const ContactPatchPoint& p : patch.used()) {
    total.normal += p.impulse;
    total.along += p.impulse * p.along;
    total.across += p.impulse * p.across;
  }
  if (!(total.normal > 0.0)) return PatchPressure{};
  total.along /= total.normal;
  total.across /= total.normal;
  for (const ContactPatchPoint& p : patch.used()) {
    const double a = p.along - total.along;
    const double b = p.across - total.across;
    total.lever += p.impulse * std::sqrt(a * a + b * b);
  }
  return total;
}

/// Moment about the normal, at the middle of the patch, of friction that acts at the centre of pressure.
/// \param along   [N s] friction
/// \param across  [N s] ditto
/// \return [N m s]
[[nodiscard]] inline double moment_of(const PatchPressure& at, double along, double across) {
  return at.along * across - at.across * along;
}

/// Whether friction of a patch is at the bound of solve_patch(), by force, by moment or by both: it slides, spins or does not
/// push. Below it the patch sticks.
/// \param patch  solved
/// \return true if so, to within tolerance::friction_limit
[[nodiscard]] inline bool is_at_friction_bound(const ContactPatch& patch) {
  const PatchPressure at = pressure_of(patch);
  const double moment =
      patch.twist_impulse - moment_of(at, patch.along_impulse, patch.across_impulse);
  const double turned = at.lever > 0.0 ? moment * at.normal / at.lever : 0.0;
  const double bound = (1.0 - tolerance::friction_limit) * patch.friction * at.normal;
  return patch.along_impulse * patch.along_impulse + patch.across_impulse * patch.across_impulse +
             turned * turned >=
         bound * bound;
}

}  // namespace tumble
