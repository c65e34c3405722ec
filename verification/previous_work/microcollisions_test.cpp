/// \file
/// \brief Everything as a train of collisions: bounces, rest, slopes, an impact of Routh's, and the cap.
#include "tumble/previous_work/microcollisions.hpp"

#include "tumble/dynamics/step_report.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/runs.hpp"
#include "support/test.hpp"

namespace {

// [m] how far a flat box is down a tilted plane after ten seconds, and how fast it moved on average in the second half
struct Slide {
  double way = 0.0, speed = 0.0;
};

Slide slide(double degrees, double friction, double duration, double rebound = 0.01) {
  World world = tilted_plane(degrees, friction);
  Microcollisions technique({.rebound = rebound});
  const int half = static_cast<int>(std::lround(0.5 * duration / kFrame));
  run(world, technique, half);
  const double middle = world.states()[1].position_w.x();
  run(world, technique, half);
  const double end = world.states()[1].position_w.x();
  return {end, (end - middle) / (0.5 * duration)};
}

}  // namespace

TEST_CASE(
    "A cube that bounces under microcollisions keeps to the closed form until its hops are small",
    "[exact][microcollisions]") {
  World world = ground_world(0.5, 0.5);
  world.add(box_properties(Vec3::Ones(), 1.0, 0.5, 0.5), Vec3(0.0, 1.5, 0.0));
  Microcollisions technique;
  Listener seen;
  technique.observe(&seen);
  CHECK(run(world, technique, 120) == 0);
  // Falls for sqrt(2 h / g); each bounce has half the speed of the one before.
  double time = std::sqrt(2.0 / kGravity), speed = std::sqrt(2.0 * kGravity);
  REQUIRE(seen.events.size() > 20);
  for (std::size_t k = 0; speed > 0.1; ++k) {
    CHECK(seen.events[k].time == near(time, 1e-5));
    CHECK(seen.events[k].impulse_w.y() == near(1.5 * speed, 1e-4));
    speed *= 0.5;
    time += 2.0 * speed / kGravity;
  }
}

TEST_CASE("A cube at rest is carried by hops of a twentieth of a millimetre",
          "[exact][microcollisions]") {
  World world = stack_of(1);
  Microcollisions technique;
  Listener seen;
  technique.observe(&seen);
  const double w = 0.01 * std::sqrt(kGravity);  // [m/s]
  double highest = 0.0;
  StepReport sum;
  for (int k = 0; k < 120; ++k) {
    add_report(technique.step(world, kFrame), sum);
    highest = std::max(highest, world.states()[1].position_w.y() - 0.5);
  }
  CHECK(sum.status == StepStatus::done);
  CHECK(highest <= 0.5 * w * w / kGravity * (1.0 + 1e-6));
  // A hop lasts 2 w / g, and gives 2 m w.
  CHECK(static_cast<double>(sum.events) == near(2.0 * kGravity / (2.0 * w), 2.0));
  double push = 0.0;
  for (const Event& event : seen.events) push += event.impulse_w.y();
  CHECK(push == near(2.0 * kGravity, 2.1 * w));  // [N s]
  // All energy that is there is that of the hops, and booked.
  CHECK(energy_of(world).total() - 0.5 * kGravity == near(sum.energy.total(), 1e-12));
  CHECK(energy_of(world).total() - 0.5 * kGravity == near(0.5 * w * w, 1e-9));
}

TEST_CASE("A box on a slope below the angle of friction stays, on a train of microcollisions",
          "[exact][microcollisions]") {
  const double w = 0.01 * std::sqrt(kGravity * 0.2);  // [m/s]
  for (const double degrees : {5.0, 10.0, 15.0})
    CHECK(std::abs(slide(degrees, 0.8, 4.0).speed) < 2e-3 * w);  // measured: 1e-4 of it
  // An edge of this box that is hit alone needs 0.52 to stay. With less it creeps, and a tenth of the hops is a tenth of that.
  const double creep = slide(10.0, 0.3, 4.0).speed;
  CHECK(creep < 0.2 * w);  // measured: 0.11
  CHECK(slide(10.0, 0.3, 4.0, 0.001).speed < 0.2 * creep);
  // Above, it slides as Coulomb has it.
  const double angle = 25.0 * std::numbers::pi / 180.0;
  const double way = 0.5 * kGravity * (std::sin(angle) - 0.3 * std::cos(angle)) * 4.0;
  CHECK(slide(25.0, 0.3, 2.0).way == near(way, 0.01 * way));
}

TEST_CASE("A cube that falls on an edge gets the impulse of Routh's construction",
          "[exact][microcollisions]") {
  // Turned by 30° about z: the edge below is off the centre by x, y.
  const double angle = std::numbers::pi / 6.0;
  const Quat turned(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
  const double x = std::numbers::sqrt2 / 2.0 * std::cos(0.25 * std::numbers::pi + angle);
  const double y = std::numbers::sqrt2 / 2.0 * std::sin(0.25 * std::numbers::pi + angle);
  const double a = 1.0 + 6.0 * y * y, b = 6.0 * x * y, c = 1.0 + 6.0 * x * x;
  for (const double slip : {0.1, 4.0}) {
    for (const double friction : {0.2, 0.5}) {
      World world = weightless_world();
      world.add_ground(friction, 0.5);
      const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, friction, 0.5);
      world.add(cube, Vec3(0.0, y + 1e-3, 0.0), turned, Vec3(slip, -2.0, 0.0));
      Microcollisions technique;
      Listener seen;
      technique.observe(&seen);
      technique.step(world, 2e-3);
      REQUIRE(seen.events.size() == 1);
      // The edge is at -x from the centre of a cube that is turned to the left, or at +x: the sign of the coupling.
      const double side =
          seen.events[0].point_w.x() < world.states()[1].position_w.x() ? -1.0 : 1.0;
      const double coupling = side * b;  // K_tn = -(-y)(side x) / I
      SlidingImpact impact{.velocity_w = Vec3(slip, -2.0, 0.0)};
      impact.inverse_mass_w << a, coupling, 0.0, coupling, c, 0.0, 0.0, 0.0,
          1.0 + 6.0 * y * y + 6.0 * x * x;
      impact.friction = friction;
      impact.restitution = 0.5;
      const Vec3 right = solve_sliding_impact(impact).impulse_w;
      CAPTURE(slip, friction);
      CHECK((seen.events[0].impulse_w - right).norm() < 1e-9 * right.norm());
    }
  }
}

TEST_CASE("A stack stands on microcollisions, with impacts in step with the square of its height",
          "[unit][microcollisions]") {
  std::array<double, 2> impacts{};
  for (const int count : {2, 6}) {
    World world = world_of("stack", {{"count", std::to_string(count)}, {"scatter", "0.005"}}, 3);
    const World start = world;
    Microcollisions technique;
    StepReport sum;
    for (int k = 0; k < 60; ++k) add_report(technique.step(world, kFrame), sum);
    CHECK(sum.status == StepStatus::done);
    CHECK(distance_of(world, start) < 0.02);  // [m]
    impacts[count == 2 ? 0 : 1] = static_cast<double>(sum.events);
  }
  CHECK(impacts[1] > 5.0 * impacts[0]);  // 3 if it were the height; measured: 9.5
}

TEST_CASE("A step of microcollisions never has more impacts than its cap",
          "[unit][microcollisions]") {
  World world = stack_of(6);
  for (std::size_t k = 1; k < 7; ++k) world.states()[k].linear_momentum_w.y() = -1.0;
  Microcollisions technique({.event_cap = 20});
  bool capped = false;
  for (int k = 0; k < 30; ++k) {
    const StepReport report = technique.step(world, kFrame);
    CHECK(report.events <= 20);
    CHECK((report.status == StepStatus::done || report.status == StepStatus::event_cap));
    capped = capped || report.status == StepStatus::event_cap;
  }
  CHECK(capped);
  // Nothing slows a bounce without a slowest rebound, and the cap ends it.
  World zeno = stack_of(1, 0.5, 0.5);
  zeno.states()[1].position_w.y() += 0.01;
  Microcollisions bounces({.rebound = 0.0, .event_cap = 500});
  CHECK(run(zeno, bounces, 60) > 0);
}

TEST_CASE("With each broad phase microcollisions go through the same bits",
          "[determinism][microcollisions]") {
  std::string hash;
  for (const std::string_view name : broad_phase_names()) {
    World world = world_of("pyramid", {{"rows", "3"}, {"scatter", "0.02"}});
    Microcollisions technique({.broad_phase = name});
    run(world, technique, 12);
    if (hash.empty()) hash = world.hash().text();
    CAPTURE(name);
    CHECK(world.hash().text() == hash);
  }
  CHECK_THROWS_WITH(Microcollisions({.broad_phase = "tree"}), Contains("octree"));
}

TEST_CASE("Microcollisions refuse what makes no sense", "[unit][microcollisions]") {
  CHECK_THROWS_WITH(Microcollisions({.rebound = 2.0}), Contains("rebound = 2"));
  CHECK_THROWS_WITH(Microcollisions({.event_cap = 0}), "tumble: event_cap = 0: expected 1 or more");
}
