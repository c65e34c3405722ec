/// \file
/// \brief Velocities out of momenta, and back.
#include "tumble/contact/moving_body.hpp"

#include "tumble/base/error.hpp"

namespace tumble {

void load_moving_bodies(const World& world, std::vector<MovingBody>& out) {
  out.clear();
  const std::span<const BodyProperties> bodies = world.bodies();
  const std::span<const BodyState> states = world.states();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    MovingBody& body = out.emplace_back();
    body.velocity_w = velocity(bodies[i], states[i]);
    body.angular_velocity_w = angular_velocity(bodies[i], states[i]);
    body.position_w = states[i].position_w;
    body.inverse_mass = Vec3::Constant(bodies[i].inverse_mass);
    body.inverse_inertia_w = inverse_inertia_w(bodies[i], states[i].orientation_wb);
  }
}

void store_moving_bodies(std::span<const MovingBody> bodies, World& world) {
  require::that(bodies.size() == world.states().size(),
                "bodies: one entry for each body of the world is needed, as load_moving_bodies "
                "makes them");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyProperties& constant = world.bodies()[i];
    if (!bodies[i].changed || !constant.movable()) continue;
    BodyState& state = world.states()[i];
    state.linear_momentum_w = constant.mass * bodies[i].velocity_w;
    // L = R I_b R' omega, from right to left: three rotations of a vector, no matrix product.
    const Mat3 axes_w = state.orientation_wb.toRotationMatrix();
    const Vec3 omega_b = axes_w.transpose() * bodies[i].angular_velocity_w;
    state.angular_momentum_w = axes_w * Vec3(constant.inertia_b.cwiseProduct(omega_b));
  }
}

}  // namespace tumble
