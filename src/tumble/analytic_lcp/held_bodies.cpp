/// \file
/// \brief Stable boxes taken for immovable.
#include "tumble/analytic_lcp/held_bodies.hpp"

namespace tumble {

std::span<const MovingBody> HeldBodies::find(const World& world, std::span<const MovingBody> bodies,
                                             std::span<const Contact> contacts) {
  held_.clear();
  if (rule_ == StableRule::off) return bodies;
  // [S5.4:excluded]
  // Stable boxes are modelled as immovable. What no movable body
  // takes part in any more is no contact of the system.
  const std::span<const char> held = boxes_.find(world, bodies, contacts);
  held_.assign(held.begin(), held.end());
  eased_.assign(bodies.begin(), bodies.end());
  for (std::size_t b = 0; b < held_.size(); ++b) {
    if (held_[b] == 0) continue;
    eased_[b].inverse_mass.setZero();
    eased_[b].inverse_inertia_w.setZero();
  }
  // [S5.4:excluded]
  return eased_;
}

void HeldBodies::hold(const World& world, double relaxation, std::span<Acceleration> accelerations,
                      std::span<Wrench> wrenches) const {
  for (std::size_t b = 0; b < held_.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (held_[b] == 0 || !body.movable()) continue;
    // Upright: up and down, and about level axes. A box that stands has the vertical for a
    // principal axis, so that its angular momentum is split like its spin.
    const BodyState& state = world.states()[b];
    Vec3 momentum_w = state.linear_momentum_w;
    Vec3 spin_w = state.angular_momentum_w;
    if (held_[b] == static_cast<char>(Hold::upright)) {
      momentum_w = Vec3(0.0, momentum_w.y(), 0.0);
      spin_w.y() = 0.0;
    }
    wrenches[b].force_w = -body.mass * world.gravity_w - momentum_w / relaxation;
    wrenches[b].torque_w = -spin_w / relaxation;
    accelerations[b].linear_w = -momentum_w / (body.mass * relaxation);
    accelerations[b].angular_w =
        -(inverse_inertia_w(body, state.orientation_wb) * spin_w) / relaxation;
  }
}

}  // namespace tumble
