/// \file
/// \brief One velocity-level step: energy, momentum, redundant points.
#include "tumble/analytic_lcp/velocity_step.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

// A world with velocities that can be stepped, without geometry: contacts are put down by hand.
struct RandomScene {
  World world;
  std::vector<MovingBody> bodies;
  std::vector<Contact> contacts;
  std::vector<Acceleration> free;
  VelocityStep step;
  VelocityStepOptions options;

  void load() {
    load_moving_bodies(world, bodies);
    free.assign(bodies.size(), Acceleration{});
    for (Contact& contact : contacts)
      contact.points[0].approach_speed = contact.normal_w.dot(motion_at(contact));
  }
  Vec3 motion_at(const Contact& contact) const {
    return relative_velocity(bodies[idx(contact.first)], bodies[idx(contact.second)],
                             contact.points[0].position_w);
  }
  VelocityStepResult solve() { return step.solve(world, free, contacts, kFrame, options, bodies); }
  double kinetic() const {
    World copy = world;
    store_moving_bodies(bodies, copy);
    double sum = 0.0;
    for (std::size_t k = 0; k < copy.bodies().size(); ++k)
      sum += kinetic_energy(copy.bodies()[k], copy.states()[k]);
    return sum;
  }
};

// Four boxes, the first of them fixed or not, and random points between them.
RandomScene random_scene(Random& random, bool with_fixed) {
  RandomScene scene;
  scene.world.gravity_w.setZero();
  for (int k = 0; k < 4; ++k) {
    const Vec3 size = Vec3::Constant(1.0) + random.in_cube(0.5);
    const double mass = random.uniform(0.5, 2.0);
    const bool fixed = with_fixed && k == 0;
    const BodyProperties body = fixed ? fixed_box_properties(size) : box_properties(size, mass);
    const Vec3 place_w = random.in_cube(1.0);
    const Quat turned = random.orientation();
    const Vec3 velocity_w = fixed ? Vec3(Vec3::Zero()) : random.in_cube(2.0);
    const Vec3 spin_w = fixed ? Vec3(Vec3::Zero()) : random.in_cube(2.0);
    scene.world.add(body, place_w, turned, velocity_w, spin_w);
  }
  const int count = 1 + static_cast<int>(random.below(6));
  for (int k = 0; k < count; ++k) {
    const int first = static_cast<int>(random.below(3));
    const int second =
        first + 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(3 - first)));
    const Vec3 place_w = random.in_cube(1.0);
    const Vec3 normal_w = random.direction();
    scene.contacts.push_back(
        contact_at(first, second, place_w, normal_w, k % 3 == 0 ? 0.0 : random.uniform(0.0, 1.5)));
    scene.contacts.back().points[0].distance = k % 2 == 0 ? 0.0 : random.uniform(0.0, 0.05);
  }
  scene.load();
  return scene;
}

}  // namespace

TEST_CASE("Without restitution and forces no step raises the kinetic energy of 1000 random states",
          "[unit][velocity_step][analytic_lcp]") {
  Random random(71);
  int unsolved = 0;
  double worst_gain = 0.0;
  double worst_sinking = 0.0;
  double worst_drag = 0.0;
  for (int trial = 0; trial < 1000; ++trial) {
    RandomScene scene = random_scene(random, true);
    scene.options.directions = trial % 2 == 0 ? 4 : 8;
    const double before = scene.kinetic();
    if (!scene.solve().solved) {
      ++unsolved;
      continue;
    }
    worst_gain = std::max(worst_gain, (scene.kinetic() - before) / before);
    for (const Contact& contact : scene.contacts) {
      const ContactPoint& point = contact.points[0];
      const Vec3 u = scene.motion_at(contact);
      worst_sinking = std::max(worst_sinking, -(contact.normal_w.dot(u) + point.distance / kFrame));
      worst_drag = std::max(
          worst_drag, point.friction_impulse_w.norm() - contact.friction * point.normal_impulse);
    }
  }
  CHECK(unsolved == 0);
  CHECK(worst_gain < 1e-12);    // [-] rounding
  CHECK(worst_sinking < 1e-9);  // [m/s] of a few
  CHECK(worst_drag < 1e-9);     // [N s] the pyramid is inside the cone
}

TEST_CASE("A contact that is there twice changes nothing but the shares of its points",
          "[unit][velocity_step][analytic_lcp]") {
  Random random(79);
  double worst = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    RandomScene once = random_scene(random, true);
    once.contacts.resize(1);  // one point: the answer is unique
    RandomScene twice = once;
    twice.contacts.push_back(twice.contacts[0]);
    REQUIRE(once.solve().solved);
    REQUIRE(twice.solve().solved);
    for (std::size_t k = 0; k < once.bodies.size(); ++k)
      worst = std::max(worst, (once.bodies[k].velocity_w - twice.bodies[k].velocity_w).norm());
  }
  CHECK(worst < 1e-9);  // [m/s]
}

TEST_CASE("Restitution that would raise the energy is reduced, and that is counted",
          "[unit][velocity_step][analytic_lcp]") {
  Random random(83);
  int fallbacks = 0;
  double worst_gain = 0.0;
  int unsolved = 0;
  for (int trial = 0; trial < 500; ++trial) {
    RandomScene scene = random_scene(random, true);
    for (Contact& contact : scene.contacts) {
      contact.restitution = random.uniform(0.0, 1.0);
      contact.points[0].distance = 0.0;
    }
    const double before = scene.kinetic();
    const VelocityStepResult result = scene.solve();
    if (!result.solved) {
      ++unsolved;
      continue;
    }
    fallbacks += result.fallbacks;
    worst_gain = std::max(worst_gain, (scene.kinetic() - before) / before);
  }
  CHECK(unsolved == 0);
  CHECK(worst_gain < 1e-12);  // [-] rounding
  CHECK(fallbacks > 0);
}

TEST_CASE("A step leaves the bodies alone when it is refused",
          "[unit][velocity_step][analytic_lcp]") {
  Random random(89);
  RandomScene scene = random_scene(random, true);
  scene.options.directions = 5;
  CHECK_THROWS_WITH(scene.solve(), Contains("directions"));
  scene.options.directions = 4;
  CHECK_THROWS_WITH(
      scene.step.solve(scene.world, scene.free, scene.contacts, -1.0, scene.options, scene.bodies),
      Contains("dt"));
  scene.free.pop_back();
  CHECK_THROWS_WITH(scene.solve(), Contains("one entry for each body"));
}
