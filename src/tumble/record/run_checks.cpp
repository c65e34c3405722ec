/// \file
/// \brief Checks of a run that know no technique: what no scene can do.
#include "tumble/record/run_checks.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace tumble {
namespace {

Energy energy_of_body(const World& world, std::size_t k) {
  return energy_of(world.bodies()[k], world.states()[k], world.gravity_w);
}

}  // namespace

void RunCheck::find(const World& world, const std::string& what) {
  if (!message_.empty()) return;
  message_ = "step " + std::to_string(world.steps()) + " at " + rounded_text(world.time(), 6) +
             " s: " + what;
}

// --- energy -----------------------------------------------------------------------------------------

void EnergyCheck::begin(const World& world) {
  const double kinetic = energy_of(world).kinetic;
  weight_ = lifting_energy(world);
  time_ = world.time();
  energies_.resize(idx(world.count()));
  for (std::size_t k = 0; k < energies_.size(); ++k)
    energies_[k] = energy_of_body(world, k).total();
  allowed_ = std::max(allowed_, tolerance::energy_gain * (kinetic + weight_));
  kinetic_ = std::max(kinetic_, kinetic);
}

void EnergyCheck::on_begin(const World& world) {
  begin(world);
  start_ = energy_of(world).total();
}

void EnergyCheck::on_change(const World& world, double energy_added) {
  start_ += energy_added;
  begin(world);
}

void EnergyCheck::on_step(const World& world, const StepReport& report) {
  double total = 0.0;
  double kinetic = 0.0;
  double most = 0.0;
  double rounding = 0.0;  // [kg m²] m (ε (|x| + L))²
  std::size_t gainer = 0;
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const double off =
        tolerance::rounding * (world.states()[k].position_w.norm() + body.size.maxCoeff());
    if (body.movable()) rounding += body.mass * off * off;
    const Energy energy = energy_of_body(world, k);
    const double now = energy.total();
    total += now;
    kinetic += energy.kinetic;
    if (now - energies_[k] > most) {
      most = now - energies_[k];
      gainer = k;
    }
    energies_[k] = now;
  }
  kinetic_ = std::max(kinetic_, kinetic);
  booked_ += report.energy.total();
  const double gained = total - start_;
  const double unbooked = gained - booked_;
  const double dt = world.time() - time_;
  const double noise = 0.5 * rounding / (dt * dt);  // [J]
  time_ = world.time();
  status_ = StepStatus::done;
  if (!std::isfinite(total)) return;
  std::string what;
  if (gained > allowed_ + noise) {
    what = rounded_text(gained, 6) + " J above the start, which nothing in the scene can add";
  } else if (unbooked > tolerance::unbooked_gain * (kinetic_ + weight_) + noise) {
    what = rounded_text(unbooked, 6) + " J above what is left of the start's after all losses";
  } else {
    return;
  }
  status_ = StepStatus::energy_gained;
  find(world, "the total energy is " + rounded_text(total, 6) + " J, " + what + "; " +
                  world.name(static_cast<int>(gainer)) + " gained " + rounded_text(most, 6) +
                  " J in this step");
}

// --- turning ----------------------------------------------------------------------------------------

void TurnCheck::on_begin(const World& world) { time_ = world.time(); }

void TurnCheck::on_step(const World& world, const StepReport& /*report*/) {
  const double dt = world.time() - time_;
  time_ = world.time();
  if (!message().empty()) return;
  for (std::size_t k = 0; k < idx(world.count()); ++k) {
    const double turn = dt * angular_velocity(world.bodies()[k], world.states()[k]).norm();
    if (!(turn > tolerance::most_turn)) continue;
    find(world,
         world.name(static_cast<int>(k)) + " rotates by " + rounded_text(turn, 3) +
             " rad in a step, and above 1 rad not every technique finds its contacts and keeps its "
             "energy: --dt " +
             rounded_text(0.5 * dt / turn, 2) + " is small enough");
    return;
  }
}

// --- boxes that appear ------------------------------------------------------------------------------

void AppearCheck::on_begin(const World& world) {
  known_.assign(world.ids().begin(), world.ids().end());
}

void AppearCheck::on_change(const World& world, double /*energy_added*/) {
  const std::span<const BodyProperties> bodies = world.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (std::binary_search(known_.begin(), known_.end(), world.ids()[k])) continue;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (i == k || (!bodies[i].movable() && !bodies[k].movable())) continue;
      const std::size_t first = std::min(i, k);
      const std::size_t second = std::max(i, k);
      const double depth =
          -gap_between(bodies[first], world.states()[first], bodies[second], world.states()[second])
               .distance;
      const double accepted =
          tolerance::start_overlap * shortest_edge(bodies[first], bodies[second]);
      if (!(depth > accepted)) continue;
      deep_ =
          deep_ || depth > tolerance::deep_overlap * shortest_edge(bodies[first], bodies[second]);
      find(world,
           world.name(static_cast<int>(k)) + " appears " + rounded_text(depth, 3) + " m deep in " +
               world.name(static_cast<int>(i)) +
               ", and is pushed out, which can add energy: give it another position or another "
               "time to appear; up to " +
               rounded_text(accepted, 3) + " m is accepted");
    }
  }
  on_begin(world);
}

void AppearCheck::on_step(const World& /*world*/, const StepReport& /*report*/) {
  status_ = deep_ ? StepStatus::passed_through : StepStatus::done;
  deep_ = false;
}

}  // namespace tumble
