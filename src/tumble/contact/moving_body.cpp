/// \file
/// \brief Velocities out of momenta, and back.
#include "tumble/contact/moving_body.hpp"

#include "tumble/base/error.hpp"

namespace tumble {

MovingBody moving_body_of(const BodyProperties& body, const BodyState& state) {
  MovingBody moving;
  moving.velocity_w = velocity(body, state);
  moving.angular_velocity_w = angular_velocity(body, state);
  moving.position_w = state.position_w;
  moving.inverse_mass = Vec3::Constant(body.inverse_mass);
  moving.inverse_inertia_w = inverse_inertia_w(body, state.orientation_wb);
  return moving;
}

void store_moving_body(const MovingBody& moving, const BodyProperties& body, BodyState& state) {
  if (!moving.changed || !body.movable()) return;
  state.linear_momentum_w = body.mass * moving.velocity_w;
  state.angular_momentum_w =
      angular_momentum(body, state.orientation_wb, moving.angular_velocity_w);
}

void load_moving_bodies(const World& world, std::vector<MovingBody>& out) {
  out.clear();
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
    out.push_back(moving_body_of(world.bodies()[i], world.states()[i]));
}

void store_moving_bodies(std::span<const MovingBody> bodies, World& world) {
  require::that(bodies.size() == world.states().size(),
                "bodies: one entry for each body of the world is needed, as load_moving_bodies "
                "makes them");
  for (std::size_t i = 0; i < bodies.size(); ++i)
    store_moving_body(bodies[i], world.bodies()[i], world.states()[i]);
}

}  // namespace tumble
