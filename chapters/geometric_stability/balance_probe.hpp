/// \file
/// \brief Structures at rest, and the verdicts of tests of their balance (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/towers.hpp"
#include "tumble/lcp_solvers/baraff.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/resting_pile.hpp"

namespace tumble::chapters {

// The task of balancing the weights.
inline BalanceTask weights_of(const RestingPile& structure, int friction_edges = 0) {
  return BalanceTask{.contacts = structure.contacts, .friction_edges = friction_edges};
}

// Whether contact forces can hold a structure under its weight, by StaticEquilibrium.
inline bool balanced(const RestingPile& structure, int friction_edges = 0) {
  return StaticEquilibrium().solve(structure.world, weights_of(structure, friction_edges)).balanced;
}

// The same without friction, as a test beside the next ones.
inline bool whole_stands(const RestingPile& structure) { return balanced(structure); }

// Whether a structure is all towers, and none of them tips, by Towers.
inline bool towers_stand(const RestingPile& structure) {
  Towers towers;
  towers.run(structure.world, structure.contacts, {});
  for (int b = 0; b < structure.world.count(); ++b)
    if (structure.world.bodies()[idx(b)].movable() &&
        towers.states()[idx(b)] != TowerState::supported)
      return false;
  return true;
}

// The contacts below a body.
inline std::vector<int> supports_of(const RestingPile& structure, int body) {
  std::vector<int> list;
  for (int c = 0; c < static_cast<int>(structure.contacts.size()); ++c)
    if (upper_body(structure.contacts[idx(c)]) == body) list.push_back(c);
  return list;
}

// Whether a place is above the hull of contacts, up to rounding.
inline bool above(const RestingPile& structure, const std::vector<int>& contacts,
                  const Vec3& place_w) {
  std::vector<Vec2> points;
  std::vector<Vec2> hull;
  for (const int c : contacts)
    for (int p = 0; p < structure.contacts[idx(c)].count; ++p) {
      const Vec3& point_w = structure.contacts[idx(c)].points[idx(p)].position_w;
      points.emplace_back(point_w.x(), point_w.z());
    }
  convex_hull(points, hull);
  constexpr double rounding = 1e-12;  // [m]
  return hull_contains(hull, Vec2(place_w.x(), place_w.z()), rounding);
}

inline Vec3 middle_of(const Contact& contact) {
  Vec3 sum = Vec3::Zero();
  for (int p = 0; p < contact.count; ++p) sum += contact.points[idx(p)].position_w;
  return sum / contact.count;
}

// The simplest rule: whether each body's own centre is above its supports, whatever lies on it.
inline bool own_centres_stand(const RestingPile& structure) {
  for (int b = 0; b < structure.world.count(); ++b)
    if (structure.world.bodies()[idx(b)].movable() &&
        !above(structure, supports_of(structure, b), structure.world.states()[idx(b)].position_w))
      return false;
  return true;
}

// The next simplest rule: from the top down each body hands its load on at the middle of the area in which
// it touches the body below, or by the law of the lever at the middles of two areas. The centre of a body
// with its load has to be above its supports.
inline bool middles_stand(const RestingPile& structure) {
  const World& world = structure.world;
  std::vector<int> order(idx(world.count()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return world.states()[idx(a)].position_w.y() > world.states()[idx(b)].position_w.y();
  });
  std::vector<double> mass(order.size(), 0.0);             // with what was put on it
  std::vector<Vec3> moment_w(order.size(), Vec3::Zero());  // mass times place
  for (const int b : order) {
    const BodyProperties& body = world.bodies()[idx(b)];
    if (!body.movable()) continue;
    mass[idx(b)] += body.mass;
    moment_w[idx(b)] += body.mass * world.states()[idx(b)].position_w;
    const Vec3 centre_w = moment_w[idx(b)] / mass[idx(b)];
    const std::vector<int> below = supports_of(structure, b);
    if (!above(structure, below, centre_w)) return false;
    require::that(below.size() <= 2, "a rule for one or two contacts below a body");
    const auto hand_on = [&](int contact, double share) {
      const Contact& c = structure.contacts[idx(contact)];
      const int under = c.first == b ? c.second : c.first;
      mass[idx(under)] += share * mass[idx(b)];
      moment_w[idx(under)] += share * mass[idx(b)] * middle_of(c);
    };
    double share = 1.0;
    if (below.size() == 2) {
      const double a = middle_of(structure.contacts[idx(below[0])]).x();
      share = (middle_of(structure.contacts[idx(below[1])]).x() - centre_w.x()) /
              (middle_of(structure.contacts[idx(below[1])]).x() - a);
      if (share < 0.0 || share > 1.0) return false;
      hand_on(below[1], 1.0 - share);
    }
    hand_on(below[0], share);
  }
  return true;
}

// Where a verdict changes, by bisection until the two sides are neighbouring numbers.
// falls: [any] a value for which it is false
// holds: [any] a value for which it is true; above or below `falls`
// Returns [any] the last value found for which it is true; NaN if one of the two ends is not as said
inline double threshold(const std::function<bool(double)>& stands, double falls, double holds) {
  if (stands(falls) || !stands(holds)) return std::numeric_limits<double>::quiet_NaN();
  while (true) {
    const double middle = 0.5 * falls + 0.5 * holds;
    if (middle == falls || middle == holds) return holds;
    (stands(middle) ? holds : falls) = middle;
  }
}

// Work of the same question asked in two ways: do the bodies accelerate?
struct BalanceWork {
  BalanceReport equilibrium;         // the test
  int pivots = 0;                    // of Baraff's method for the problem of contact forces
  std::int64_t multiplications = 0;  // of it; setting up its matrix is not counted
  double fastest = 0.0;              // [m/s²] largest acceleration of a centre by that problem
};

// Asks in both ways.
inline BalanceWork work_of(const RestingPile& structure) {
  BalanceWork work;
  work.equilibrium = StaticEquilibrium().solve(structure.world, weights_of(structure));

  const std::vector<MovingBody>& moving = structure.bodies;
  std::vector<Acceleration> accelerations;
  free_accelerations(structure.world, moving, accelerations);
  ContactProblem problem;
  problem.assemble(structure.world, moving, accelerations, structure.contacts,
                   std::numeric_limits<double>::infinity());
  BaraffSolver solver;
  LcpResult result;
  solver.solve(problem.lcp(), result);
  if (result.status != LcpStatus::solved) throw std::runtime_error("Baraff's method failed");
  std::vector<Wrench> wrenches(moving.size());
  problem.add_wrenches(result.f, wrenches);
  accelerate(moving, wrenches, accelerations);
  work.fastest = largest_of(accelerations, [](const Acceleration& a) { return a.linear_w.norm(); });
  work.pivots = result.pivots;
  work.multiplications = result.multiplications;
  return work;
}

// Whether a scene stays as it is when it runs.
// seconds: [s] for how long, in steps of 1/60 s; ends early if something has moved
inline bool stays(const RestingPile& scene, std::string_view technique,
                  const std::vector<std::string>& settings, double seconds) {
  constexpr double moved = 0.01;  // [m]
  const std::unique_ptr<Technique> runs = make_technique(technique, settings);
  World world = scene.world;
  while (world.time() < seconds - 0.5 * kStep) {
    finished(runs->step(world, kStep));
    if (farthest_moved(scene.world.states(), world.states()) > moved) return false;
  }
  return true;
}

}  // namespace tumble::chapters
