/// \file
/// \brief Damping in place of friction, as the thesis proposes it for analytic contact forces (5.3).
///
/// Uses the chapter on geometric stability.
#pragma once

#include "tumble/analytic_lcp/held_bodies.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/world.hpp"

#include <span>

namespace tumble {

/// How much is left of the motion of bodies in contact.
struct DampingShares {
  double velocity = 0.95;  ///< [-] of velocities, in 1/60 s, from 0 to 1: k1
  double spin = 0.95;      ///< [-] of angular velocities, ditto: k2
};

/// Slows down bodies that push each other.
///
/// The thesis scales the velocities of whatever is in resting contact by constants (5.3). Here the
/// constants belong to 1/60 s and are raised to \f$60\,\Delta t\f$, so that the step does not
/// matter; and velocities are those against the group's scenery, or, if the group touches none,
/// against its centre of mass: a clump in free fall is not braked in the air. With both shares equal all
/// velocities of a group shrink alike, so points that rest on each other go on doing so.
///
/// Real friction also drags things along. This does not.
class IslandDamping {
 public:
  /// Slows bodies down.
  /// \param contacts  with the impulses of the last flight; a contact without any does not count
  /// \param held      the bodies left out of the forces; contacts between two of them count
  /// \param world     momenta in and out
  /// \return [J] energy added: 0 or below
  double run(std::span<const Contact> contacts, const HeldBodies& held, const DampingShares& shares,
             double dt, World& world);

 private:
  ContactList pushing_;
  Islands islands_;
};

}  // namespace tumble
