/// \file
/// \brief Friction by point, as the direct solver has it.
#include "tumble/contact_patches/point_friction.hpp"

#include <algorithm>

namespace tumble {

double error_at_points(const ContactPatch& patch, const Six& motion) {
  const SixBySix& K = patch.inverse_mass;
  double most = 0.0;
  Six since = impulse_of(patch);
  for (const ContactPatchPoint& p : patch.used()) {
    Vec3 u = velocity_at(p.along, p.across, motion);
    u[2] += patch.friction * u.head<2>().norm() - p.target;
    const double k = inverse_mass_at(K, p.along, p.across);
    const Vec3 better = into_cone(p.solver_impulse - u / k, patch.friction);
    most = std::max(most, k * (better - p.solver_impulse).norm());
    add_push(p.along, p.across, -p.solver_impulse, since);
  }
  Six added{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) added[i] += K[i][j] * since[j];
  for (const ContactPatchPoint& p : patch.used())
    most = std::max(most, velocity_at(p.along, p.across, added).norm());
  return most;
}

}  // namespace tumble
