/// \file
/// \brief A world like another one, with each body changed: for tests of what a technique must not depend on.
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble::test {

// A world whose boxes are those of another one, each changed; grounds stay.
template <typename Change>
World changed(const World& world, const Change& change) {
  World out;
  out.gravity_w = world.gravity_w;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    BodyProperties body = world.bodies()[k];
    BodyState state = world.states()[k];
    if (body.shape == Shape::ground) {
      out.add_ground(body.friction, body.restitution);
      continue;
    }
    change(body, state);
    out.add(body, state, world.name(static_cast<int>(k)));
  }
  return out;
}

// The same world with four times the length and twice the time, so that gravity stays.
inline World in_other_units(const World& world, double mass) {
  return changed(world, [&](BodyProperties& body, BodyState& state) {
    body.size *= 4.0;
    if (body.movable()) {
      body.mass *= mass;
      body.inverse_mass /= mass;
      body.inertia_b *= 16.0 * mass;
      body.inverse_inertia_b /= 16.0 * mass;
    }
    state.position_w *= 4.0;
    state.linear_momentum_w *= 2.0 * mass;
    state.angular_momentum_w *= 8.0 * mass;
  });
}

// How many bodies are elsewhere after a second in other units, under a technique with its defaults.
template <class SomeTechnique>
int differ_in_other_units(World world) {
  World other = in_other_units(world, 8.0);
  SomeTechnique first;
  SomeTechnique second;
  for (int k = 0; k < 60; ++k) {
    first.step(world, 1.0 / 60.0);
    second.step(other, 2.0 / 60.0);
  }
  int differ = 0;
  for (std::size_t b = 0; b < world.states().size(); ++b)
    if (4.0 * world.states()[b].position_w != other.states()[b].position_w) ++differ;
  return differ;
}

// The image in a mirror: x to -x; spins are the other way about y and z.
inline World mirrored(const World& world) {
  return changed(world, [](BodyProperties&, BodyState& state) {
    state.position_w.x() *= -1.0;
    state.linear_momentum_w.x() *= -1.0;
    state.orientation_wb.y() *= -1.0;
    state.orientation_wb.z() *= -1.0;
    state.angular_momentum_w.y() *= -1.0;
    state.angular_momentum_w.z() *= -1.0;
  });
}

}  // namespace tumble::test
