/// \file
/// \brief Measuring a run from outside.
#include "tumble/record/metrics.hpp"

#include "tumble/base/tolerance.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s²] the unit of accelerations where there is none

// Up to this distance surfaces count as touching: a share of the shortest edge of the two. The
// ground has no size of its own.
double touching_distance(const BodyProperties& a, const BodyProperties& b) {
  double edge = std::numeric_limits<double>::infinity();
  for (const BodyProperties* body : {&a, &b})
    if (body->shape == Shape::box) edge = std::min(edge, body->size.minCoeff());
  return tolerance::touching * edge;
}

}  // namespace

MetricsMeter::MetricsMeter() : broad_phase_(make_broad_phase("bounding_tree")) {}

Metrics MetricsMeter::begin(const World& world) {
  start_energy_ = energy_of(world).total();
  return measure_now(world);
}

double MetricsMeter::look_for_contacts(const World& world) {
  const auto bodies = world.bodies();
  const auto states = world.states();
  bounds_.resize(bodies.size());
  in_contact_.assign(bodies.size(), 0);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bounds_[i] = bounds_of(bodies[i], states[i], tolerance::touching * bodies[i].size.minCoeff());
  broad_phase_->find_pairs(bounds_, pairs_);
  double deepest = 0.0;
  for (const IndexPair& pair : pairs_) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    if (!bodies[a].movable() && !bodies[b].movable()) continue;
    const double distance = gap_between(bodies[a], states[a], bodies[b], states[b]).distance;
    if (distance > touching_distance(bodies[a], bodies[b])) continue;
    in_contact_[a] = 1;
    in_contact_[b] = 1;
    deepest = std::max(deepest, -distance);
  }
  return deepest;
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
    if (world.rests()[k].asleep) ++m.asleep;
  }
  if (scale > 0.0) m.energy_error_share = m.energy_error / scale;
  if (!std::isfinite(energy.total())) return m;  // nowhere in particular: nothing to measure
  m.deepest_overlap = look_for_contacts(world);
  chatter_.add(world, in_contact_);
  m.chatter = chatter_.measure(gravity);
  return m;
}

}  // namespace tumble
