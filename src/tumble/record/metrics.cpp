/// \file
/// \brief Measuring a run from outside.
#include "tumble/record/metrics.hpp"

#include "tumble/dynamics/energy.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s²] the unit of accelerations where there is none

}  // namespace

void MetricsMeter::on_begin(const World& world) {
  *this = MetricsMeter();
  metrics_ = begin(world);
}

void MetricsMeter::on_change(const World&, double energy_added) { allow(energy_added); }

void MetricsMeter::on_step(const World& world, const StepReport& report) {
  metrics_ = measure(world, report);
}

Metrics MetricsMeter::begin(const World& world) {
  start_energy_ = energy_of(world).total();
  return measure_now(world);
}

Metrics MetricsMeter::measure(const World& world, const StepReport& report) {
  booked_.restitution += report.energy.restitution;
  booked_.friction += report.energy.friction;
  booked_.damping += report.energy.damping;
  booked_.repair += report.energy.repair;
  return measure_now(world);
}

Metrics MetricsMeter::measure_now(const World& world) {
  Metrics m;
  const double gravity = world.gravity_w.norm() > 0.0 ? world.gravity_w.norm() : kEarthGravity;
  const Energy energy = energy_of(world);
  m.kinetic = energy.kinetic;
  m.potential = energy.potential;
  m.booked = booked_;
  m.energy_error = energy.total() - start_energy_ - booked_.total();
  m.momentum_w = linear_momentum(world);
  m.angular_momentum_w = angular_momentum(world);
  double scale = 0.0;  // [J] Σ m g L
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.movable()) scale += body.mass * gravity * body.size.minCoeff();
    m.fastest = std::max(m.fastest, velocity(body, world.states()[k]).norm());
    if (world.sleep_states()[k].asleep) ++m.asleep;
  }
  if (scale > 0.0) m.energy_error_share = m.energy_error / scale;
  if (!std::isfinite(energy.total())) return m;  // nowhere in particular: nothing to measure
  m.deepest_overlap = overlap_.look(world);
  chatter_.add(world, overlap_.in_contact());
  m.chatter = chatter_.measure(gravity);
  return m;
}

}  // namespace tumble
