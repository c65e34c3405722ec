/// \file
/// \brief Conserved quantities of a closed system: energy and momenta of a whole world.
#include "tumble/dynamics/energy.hpp"

namespace tumble {

Energy energy_of(const BodyProperties& body, const BodyState& state, const Vec3& gravity_w) {
  if (!body.movable()) return {};
  return Energy{kinetic_energy(body, state), -body.mass * gravity_w.dot(state.position_w)};
}

Energy energy_of(const World& world) {
  Energy sum;
  for (std::size_t i = 0; i < world.states().size(); ++i) {
    const Energy one = energy_of(world.bodies()[i], world.states()[i], world.gravity_w);
    sum.kinetic += one.kinetic;
    sum.potential += one.potential;
  }
  return sum;
}

double lifting_energy(const World& world) {
  double sum = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) sum += body.mass * world.gravity_w.norm() * body.size.maxCoeff();
  return sum;
}

// Immovable bodies have no momentum: World refuses it and no formula gives them any.
Vec3 linear_momentum(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const BodyState& state : world.states()) sum += state.linear_momentum_w;
  return sum;
}

Vec3 angular_momentum(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const BodyState& state : world.states())
    sum += state.position_w.cross(state.linear_momentum_w) + state.angular_momentum_w;
  return sum;
}

}  // namespace tumble
