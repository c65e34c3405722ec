/// \file
/// \brief Runs with stable boxes left out: energy, sliding, gaps, loads, and unwanted braking.
#include "tumble/analytic_lcp/analytic.hpp"

#include "support/test.hpp"

namespace tumble {
namespace {

constexpr std::array kRules = {StableRule::corners, StableRule::hull, StableRule::equilibrium};

int add(World& world, const Vec3& size, double mass, const Vec3& position_w,
        const Vec3& velocity_w = Vec3::Zero(), const Quat& turned = Quat::Identity()) {
  world.add(box_properties(size, mass), position_w, turned, velocity_w);
  return world.count() - 1;
}

Analytic technique(StableRule rule, AnalyticFriction friction = AnalyticFriction::none) {
  return Analytic({.friction = friction, .stable_boxes = rule});
}

double energy(const World& world) {
  double sum = 0.0;
  for (int b = 0; b < world.count(); ++b) {
    const BodyProperties& body = world.bodies()[idx(b)];
    if (!body.movable()) continue;
    sum += kinetic_energy(body, world.states()[idx(b)]) -
           body.mass * world.gravity_w.dot(world.states()[idx(b)].position_w);
  }
  return sum;
}

// [J] Change of energy in a run that is not booked.
double unbooked(World world, StableRule rule, int steps) {
  Analytic analytic = technique(rule);
  double worst = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double before = energy(world);
    const StepReport report = analytic.step(world, kFrame);
    const BookedEnergy& e = report.energy;
    const double booked = e.restitution + e.friction + e.damping + e.repair;
    worst = std::max(worst, std::abs(energy(world) - before - booked));
  }
  return worst;
}

}  // namespace

TEST_CASE("The energy that holding stable boxes removes is booked",
          "[exact][geometric_stability]") {
  for (const StableRule rule : kRules) {
    World heavy = ground_world();
    add(heavy, Vec3::Ones(), 1000.0, Vec3(0.0, 0.5, 0.0), Vec3(0.0, -0.9e-3, 0.0));
    CHECK(unbooked(heavy, rule, 30) < 1e-9);  // [J] of 10 kJ; measured 4e-12

    World sliding = ground_world();
    add(sliding, Vec3(4.0, 1.0, 2.0), 8.0, Vec3(0.0, 0.5, 0.0));
    add(sliding, Vec3::Ones(), 1.0, Vec3(-1.0, 1.5, 0.0), Vec3(0.5, 0.0, 0.0));
    add(sliding, Vec3(0.5, 0.5, 0.5), 0.2, Vec3(-1.0, 2.25, 0.0), Vec3(0.7, 0.0, 0.0));
    CHECK(unbooked(sliding, rule, 60) < 1e-9);  // [J] of 100 J
  }
}

TEST_CASE("Boxes that slide along each other or along a wall are not braked by being left out",
          "[exact][geometric_stability]") {
  for (const StableRule rule : kRules) {
    World world = ground_world();
    const int first = add(world, Vec3::Ones(), 1.0, Vec3(0.0, 0.5, 0.0), Vec3(0.0, 0.0, 2e-3));
    add(world, Vec3::Ones(), 1.0, Vec3(1.0, 0.5, 0.0), Vec3(0.0, 0.0, 2e-3));
    Analytic analytic = technique(rule);
    for (int k = 0; k < 60; ++k) analytic.step(world, kFrame);
    CHECK(std::abs(world.states()[idx(first)].position_w.z() - 2e-3) < 1e-12);  // [m] free
  }
}

TEST_CASE("Between boxes that are left out no force of an earlier instant is left",
          "[unit][geometric_stability]") {
  World world = ground_world();
  add(world, Vec3::Ones(), 1.0, Vec3(0.0, 0.5, 0.0));
  std::vector<MovingBody> bodies = test::moving_bodies(world);
  ContactList contacts;
  const std::array pairs = {IndexPair{0, 1}};
  gather_contacts(world, bodies, pairs, 1e-9, {}, contacts);
  REQUIRE(contacts.size() == 1);
  for (ContactPoint& p : contacts[0].points) p.normal_impulse = 123.0;
  ContactForces forces({.friction = false, .stable_boxes = StableRule::corners});
  const ForceReport report = forces.solve(world, bodies, contacts, {});
  CHECK(report.stable == 1);
  CHECK(report.unknowns == 0);
  for (const ContactPoint& p : contacts[0].points) CHECK(p.normal_impulse == 0.0);
}

TEST_CASE("Damping does not brake boxes that have no weight, whichever bodies are left out",
          "[exact][geometric_stability]") {
  for (const StableRule rule : {StableRule::off, StableRule::corners, StableRule::equilibrium}) {
    World world = weightless_world();
    world.add_ground();
    add(world, Vec3(4.0, 1.0, 1.0), 4.0, Vec3(0.0, 0.5, 0.0));
    const int cube = add(world, Vec3::Ones(), 1.0, Vec3(0.0, 1.5, 0.0), Vec3(1.0, 0.0, 0.0));
    Analytic analytic = technique(rule, AnalyticFriction::damping);
    for (int k = 0; k < 30; ++k) analytic.step(world, kFrame);
    CHECK(std::abs(BodyView(world, cube).velocity_w().x() - 1.0) < 1e-12);
  }
}

TEST_CASE("A light box under a heavy one is held only if its support is that much more exact",
          "[exact][geometric_stability]") {
  // A millionth of a radian: a load of 1e4 times its weight accelerates it aside by a hundredth of g.
  const double angle = 0.9e-6;  // [rad]
  const Quat turned(std::sqrt(1.0 - 0.25 * angle * angle), 0.0, 0.0, 0.5 * angle);
  const Vec3 up = turned * Vec3::UnitY();
  for (const double mass : {1.0, 1e4}) {
    World world;
    const BodyProperties floor = fixed_box_properties(Vec3(10.0, 1.0, 10.0));
    world.add(floor, Vec3::Zero(), turned);
    const int light = add(world, Vec3::Ones(), 1.0, 1.0 * up, Vec3::Zero(), turned);
    add(world, Vec3::Ones(), mass, 2.0 * up, Vec3::Zero(), turned);
    Analytic analytic = technique(StableRule::hull);
    analytic.step(world, kFrame);
    CHECK((analytic.held()[idx(light)] != 0) == (mass == 1.0));
  }
}

TEST_CASE("A box above a closing gap is not held until the gap has closed",
          "[exact][geometric_stability]") {
  for (const StableRule rule : kRules) {
    World world = ground_world();
    const int box = add(world, Vec3::Ones(), 1.0, Vec3(0.0, 0.5 + 5e-5, 0.0));
    Analytic analytic = technique(rule);
    analytic.step(world, kFrame);
    CHECK(analytic.held()[idx(box)] == 0);
    for (int k = 0; k < 600; ++k) analytic.step(world, kFrame);
    CHECK(world.states()[idx(box)].position_w.y() - 0.5 < 2e-6);  // [m] contact_gap is 1e-6
  }
}

}  // namespace tumble
