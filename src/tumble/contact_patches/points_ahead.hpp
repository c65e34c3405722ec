/// \file
/// \brief Points at which two bodies can come together within a step (thesis 3.2).
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/broad_phase.hpp"
#include "tumble/geometry/manifold.hpp"

#include <span>

namespace tumble {

/// The velocity of a stopped body: zero if there are immovable bodies, or else the mean of all, since bodies that all move
/// together are at rest.
/// \return [m/s] world frame
Vec3 velocity_of_rest(std::span<const MovingBody> bodies);

/// How near points of a pair have to be, to come together within the step in any direction. Other bodies may stop one of the two
/// within it, so that its own velocity does not count.
/// \param bodies  how they move, by index
/// \param rest_w  velocity_of_rest() of all bodies
/// \return [m] by moving and turning, and a margin that keeps a resting contact
double reach_of_pair(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
                     const Vec3& rest_w, double dt);

/// Finds all points at which a pair could come together within the step.
/// \param reach     [m] reach_of_pair()
/// \param axis      separating axis to try first, or kNoAxis
/// \param manifold  out
/// \return whether there are any
bool find_points_ahead(const World& world, const IndexPair& pair, double reach, AxisIndex axis,
                       Manifold& manifold);

/// Whether any of these points can come together along the normal of the manifold.
/// \param rest_w  as for reach_of_pair()
bool can_meet(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
              const Vec3& rest_w, const Manifold& manifold, double dt);

}  // namespace tumble
