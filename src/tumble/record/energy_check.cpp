/// \file
/// \brief A check of a run that knows no technique: no passive scene gains energy.
#include "tumble/record/energy_check.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

double energy_of_body(const World& world, std::size_t k) {
  return energy_of(world.bodies()[k], world.states()[k], world.gravity_w).total();
}

}  // namespace

void EnergyCheck::begin(const World& world) {
  double scale = 0.0;  // [J]
  energies_.resize(idx(world.count()));
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    energies_[k] = energy_of_body(world, k);
    if (!body.movable()) continue;
    scale += kinetic_energy(body, world.states()[k]) +
             body.mass * world.gravity_w.norm() * body.size.maxCoeff();
  }
  allowed_ = std::max(allowed_, tolerance::energy_gain * scale);
}

void EnergyCheck::on_begin(const World& world) {
  begin(world);
  start_ = energy_of(world).total();
}

void EnergyCheck::on_change(const World& world, double energy_added) {
  start_ += energy_added;
  begin(world);
}

void EnergyCheck::on_step(const World& world, const StepReport& /*report*/) {
  double total = 0.0;
  double most = 0.0;
  std::size_t gainer = 0;
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    const double now = energy_of_body(world, k);
    total += now;
    if (now - energies_[k] > most) {
      most = now - energies_[k];
      gainer = k;
    }
    energies_[k] = now;
  }
  failed_ = std::isfinite(total) && total - start_ > allowed_;
  if (!failed_ || !message_.empty()) return;
  message_ =
      "step " + std::to_string(world.steps()) + " at " + rounded_text(world.time(), 6) +
      " s: the total energy is " + rounded_text(total, 6) + " J, " +
      rounded_text(total - start_, 6) + " J above the start, which nothing in the scene can add; " +
      world.name(static_cast<int>(gainer)) + " gained " + rounded_text(most, 6) + " J in this step";
}

}  // namespace tumble
