/// \file
/// \brief A pile at rest, its contacts, and its contact forces with and without stable boxes.
#include "geometric_stability/resting_pile.hpp"

#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/scenes/library.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace tumble::chapters {
namespace {

// Every pair whose spheres are near each other.
std::vector<IndexPair> pairs_of(const World& world) {
  std::vector<IndexPair> pairs;
  const auto reach = [&](int b) {
    const BodyProperties& body = world.bodies()[at(b)];
    return body.shape == Shape::ground ? std::numeric_limits<double>::infinity()
                                       : 0.51 * body.size.norm();
  };
  for (int i = 0; i < world.count(); ++i)
    for (int j = i + 1; j < world.count(); ++j) {
      const Vec3 apart = world.states()[at(i)].position_w - world.states()[at(j)].position_w;
      if (apart.norm() <= reach(i) + reach(j)) pairs.push_back({i, j});
    }
  return pairs;
}

// [m/s²] The largest acceleration of a point of a body, at least.
double fastest(const BodyProperties& body, const Acceleration& a) {
  return a.linear_w.norm() + 0.5 * body.size.norm() * a.angular_w.norm();
}

}  // namespace

RestingPile pile_of(const Scene& scene, double margin) {
  RestingPile pile{build_world(scene), {}, {}};
  load_moving_bodies(pile.world, pile.bodies);
  gather_contacts(pile.world, pile.bodies, pairs_of(pile.world), margin, {}, pile.contacts);
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

Scene pyramid_without_middle(int rows, double gap) {
  const SceneRecipe& recipe = scene_recipe("fig5_6");
  Parameters settings = recipe.parameters();
  settings.set("rows", std::to_string(rows));
  settings.set("gap", shortest_text(gap));
  return recipe.build(settings, Random(1));
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
    change.acceleration = std::max(change.acceleration, fastest(body, a) / g);
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
    const double a = fastest(pile.world.bodies()[b], forces.accelerations[b]);
    const bool falls = pile.world.bodies()[b].movable() && a > limit * pile.world.gravity_w.norm();
    result.push_back(falls ? 1 : 0);
  }
  return result;
}

int points_without(const RestingPile& pile, std::span<const char> held) {
  int points = 0;
  for (const Contact& contact : pile.contacts)
    if (held[at(contact.first)] == 0 || held[at(contact.second)] == 0) points += contact.count;
  return points;
}

int movable_marked(const World& world, std::span<const char> marks) {
  int count = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
    if (world.bodies()[b].movable() && marks[b] != 0) ++count;
  return count;
}

}  // namespace tumble::chapters
