/// \file
/// \brief The size of a pair by which resting contact is judged.
#pragma once

#include "tumble/dynamics/body.hpp"

#include <algorithm>
#include <limits>

namespace tumble {

/// The shortest edge of the movable bodies of a pair: a thin plate that stays is as good as a thick one.
/// \param a  the one
/// \param b  the other
/// \return [m] infinite if both are immovable
[[nodiscard]] inline double movable_edge(const BodyProperties& a, const BodyProperties& b) {
  double edge = std::numeric_limits<double>::infinity();
  for (const BodyProperties* body : {&a, &b})
    if (body->movable()) edge = std::min(edge, body->size.minCoeff());
  return edge;
}

}  // namespace tumble
