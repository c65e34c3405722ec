/// \file
/// \brief The size of a pair by which resting contact is judged.
#pragma once

#include "tumble/dynamics/world.hpp"

#include <algorithm>
#include <limits>

namespace tumble {

/// The shortest edge of the movable bodies of a pair: a thin plate that stays is as good as a thick one.
/// \return [m] infinite if both are immovable
[[nodiscard]] inline double movable_edge(const BodyProperties& a, const BodyProperties& b) {
  double edge = std::numeric_limits<double>::infinity();
  for (const BodyProperties* body : {&a, &b})
    if (body->movable()) edge = std::min(edge, body->size.minCoeff());
  return edge;
}

/// The shortest edge of all movable bodies [m]; 0 if none is movable.
[[nodiscard]] inline double movable_edge(const World& world) {
  double edge = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable())
      edge = edge > 0.0 ? std::min(edge, body.size.minCoeff()) : body.size.minCoeff();
  return edge;
}

}  // namespace tumble
