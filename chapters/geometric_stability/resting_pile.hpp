/// \file
/// \brief A pile at rest, its contacts, and its contact forces with and without stable boxes
///        (thesis 5.4).
#pragma once

#include "tumble/analytic_lcp/contact_forces.hpp"
#include "tumble/scenes/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace tumble::chapters {

/// A world at an instant with all points at which boxes rest on each other.
struct RestingPile {
  World world;                     ///< the bodies
  std::vector<MovingBody> bodies;  ///< how they move, by index
  ContactList contacts;            ///< points where forces can act
};

/// The pile of a scene at its start.
/// \param scene   boxes that are all there at the start
/// \param margin  [m] surfaces up to this far apart touch
/// \return the pile
RestingPile pile_of(const Scene& scene, double margin = 1e-9);

/// A world in motion, as the technique `analytic` sees it at the start of a step.
/// \param world  the bodies
/// \param dt     [s] of the step
/// \return the points that rest or collide
RestingPile pile_now(const World& world, double dt);

/// Figure 5.6: a flat pyramid without the middle box of its lowest row.
/// \param rows  boxes in the lowest row before, an odd number
/// \param gap   [-] between neighbours, in edges
/// \return the scene
/// \throws std::invalid_argument in the words of the scene, for an even number of rows
Scene pyramid_without_middle(int rows, double gap);

/// Contact forces of a pile, and what they do.
struct RestingForces {
  ForceReport report;                       ///< the work
  std::vector<Acceleration> accelerations;  ///< by body index
  std::vector<Wrench> wrenches;             ///< of all contacts, by body index
  std::vector<char> held;                   ///< by body index, not 0: left out; may be empty
};

/// Finds the contact forces without friction.
/// \param pile    the pile
/// \param solver  by its name
/// \param rule    who is left out
/// \return the forces
/// \throws std::runtime_error if the solver has no answer
RestingForces forces_of(const RestingPile& pile, const std::string& solver, StableRule rule);

/// How far two answers are apart.
struct ForceChange {
  double acceleration = 0.0;  ///< [-] of any point of a body, over g
  double wrench = 0.0;        ///< [-] of a body: force, and torque over half its diagonal, over m g
};

/// What it changes to leave stable boxes out: the largest difference of any movable body.
/// \param pile  the pile
/// \param all   forces of all boxes
/// \param left  forces without the stable ones
/// \return 0 up to rounding if nothing that may not be left out was
ForceChange change_of(const RestingPile& pile, const RestingForces& all, const RestingForces& left);

/// Who accelerates.
/// \param pile    the pile
/// \param forces  without anybody left out; only the accelerations are read
/// \param limit   [-] share of g
/// \return by body index, 1 if a point of it may accelerate by more than that
std::vector<char> accelerating(const RestingPile& pile, const RestingForces& forces, double limit);

/// Contact points with unknown forces if some bodies are taken for immovable.
/// \param pile  the pile
/// \param held  by body index, not 0: immovable or taken for it
/// \return the points that belong to at least one other body
int points_without(const RestingPile& pile, std::span<const char> held);

/// How many movable bodies are marked.
/// \param world  the bodies
/// \param marks  by body index
/// \return those with a mark that is not 0
int movable_marked(const World& world, std::span<const char> marks);

}  // namespace tumble::chapters
