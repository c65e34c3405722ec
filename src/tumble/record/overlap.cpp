/// \file
/// \brief Distances of all pairs that are near.
#include "tumble/record/overlap.hpp"

#include "tumble/dynamics/flight.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>

namespace tumble {

double touching_distance(const BodyProperties& a, const BodyProperties& b) {
  return tolerance::touching * shortest_edge(a, b);
}

double OverlapMeter::look(std::span<const BodyProperties> bodies,
                          std::span<const BodyState> states) {
  find_pairs(bodies, states);
  return measure(bodies, states);
}

double OverlapMeter::look(const World& world) {
  find_pairs(world.bodies(), world.states());
  leave_out_joined(world, pairs_);
  return measure(world.bodies(), world.states());
}

void OverlapMeter::find_pairs(std::span<const BodyProperties> bodies,
                              std::span<const BodyState> states) {
  bounds_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bounds_[i] = bounds_of(bodies[i], states[i], tolerance::touching * bodies[i].size.minCoeff());
  broad_phase_.find_pairs(bounds_, pairs_);
}

double OverlapMeter::measure(std::span<const BodyProperties> bodies,
                             std::span<const BodyState> states) {
  in_contact_.assign(bodies.size(), 0);
  depths_.assign(bodies.size(), 0.0);
  for (const IndexPair& pair : pairs_) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    if (!bodies[a].movable() && !bodies[b].movable()) continue;
    const double distance = gap_between(bodies[a], states[a], bodies[b], states[b]).distance;
    if (distance > touching_distance(bodies[a], bodies[b])) continue;
    in_contact_[a] = 1;
    in_contact_[b] = 1;
    for (const std::size_t body : {a, b}) depths_[body] = std::max(depths_[body], -distance);
  }
  return depths_.empty() ? 0.0 : *std::max_element(depths_.begin(), depths_.end());
}

}  // namespace tumble
