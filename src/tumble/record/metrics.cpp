/// \file
/// \brief Measuring a run from outside.
#include "tumble/record/metrics.hpp"

#include "tumble/dynamics/energy.hpp"

#include <algorithm>
#include <array>
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
  start_energy_.reset();
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
  if (!start_energy_) start_energy_ = energy.total();
  m.energy_error = energy.total() - *start_energy_ - booked_.total();
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

namespace {

using M = Metrics;
using R = StepReport;

double number(std::int64_t count) { return static_cast<double>(count); }  // exact below 2^53

constexpr std::array kColumns = {
    MetricsColumn{"kinetic_J", false, [](const M& m, const R&) { return m.kinetic; }},
    MetricsColumn{"potential_J", false, [](const M& m, const R&) { return m.potential; }},
    MetricsColumn{"total_J", false, [](const M& m, const R&) { return m.kinetic + m.potential; }},
    MetricsColumn{"booked_restitution_J", false,
                  [](const M& m, const R&) { return m.booked.restitution; }},
    MetricsColumn{"booked_friction_J", false,
                  [](const M& m, const R&) { return m.booked.friction; }},
    MetricsColumn{"booked_damping_J", false, [](const M& m, const R&) { return m.booked.damping; }},
    MetricsColumn{"booked_repair_J", false, [](const M& m, const R&) { return m.booked.repair; }},
    MetricsColumn{"energy_error_J", false, [](const M& m, const R&) { return m.energy_error; }},
    MetricsColumn{"energy_error_mgL", false,
                  [](const M& m, const R&) { return m.energy_error_share; }},
    MetricsColumn{"momentum_x_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.x(); }},
    MetricsColumn{"momentum_y_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.y(); }},
    MetricsColumn{"momentum_z_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.z(); }},
    MetricsColumn{"angular_momentum_x_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.x(); }},
    MetricsColumn{"angular_momentum_y_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.y(); }},
    MetricsColumn{"angular_momentum_z_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.z(); }},
    MetricsColumn{"contacts", true, [](const M&, const R& r) { return number(r.contacts); }},
    MetricsColumn{"collisions", true, [](const M&, const R& r) { return number(r.events); }},
    MetricsColumn{"deepest_overlap_m", false,
                  [](const M& m, const R&) { return m.deepest_overlap; }},
    MetricsColumn{"chatter_amplitude_m", false,
                  [](const M& m, const R&) { return m.chatter.amplitude; }},
    MetricsColumn{"chatter_acceleration", false,
                  [](const M& m, const R&) { return m.chatter.acceleration; }},
    MetricsColumn{"chatter_bodies", true,
                  [](const M& m, const R&) { return number(m.chatter.bodies); }},
    MetricsColumn{"fastest_m_s", false, [](const M& m, const R&) { return m.fastest; }},
    MetricsColumn{"asleep", true, [](const M& m, const R&) { return number(m.asleep); }},
    MetricsColumn{"iterations", true, [](const M&, const R& r) { return number(r.iterations); }},
    MetricsColumn{"pivots", true, [](const M&, const R& r) { return number(r.pivots); }},
    MetricsColumn{"impulses", true, [](const M&, const R& r) { return number(r.impulses); }},
    MetricsColumn{"pair_tests", true, [](const M&, const R& r) { return number(r.pair_tests); }},
    MetricsColumn{"integrations", true,
                  [](const M&, const R& r) { return number(r.integrations); }},
    MetricsColumn{"searches", true, [](const M&, const R& r) { return number(r.searches); }},
    MetricsColumn{"rewinds", true, [](const M&, const R& r) { return number(r.rewinds); }},
    MetricsColumn{"restarts", true, [](const M&, const R& r) { return number(r.restarts); }},
    MetricsColumn{"fallbacks", true, [](const M&, const R& r) { return number(r.fallbacks); }},
};

}  // namespace

std::span<const MetricsColumn> metrics_columns() { return kColumns; }

}  // namespace tumble
