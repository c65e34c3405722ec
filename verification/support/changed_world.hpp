/// \file
/// \brief A world like another one, with each body changed: for tests of what a technique must not depend on.
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble::test {

/// A world whose boxes are those of another one, each changed; grounds stay.
/// \param world   the other one
/// \param change  gets properties and state of a box, and changes them
/// \return the new one, with the same gravity and names
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

}  // namespace tumble::test
