/// \file
/// \brief Overlap that the steps of a run pile up is ended without adding energy.
#include "tumble/analytic_lcp/drift_correction.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void DriftCorrection::run(World& world, std::span<const IndexPair> pairs, StepReport& report) {
  before_w_.clear();
  for (const BodyState& state : world.states()) before_w_.push_back(state.position_w);
  const RepairReport repaired = repair_.run(world, pairs);
  book(repaired, report);
  if (repaired.moves == 0) return;

  for (std::size_t b = 0; b < before_w_.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable()) continue;
    BodyState& state = world.states()[b];
    const double lifted = -body.mass * world.gravity_w.dot(Vec3(state.position_w - before_w_[b]));
    const double kinetic = kinetic_energy(body, state);
    if (!(lifted > 0.0) || !(kinetic > 0.0)) continue;
    const double left = std::max(0.0, 1.0 - lifted / kinetic);
    const double scale = std::sqrt(left);
    state.linear_momentum_w *= scale;
    state.angular_momentum_w *= scale;
    report.energy.repair += kinetic_energy(body, state) - kinetic;
  }
}

}  // namespace tumble
