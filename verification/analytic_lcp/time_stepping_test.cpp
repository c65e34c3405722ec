/// \file
/// \brief Time stepping: stacks and impacts, without a search for events.
#include "tumble/analytic_lcp/time_stepping.hpp"

#include "support/pose.hpp"
#include "support/runs.hpp"
#include "support/test.hpp"

namespace {

BodyId add_cube(World& world, const Vec3& position_w, const Vec3& velocity_w = Vec3::Zero(),
                double friction = 0.5, double restitution = 0.0) {
  return world.add(box_properties(Vec3::Ones(), 1.0, friction, restitution), position_w,
                   Quat::Identity(), velocity_w);
}

// Rows of cubes, each row shifted by half a cube.
World pyramid_of(int rows, double friction = 0.5) {
  World world = ground_world(friction);
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < rows - row; ++k)
      add_cube(world, Vec3(1.05 * (k - 0.5 * (rows - row - 1)), row + 0.5, 0.0), Vec3::Zero(),
               friction);
  return world;
}

}  // namespace

// --- rest ---------------------------------------------------------------------------------------

TEST_CASE("A stack of ten and a small pyramid stand", "[unit][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  for (World world : {stack_of(10), pyramid_of(4)}) {
    const World start = world;
    TimeStepping technique(posed<TimeSteppingOptions>());
    double worst = 0.0;
    double booked = 0.0;
    for (int k = 0; k < 300; ++k) {
      const StepReport report = technique.step(world, kFrame);
      REQUIRE(report.status == StepStatus::done);
      worst = std::max(worst, fastest(world));
      booked = std::max(booked, std::abs(report.energy.total()));
    }
    CHECK(worst < 1e-9);    // [m/s], [rad/s] below what friction answers to: measured 1e-10
    CHECK(booked < 1e-10);  // [J] what rests does no work
    CHECK(distance_of(world, start) < 1e-8);  // [m] measured 2e-10
  }
}

TEST_CASE("Contacts at rest bear the weight above them", "[exact][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  World world = stack_of(5);
  TimeStepping technique(posed<TimeSteppingOptions>());
  technique.step(world, kFrame);
  std::array<double, 6> carried{};
  for (const ContactRecord& record : technique.contacts())
    carried[number_of(record.second)] += record.push_w.y();
  for (int level = 1; level <= 5; ++level)
    CHECK(carried[idx(level)] == Approx((6 - level) * kGravity * kFrame));  // [N s]
}

// --- impacts ------------------------------------------------------------------------------------

TEST_CASE("A falling box closes its gap exactly and then rests",
          "[exact][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  World world = ground_world();
  add_cube(world, Vec3(0.0, 1.5, 0.0));
  TimeStepping technique(posed<TimeSteppingOptions>());
  double lowest = 1.0;
  for (int k = 0; k < 120; ++k) {
    technique.step(world, kFrame);
    lowest = std::min(lowest, world.states()[1].position_w.y() - 0.5);
  }
  CHECK(std::abs(lowest) < 1e-12);  // [m] neither a gap nor an overlap
  CHECK(fastest(world) < 1e-12);    // [m/s]
}

TEST_CASE("A bullet does not pass a thin wall", "[unit][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  World world = weightless_world();
  const BodyProperties wall = fixed_box_properties(Vec3(0.01, 2.0, 2.0));
  world.add(wall, Vec3::Zero());
  const BodyProperties bullet = box_properties(Vec3::Constant(0.1), 1.0);
  for (const double speed : {10.0, 100.0, 1000.0}) {
    World shot = world;
    shot.add(bullet, Vec3(-5.0, 0.0, 0.0), Quat::Identity(), Vec3(speed, 0.0, 0.0));
    TimeStepping technique(posed<TimeSteppingOptions>());
    CHECK(run(shot, technique, 60) == 0);
    CHECK(shot.states()[1].position_w.x() == Approx(-0.055));  // [m] at the wall
  }
}

TEST_CASE("In Anitescu and Potra's form a fast body sinks in before it is stopped",
          "[unit][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  World world = ground_world();
  add_cube(world, Vec3(0.0, 0.55, 0.0), Vec3(0.0, -6.0, 0.0));
  TimeSteppingOptions options;
  options.velocities.form = SteppingForm::anitescu_potra;
  TimeStepping technique(posed(options));
  const StepReport report = technique.step(world, kFrame);
  // h (6 + g h) - 0.05 m, and then it is moved out again.
  CHECK(report.deepest_overlap == Approx((6.0 + kGravity * kFrame) * kFrame - 0.05));
  CHECK(report.energy.repair > 0.0);
  run(world, technique, 10);
  CHECK(fastest(world) < 1e-12);  // [m/s]
}

TEST_CASE("What a step books is what the energy does", "[exact][time_stepping][analytic_lcp]") {
  BOTH_POSES;
  // Also that gravity's impulse m g h acts at v+ in the positions and at (v- + v+)/2 in the velocities.
  World world = ground_world();
  add_cube(world, Vec3(0.0, 0.8, 0.0), Vec3(2.0, -3.0, 0.0));
  TimeStepping technique(posed<TimeSteppingOptions>());
  double worst = 0.0;
  for (int k = 0; k < 60; ++k) {
    const Energy before = energy_of(world);
    const StepReport report = technique.step(world, kFrame);
    worst = std::max(worst,
                     std::abs(energy_of(world).total() - before.total() - report.energy.total()));
  }
  CHECK(worst < 1e-12);  // [J] rounding of 13 J: measured below
}

// --- what holds for all scenes ------------------------------------------------------------------

// With pose=separate: of two that a box stands on, it follows the first in the list.
TEST_CASE("Without friction a scene, its mirror image and its bodies in another order do the same",
          "[unit][time_stepping][analytic_lcp]") {
  // With friction what redundant points share is not determined, and neither is what they do next.
  const Vec3 mirror(-1.0, 1.0, 1.0);
  World world = pyramid_of(3, 0.0);
  add_cube(world, Vec3(-4.0, 1.2, 0.1), Vec3(12.0, 1.0, 0.0), 0.0);
  World image = ground_world(0.0);
  World other_order = ground_world(0.0);
  const std::size_t count = world.bodies().size();
  for (std::size_t k = 1; k < count; ++k) {
    BodyState state = world.states()[k];
    state.position_w = state.position_w.cwiseProduct(mirror);
    state.linear_momentum_w = state.linear_momentum_w.cwiseProduct(mirror);
    image.add(world.bodies()[k], state);
    other_order.add(world.bodies()[count - k], world.states()[count - k]);
  }
  TimeStepping first(posed<TimeSteppingOptions>());
  TimeStepping second(posed<TimeSteppingOptions>());
  TimeStepping third(posed<TimeSteppingOptions>());
  double worst = 0.0;
  for (int k = 0; k < 15; ++k) {
    first.step(world, kFrame);
    second.step(image, kFrame);
    third.step(other_order, kFrame);
    for (std::size_t b = 1; b < count; ++b) {
      const Vec3& place = world.states()[b].position_w;
      worst = std::max({worst, (image.states()[b].position_w.cwiseProduct(mirror) - place).norm(),
                        (other_order.states()[count - b].position_w - place).norm()});
    }
  }
  CHECK(worst < 1e-9);  // [m] rounding, grown by impacts
}
