/// \file
/// \brief A pile at rest, its contacts, and its contact forces with and without stable boxes.
#include "geometric_stability/resting_pile.hpp"

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/touch.hpp"

#include "driver/finished.hpp"
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"

namespace tumble::chapters {

RestingPile pile_of(World world) {
  RestingPile pile{std::move(world), {}, {}};
  load_moving_bodies(pile.world, pile.bodies);
  pile.contacts = touching(pile.world);
  return pile;
}

RestingPile pile_now(const World& world, double dt) {
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

RestingPile pyramid_without_middle(int rows, double gap) {
  return pile_of(
      build_world(scene_with("fig5_6", {"rows=" + std::to_string(rows), setting("gap", gap)})));
}

RestingForces forces_of(const RestingPile& pile, const std::string& solver, StableRule rule) {
  ContactForces forces({.solver = solver, .friction = false, .stable_boxes = rule});
  ContactList contacts = pile.contacts;
  RestingForces found;
  found.report = forces.solve(pile.world, pile.bodies, contacts, {});
  if (found.report.status != LcpStatus::solved)
    throw std::runtime_error(solver + " did not solve the pile");
  found.accelerations.assign(forces.accelerations().begin(), forces.accelerations().end());
  found.wrenches.assign(forces.wrenches().begin(), forces.wrenches().end());
  const std::span<const char> held = forces.held().held();
  found.held.assign(held.begin(), held.end());
  return found;
}

ForceChange change_of(const RestingPile& pile, const RestingForces& all,
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

std::vector<char> accelerating(const RestingPile& pile, const RestingForces& forces, double limit) {
  std::vector<char> result;
  for (std::size_t b = 0; b < pile.bodies.size(); ++b) {
    const double a = fastest_of(pile.world.bodies()[b], forces.accelerations[b]);
    const bool falls = pile.world.bodies()[b].movable() && a > limit * pile.world.gravity_w.norm();
    result.push_back(falls ? 1 : 0);
  }
  return result;
}

int points_without(const RestingPile& pile, std::span<const char> held) {
  int points = 0;
  for (const Contact& contact : pile.contacts)
    if (held[idx(contact.first)] == 0 || held[idx(contact.second)] == 0) points += contact.count;
  return points;
}

int movable_marked(const World& world, std::span<const char> marks) {
  int count = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
    if (world.bodies()[b].movable() && marks[b] != 0) ++count;
  return count;
}

CountedRun count_run(World world, int steps, const std::function<void(const World&)>& before) {
  AnalyticOptions options;
  options.friction = AnalyticFriction::damping;
  options.stable_boxes = StableRule::corners;
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

World knocked_pyramid(int rows, double gap, double knock, std::uint64_t seed) {
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
