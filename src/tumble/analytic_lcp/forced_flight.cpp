/// \file
/// \brief Bodies in flight under forces that stay as they are.
#include "tumble/analytic_lcp/forced_flight.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/integrate.hpp"

#include <string>

namespace tumble {

void ForcedFlight::begin(const World& world) {
  start_.assign(world.states().begin(), world.states().end());
  wrenches_.assign(start_.size(), Wrench{});
  carried_.clear();
}

void ForcedFlight::set_wrenches(std::span<const Wrench> wrenches) {
  if (wrenches.size() != start_.size())
    refuse("wrenches: " + std::to_string(wrenches.size()) + " entries; " +
           std::to_string(start_.size()) + " are needed");
  wrenches_.assign(wrenches.begin(), wrenches.end());
}

void ForcedFlight::carry(const World& world, std::span<const MovingBody> bodies,
                         std::span<const PushedPair> pushed) {
  carried_.find(world.bodies(), bodies, pushed);
}

void ForcedFlight::accelerate(std::span<const Acceleration> rates) { carried_.accelerate(rates); }

Vec3 ForcedFlight::offset_w(int body, double time) const {
  return carried_.carries(body) ? carried_.offset_w(body, time) : Vec3::Zero();
}

void ForcedFlight::put(World& world, double time, RotationRule rule) const {
  for (int b = 0; b < world.count(); ++b) put(world, b, time, rule);
}

void ForcedFlight::put(World& world, int body, double time, RotationRule rule) const {
  const auto b = static_cast<std::size_t>(body);
  const BodyProperties& properties = world.bodies()[b];
  if (!properties.movable()) return;
  // Half of the turning push before the way and half after it: the mean turns the body.
  BodyState state = start_[b];
  const Vec3 half_w = 0.5 * time * wrenches_[b].torque_w;
  state.angular_momentum_w += half_w;
  const Vec3 acceleration_w = world.gravity_w + properties.inverse_mass * wrenches_[b].force_w;
  fly(properties, state, acceleration_w, time, rule);
  state.angular_momentum_w += half_w;
  if (carried_.carries(body)) {
    state.orientation_wb = start_[b].orientation_wb;
    carried_.carry(body, time, state);
  }
  world.states()[b] = state;
}

}  // namespace tumble
