/// \file
/// \brief A pile at rest, its contacts, and its contact forces with and without stable boxes
///        (thesis 5.4).
#pragma once

#include "tumble/analytic_lcp/contact_forces.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A world at an instant with all points at which boxes rest on each other.
struct RestingPile {
  World world;                     // the bodies
  std::vector<MovingBody> bodies;  // how they move, by index
  ContactList contacts;            // points where forces can act
};

// Finds the contacts of a world at rest.
RestingPile pile_of(World world);

// A world in motion, as the technique `analytic` sees it at the start of a step.
// dt: [s] of the step
RestingPile pile_now(const World& world, double dt);

// Figure 5.6: a flat pyramid without the middle box of its lowest row.
// gap: [-] between neighbours, in edges
RestingPile pyramid_without_middle(int rows, double gap);

// Contact forces of a pile, and accelerations by them.
struct RestingForces {
  ForceReport report;                       // the work
  std::vector<Acceleration> accelerations;  // by body index
  std::vector<Wrench> wrenches;             // of all contacts, by body index
  std::vector<char> held;                   // by body index, not 0: left out; may be empty
};

// Finds the contact forces without friction.
RestingForces forces_of(const RestingPile& pile, const std::string& solver, StableRule rule);

// The distance of two answers.
struct ForceChange {
  double acceleration = 0.0;  // [-] of any point of a body, over g
  double wrench = 0.0;        // [-] of a body: force, and torque over half its diagonal, over m g
};

// The change by leaving stable boxes out: the largest difference of any movable body.
ForceChange change_of(const RestingPile& pile, const RestingForces& all, const RestingForces& left);

// The bodies that accelerate.
// limit: [-] share of g
std::vector<char> accelerating(const RestingPile& pile, const RestingForces& forces, double limit);

// Contact points with unknown forces if some bodies are taken for immovable.
int points_without(const RestingPile& pile, std::span<const char> held);

// Number of movable bodies that are marked.
int movable_marked(const World& world, std::span<const char> marks);

// Counts at the start of each step of a run.
struct CountedRun {
  std::vector<double> all;     // unknown forces with no body left out
  std::vector<double> left;    // without the boxes that are stable then, by the rule of corners
  std::vector<double> stable;  // how many those are
};

// Simulates a world with the technique `analytic`, without friction and damped, stable boxes left
// out, at 60 steps a second.
CountedRun count_run(World world, int steps, const std::function<void(const World&)>& before = {});

// The pyramid of figure 5.6 in which all boxes that are not stable have got a random velocity.
// gap: [-] between neighbours, in edges
// knock: [m/s] each component is drawn from [-knock, knock)
World knocked_pyramid(int rows, double gap, double knock, std::uint64_t seed);

}  // namespace tumble::chapters
