/// \file
/// \brief A pile at rest, its contacts, and its contact forces with and without stable boxes
///        (thesis 5.4).
#pragma once

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/contact_forces.hpp"
#include "tumble/analytic_lcp/touch.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"

namespace tumble::chapters {

// A world at an instant with all points at which boxes rest on each other.
struct RestingPile {
  World world;                     // the bodies
  std::vector<MovingBody> bodies;  // how they move, by index
  ContactList contacts;            // points where forces can act
};

// Finds the contacts of a world at rest.
inline RestingPile pile_of(World world) {
  RestingPile pile{std::move(world), {}, {}};
  load_moving_bodies(pile.world, pile.bodies);
  pile.contacts = touching(pile.world);
  return pile;
}

// A world in motion, as the technique `analytic` sees it at the start of a step.
inline RestingPile pile_now(const World& world, double dt) {
  RestingPile pile{world, {}, {}};
  load_moving_bodies(world, pile.bodies);
  gather_near(world, pile.bodies, pile.contacts);
  keep_points(pile.contacts, [&](const Contact& contact, const ContactPoint& point) {
    const PointMotion motion =
        motion_of(point, touch_scale(world, contact.first, contact.second, dt));
    return motion == PointMotion::rests || motion == PointMotion::collides;
  });
  return pile;
}

// Figure 5.6: a flat pyramid without the middle box of its lowest row.
// gap: [-] between neighbours, in edges
inline RestingPile pyramid_without_middle(int rows, double gap) {
  return pile_of(
      build_world(make_scene("fig5_6", {"rows=" + std::to_string(rows), setting("gap", gap)})));
}

// Contact forces of a pile, and accelerations by them.
struct RestingForces {
  ForceReport report;                       // the work
  std::vector<Acceleration> accelerations;  // by body index
  std::vector<Wrench> wrenches;             // of all contacts, by body index
  std::vector<char> held;                   // by body index, not 0: left out; may be empty
};

// Finds the contact forces without friction.
inline RestingForces forces_of(const RestingPile& pile, const std::string& solver,
                               StableRule rule) {
  ContactForces forces({.solver = solver, .friction = false, .stable_boxes = rule});
  ContactList contacts = pile.contacts;
  RestingForces found{.report = forces.solve(pile.world, pile.bodies, contacts, {})};
  if (found.report.status != LcpStatus::solved)
    throw std::runtime_error(solver + " did not solve the pile");
  found.accelerations.assign(forces.accelerations().begin(), forces.accelerations().end());
  found.wrenches.assign(forces.wrenches().begin(), forces.wrenches().end());
  const std::span<const char> held = forces.held().held();
  found.held.assign(held.begin(), held.end());
  return found;
}

// The distance of two answers.
struct ForceChange {
  double acceleration = 0.0;  // [-] of any point of a body, over g
  double wrench = 0.0;        // [-] of a body: force, and torque over half its diagonal, over m g
};

// The change by leaving stable boxes out: the largest difference of any movable body.
inline ForceChange change_of(const RestingPile& pile, const RestingForces& all,
                             const RestingForces& left) {
  ForceChange change;
  const double g = pile.world.gravity_w.norm();
  for (std::size_t b = 0; b < pile.bodies.size(); ++b) {
    const BodyProperties& body = pile.world.bodies()[b];
    if (!body.movable()) continue;
    const Acceleration a{all.accelerations[b].linear_w - left.accelerations[b].linear_w,
                         all.accelerations[b].angular_w - left.accelerations[b].angular_w};
    change.acceleration = std::max(change.acceleration, fastest_of(body, a) / g);
    const Vec3 force = all.wrenches[b].force_w - left.wrenches[b].force_w;
    const Vec3 torque = all.wrenches[b].torque_w - left.wrenches[b].torque_w;
    const double push = force.norm() + torque.norm() / (0.5 * body.size.norm());
    change.wrench = std::max(change.wrench, push / (body.mass * g));
  }
  return change;
}

// The bodies that accelerate.
// limit: [-] share of g
inline std::vector<char> accelerating(const RestingPile& pile, const RestingForces& forces,
                                      double limit) {
  std::vector<char> result;
  for (std::size_t b = 0; b < pile.bodies.size(); ++b) {
    const double a = fastest_of(pile.world.bodies()[b], forces.accelerations[b]);
    const bool falls = pile.world.bodies()[b].movable() && a > limit * pile.world.gravity_w.norm();
    result.push_back(falls ? 1 : 0);
  }
  return result;
}

// Contact points with unknown forces if some bodies are taken for immovable.
inline int points_without(const RestingPile& pile, std::span<const char> held) {
  int points = 0;
  for (const Contact& contact : pile.contacts)
    if (held[idx(contact.first)] == 0 || held[idx(contact.second)] == 0) points += contact.count;
  return points;
}

// Number of movable bodies that are marked.
inline int movable_marked(const World& world, std::span<const char> marks) {
  int count = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
    if (world.bodies()[b].movable() && marks[b] != 0) ++count;
  return count;
}

// Counts at the start of each step of a run.
struct CountedRun {
  std::vector<double> all;     // unknown forces with no body left out
  std::vector<double> left;    // without the boxes that are stable then, by the rule of corners
  std::vector<double> stable;  // how many those are
};

// Simulates a world with the technique `analytic`, without friction and damped, stable boxes left
// out, at 60 steps a second.
inline CountedRun count_run(World world, int steps,
                            const std::function<void(const World&)>& before = {}) {
  AnalyticOptions options{.friction = AnalyticFriction::damping,
                          .stable_boxes = StableRule::corners};
  Analytic analytic(options);
  StableBoxes boxes(StableRule::corners);
  CountedRun run;
  for (int step = 0; step < steps; ++step) {
    if (before) before(world);
    const RestingPile pile = pile_now(world, kStep);
    const std::span<const char> held = boxes.find(world, pile.bodies, pile.contacts);
    const std::vector<char> none(held.size(), 0);
    run.all.push_back(points_without(pile, none));
    run.left.push_back(points_without(pile, held));
    run.stable.push_back(movable_marked(world, held));
    finished(analytic.step(world, kStep));
  }
  return run;
}

// The pyramid of figure 5.6 in which all boxes that are not stable have got a random velocity.
// gap: [-] between neighbours, in edges
// knock: [m/s] each component is drawn from [-knock, knock)
inline World knocked_pyramid(int rows, double gap, double knock, std::uint64_t seed) {
  RestingPile pile = pyramid_without_middle(rows, gap);
  StableBoxes boxes(StableRule::corners);
  const std::span<const char> held = boxes.find(pile.world, pile.bodies, pile.contacts);
  const Random random(seed);
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (held[b] != 0) continue;
    Random draws = random.fork(b);
    pile.world.states()[b].linear_momentum_w = pile.world.bodies()[b].mass * draws.in_cube(knock);
  }
  return std::move(pile.world);
}

}  // namespace tumble::chapters
