/// \file
/// \brief Checks of a run: energy that comes from nowhere, bodies that pass through others, large turns.
#include "tumble/record/run_checks.hpp"

#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/record/passage_check.hpp"
#include "tumble/record/run.hpp"

#include "support/test.hpp"

namespace {

using Catch::Matchers::StartsWith;

// Moves all bodies as if there were no contacts.
class Ghosts : public Cloned<Technique, Ghosts> {
 public:
  double gain = 1.0;  // [-] of momentum, in each step

  [[nodiscard]] std::string_view name() const override { return "ghosts"; }
  StepReport step(World& world, double dt) override {
    for (std::size_t k = 0; k < world.states().size(); ++k) {
      world.states()[k].linear_momentum_w *= gain;
      advance_pose(world.bodies()[k], world.states()[k], dt, RotationRule::splitting);
    }
    world.finish_step(dt);
    return {};
  }
};

// The same, but spins turn back at four fifths of each step.
class TurningBack : public Ghosts {
 public:
  StepReport step(World& world, double dt) override {
    for (const double part : {0.8, 0.2}) {
      for (std::size_t k = 0; k < world.states().size(); ++k) {
        BodyState& state = world.states()[k];
        if (part < 0.5) state.angular_momentum_w *= -1.0;
        advance_pose(world.bodies()[k], state, part * dt, RotationRule::splitting);
      }
    }
    world.finish_step(dt);
    return {};
  }
};

SceneBox cube(const std::string& name, const Vec3& position_w, const Vec3& velocity_w) {
  return {.name = name, .position_w = position_w, .velocity_w = velocity_w};
}

RunResult ran(const Scene& scene, double gain = 1.0) {
  Ghosts ghosts;
  ghosts.gain = gain;
  return run_scene(scene, ghosts, {.dt = 0.1, .duration = 1.0}, {});
}

// It has one finding, and what that has to say.
template <class Matcher>
void check_found(const RunResult& run, StepStatus worst, const Matcher& says) {
  CHECK(run.worst == worst);
  REQUIRE(run.findings.size() == 1);
  CHECK_THAT(run.findings[0], says);
}

Scene two(const Vec3& second_w, const Vec3& first_velocity_w, const Vec3& second_velocity_w) {
  Scene scene{.gravity_w = Vec3::Zero()};
  scene.boxes = {cube("left", Vec3(-2.2, 0.0, 0.0), first_velocity_w),
                 cube("right", second_w, second_velocity_w)};
  return scene;
}

// A rod of 2 m and 5 mm that falls on the ground and spins about its axis, by a third of a radian in a step; a blow at
// its end makes that many radians.
Scene falling_rod() {
  Scene scene{.ground = SceneGround{0.4, 0.2}};
  SceneBox rod{.name = "rod", .size = Vec3(2.0, 0.005, 0.005), .position_w = Vec3(0.0, 1.2, 0.0)};
  rod.orientation_wb =
      Quat(0.976382586165042, -0.022665635416815, 0.128543206069468, 0.172162593434805);
  rod.orientation_wb.normalize();
  rod.angular_velocity_w = Vec3(0.0, 0.0, 20.0);
  rod.friction = 0.4;
  rod.restitution = 0.2;
  scene.boxes = {rod};
  return scene;
}

// Flies and turns by two radians in 0.1085 s.
Scene spinning_plate() {
  Scene scene{.gravity_w = Vec3::Zero()};
  SceneBox box{.size = Vec3(4.4, 2.3, 0.36), .angular_velocity_w = Vec3(-2.5, -5.7, -17.5)};
  scene.boxes = {box};
  return scene;
}

}  // namespace

TEST_CASE("A body that goes through another one within a step is found", "[unit][record][run]") {
  // 4 m in a step: from 2.2 m left of the middle to 1.8 m right of it.
  const Vec3 fast(40.0, 0.0, 0.0);
  check_found(ran(two(Vec3(0.0, 0.5, 0.3), fast, Vec3::Zero())), StepStatus::passed_through,
              StartsWith("step 1 at 0.1 s: left went through right"));

  const RunResult meeting = ran(two(Vec3(0.5, 0.5, 0.0), 0.5 * fast, -0.5 * fast));
  CHECK(meeting.worst == StepStatus::passed_through);

  SECTION("the same ways beside each other are no passage") {
    CHECK(ran(two(Vec3(0.0, 1.0, 0.0), fast, Vec3::Zero())).worst == StepStatus::done);
    CHECK(ran(two(Vec3(0.0, 0.95, 0.0), fast, fast)).worst == StepStatus::done);
  }
  SECTION("those of a body that turns are looked at as it turns") {
    Scene scene = two(Vec3(0.0, 0.75, 0.3), fast, Vec3::Zero());
    scene.boxes[0].angular_velocity_w = Vec3(0.0, 9.0, 0.0);
    CHECK(ran(scene).worst == StepStatus::passed_through);
    scene.boxes[1].position_w.y() = 0.95;
    CHECK(ran(scene).worst == StepStatus::done);
  }
}

TEST_CASE("A box that appears inside another one is named, and how deep", "[unit][record][run]") {
  Scene scene = two(Vec3(0.0, 0.0, 0.0), Vec3::Zero(), Vec3::Zero());
  SceneBox late = cube("late", Vec3(0.7, 0.0, 0.0), Vec3::Zero());
  late.appears = 0.3;
  scene.boxes.push_back(late);

  SECTION("in a box") {
    const RunResult inside = ran(scene);
    REQUIRE(inside.findings.size() == 2);  // these ghosts also stay in each other
    CHECK(inside.findings[0] ==
          "step 3 at 0.3 s: late appears 0.3 m deep in right, and is pushed out, which can add "
          "energy: "
          "give it another position or another time to appear; up to 0.001 m is accepted");
    CHECK(inside.worst == StepStatus::passed_through);
  }
  SECTION("in the ground") {
    scene.ground = SceneGround{};
    scene.boxes[0].position_w.y() = scene.boxes[1].position_w.y() = 0.5;
    scene.boxes[2].position_w = Vec3(5.0, 0.2, 0.0);
    const RunResult sunk = ran(scene);
    REQUIRE(sunk.findings.size() == 2);
    CHECK(sunk.findings[0].find("late appears 0.3 m deep in ground") != std::string::npos);
  }
  SECTION("a little, which is no fault, but may add energy") {
    scene.boxes[2].position_w.x() = 0.95;
    scene.boxes[1].disappears = 0.35;
    const RunResult little = ran(scene);
    REQUIRE(little.findings.size() == 1);
    CHECK(little.worst == StepStatus::done);
  }
  SECTION("one that touches is not, nor a fixed one in a fixed one") {
    scene.boxes[2].position_w.x() = 0.9995;
    CHECK(ran(scene).findings.empty());
    scene.boxes[2].position_w.x() = 0.7;
    scene.boxes[1].fixed = scene.boxes[2].fixed = true;
    CHECK(ran(scene).findings.empty());
  }
}

TEST_CASE("A body that a step leaves inside another one, and the next one beyond, is found",
          "[unit][record][run]") {
  // 2.2 m in a step: wholly inside after the first, and 2.2 m beyond after the second.
  const Scene beyond = two(Vec3::Zero(), Vec3(22.0, 0.0, 0.0), Vec3::Zero());
  check_found(ran(beyond), StepStatus::passed_through,
              StartsWith("step 2 at 0.2 s: left went through right"));

  // Two that cross at right angles, and are in one place after the second step.
  Scene crossing = two(Vec3(0.0, 0.0, -2.2), Vec3(11.0, 0.0, 0.0), Vec3(0.0, 0.0, 11.0));
  CHECK(ran(crossing).worst == StepStatus::passed_through);

  // A spin hides no thin body that does not turn.
  Scene spins = two(Vec3::Zero(), Vec3(22.0, 0.0, 0.0), Vec3::Zero());
  spins.boxes[0].angular_velocity_w = Vec3(0.0, 400.0, 0.0);
  spins.boxes[1].size = Vec3(0.1, 4.0, 4.0);
  CHECK(ran(spins).worst == StepStatus::passed_through);
}

TEST_CASE("A body that goes through another one slowly is found, one that comes out again is not",
          "[unit][record][run]") {
  // 0.4 m in a step, six steps from one side to the other.
  check_found(ran(two(Vec3::Zero(), Vec3(4.0, 0.0, 0.0), Vec3::Zero())), StepStatus::passed_through,
              Contains("left went through right"));

  // To and fro, 0.3 m in and out again.
  Scene back = two(Vec3::Zero(), Vec3(-5.0, 0.0, 0.0), Vec3::Zero());
  back.boxes[0].position_w.x() = -1.2;
  CHECK(ran(back, -1.0).worst == StepStatus::done);
}

TEST_CASE("A body that spins through a thin one within a step is found", "[unit][record][run]") {
  Scene scene = two(Vec3(0.0, 0.0, 0.0), Vec3(40.0, 0.0, 0.0), Vec3::Zero());
  scene.boxes[1].size = Vec3(0.1, 4.0, 4.0);
  for (const double spin : {10.0, 10.0 * std::acos(-1.0) * 2.0, 400.0}) {  // [rad/s] for 0.1 s
    scene.boxes[0].angular_velocity_w = Vec3(0.0, spin, 0.0);
    CAPTURE(spin);
    CHECK(ran(scene).worst == StepStatus::passed_through);
  }
}

// A rod of 4 m that turns about its middle, and a cube of 0.3 m in the way of its end.
Scene rotor(double spin) {
  Scene scene{.gravity_w = Vec3::Zero()};
  scene.boxes = {cube("rotor", Vec3::Zero(), Vec3::Zero()),
                 cube("cube", Vec3(1.6, 0.0, -1.0), Vec3::Zero())};
  scene.boxes[0].size = Vec3(4.0, 0.2, 0.2);
  scene.boxes[0].angular_velocity_w = Vec3(0.0, spin, 0.0);
  scene.boxes[1].size.setConstant(0.3);
  return scene;
}

TEST_CASE("A body that turns through another one within a step is found", "[unit][record][run]") {
  // 0.56 rad away. The first of these is beyond it in one step, the last after a turn and more.
  for (const double spin : {11.0, 20.0, 75.0}) {
    CAPTURE(spin);
    const RunResult through = ran(rotor(spin));
    CHECK(through.worst == StepStatus::passed_through);
    REQUIRE(!through.findings.empty());
    CHECK(through.findings[0].find("step 1 at 0.1 s: rotor went through cube") == 0);
  }
  SECTION("the end of a rod that passes beside it does not") {
    Scene beside = rotor(11.0);
    beside.boxes[1].position_w.y() = 0.24;  // of 0.25
    CHECK(ran(beside).worst == StepStatus::done);
    beside.boxes[1].position_w = Vec3(1.8, 0.0, -1.2);
    CHECK(ran(beside).worst == StepStatus::done);
  }
  SECTION("a body whose spin has changed may have turned back") {
    TurningBack turning_back;
    RunSettings settings{.dt = 0.1, .duration = 0.1};
    const auto worst = [&](double spin) {
      return run_scene(rotor(spin), turning_back, settings, {}).worst;
    };
    CHECK(worst(6.0) == StepStatus::done);   // to 0.48 rad and back to 0.36
    CHECK(worst(15.0) == StepStatus::done);  // through it to 1.2 rad and back to 0.9: not known
  }
}

TEST_CASE("Faure's method lets a rotor through a block, and a run says so",
          "[unit][record][run][faure]") {
  RunSettings settings{.duration = 0.5};
  const auto worst = [&](std::string_view technique) {
    return run_scene(rotor(60.0), *make_technique(technique), settings, {}).worst;
  };
  CHECK(worst("faure") == StepStatus::passed_through);
  for (const std::string_view technique : {"contact_damped", "time_stepping", "analytic"}) {
    CAPTURE(technique);
    CHECK(worst(technique) == StepStatus::done);
  }
}

TEST_CASE("A body that is stopped far from what stops it is found", "[unit][record][run]") {
  Scene scene{.ground = SceneGround{},
              .boxes = {cube("cube", Vec3(0.0, 100.0, 0.0), Vec3(0.0, -1000.0, 0.0))}};
  RunSettings settings{.duration = 0.2};
  for (const std::string_view technique : {"impulse", "damped"}) {
    CAPTURE(technique);
    check_found(run_scene(scene, *make_technique(technique), settings, {}),
                StepStatus::held_by_nothing, StartsWith("step 6 at 0.1 s: cube was hit 16"));
  }
  for (const std::string_view technique :
       {"contact_damped", "time_stepping", "analytic", "timewarp_swept", "timewarp_full",
        "optimised", "microcollisions"}) {
    CAPTURE(technique);
    CHECK(run_scene(scene, *make_technique(technique), settings, {}).worst == StepStatus::done);
  }
}

TEST_CASE("Bodies at rest in free space may move by the rounding of their positions",
          "[unit][record][run]") {
  // Three that touch: particles and rods push by rounding.
  Scene scene = two(Vec3(1.0, 0.0, 0.0), Vec3::Zero(), Vec3::Zero());
  scene.boxes[0].position_w.setZero();
  scene.boxes.push_back(cube("third", Vec3(2.0, 0.2, 0.0), Vec3::Zero()));
  Simulation simulation(scene, "relaxation");
  EnergyCheck check;
  simulation.observe(check);
  for (int k = 0; k < 60; ++k) {
    simulation.step(1.0 / 60.0);
    CHECK(check.status() == StepStatus::done);
  }
}

TEST_CASE("Energy that nothing in the scene can add is found", "[unit][record][run]") {
  const Scene scene = two(Vec3(0.0, 5.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3::Zero());
  CHECK(ran(scene, 1.0004).worst == StepStatus::done);          // 0.8 % in ten steps
  CHECK(ran(scene, 1.001).worst == StepStatus::energy_gained);  // 2 %, and nothing is booked
  check_found(ran(scene, 1.01), StepStatus::energy_gained, Contains("left gained"));
}

TEST_CASE("A body that is left deep in another one when a run ends is found",
          "[unit][record][run]") {
  // From 2.2 m left of the middle to the place, in ten steps.
  const auto end_at = [](double x) {
    return ran(two(Vec3(0.0, 0.2, 0.0), Vec3(x + 2.2, 0.0, 0.0), Vec3::Zero()));
  };
  CHECK(end_at(-0.92).worst == StepStatus::done);
  check_found(end_at(-0.85), StepStatus::passed_through,
              Contains("left is left 0.15 m deep in another body, 15 %"));
}

TEST_CASE("A body that hangs in the air is found, one that rests or is thrown is not",
          "[unit][record][run]") {
  // Ghosts move with constant velocities: what has none hangs.
  Scene scene{.ground = SceneGround{}};
  scene.boxes = {cube("low", Vec3(0.0, 0.55, 0.0), Vec3::Zero()),
                 cube("upper", Vec3(0.0, 1.6, 0.0), Vec3::Zero())};
  CHECK(ran(scene).worst == StepStatus::done);  // each is near what may hold it
  scene.boxes[0].position_w.y() = 0.65;
  scene.boxes[1].position_w.y() = 1.7;
  check_found(ran(scene), StepStatus::held_by_nothing,
              StartsWith("step 3 at 0.3 s: low hangs in the air"));
  scene.gravity_w.setZero();
  CHECK(ran(scene).worst == StepStatus::done);

  // Steps of half a second, in which a cube flies up and back down; faint gravity; one that takes off late.
  Scene thrown;
  thrown.boxes = {cube("thrown", Vec3(0.0, 5.0, 0.0), Vec3(0.0, 0.5 * 9.81, 0.0)),
                  cube("dropped", Vec3(3.0, 5.0, 0.0), Vec3::Zero())};
  for (const double gravity : {9.81, 1e-6}) {
    for (const double dt : {1.0, 0.5, 0.01}) {
      thrown.gravity_w.y() = -gravity;
      Simulation simulation(thrown);
      RunSettings settings{.dt = dt, .duration = 10.0};
      CHECK(run_simulation(simulation, settings, {}).worst == StepStatus::done);
    }
  }
}

TEST_CASE("A turn of more than a radian in a step is named with a step that would do",
          "[unit][record][run]") {
  Scene scene = two(Vec3(0.0, 5.0, 0.0), Vec3::Zero(), Vec3::Zero());
  scene.boxes[1].angular_velocity_w = Vec3(0.0, 20.0, 0.0);
  check_found(ran(scene), StepStatus::done,
              Contains("right rotates by 2 rad") && Contains("--dt 0.025"));
  scene.boxes[1].angular_velocity_w = Vec3(0.0, 9.9, 0.0);
  CHECK(ran(scene).findings.empty());
}

// --- techniques that divide such steps -------------------------------------------------------------

TEST_CASE("A step is divided by the turn of the fastest body", "[unit][contact]") {
  const auto parts = [](double speed) {
    Scene scene{.boxes = {SceneBox{}, SceneBox{}}};
    scene.boxes[0].position_w = Vec3(9.0, 0.0, 0.0);
    scene.boxes[1].angular_velocity_w = Vec3(0.0, speed, 0.0);
    return parts_of_turn(start_world(scene), 1.0);
  };
  CHECK(parts(0.9) == 1);
  CHECK(parts(7.5) == 8);
  CHECK(parts(1e5) == 1000);
  CHECK(parts(3e8) == 1);  // parts would not help
}

TEST_CASE("A rod that turns by radians in a step gains no energy and comes to rest",
          "[unit][impulse][impulse_damped]") {
  Simulation simulation(falling_rod(), "impulse");
  simulation.update_boxes();
  const double start = energy_of(simulation.world()).total();
  double most = start;
  for (int k = 0; k < 180; ++k) {
    REQUIRE(simulation.step(1.0 / 60.0).status == StepStatus::done);
    most = std::max(most, energy_of(simulation.world()).total());
  }
  CHECK(most <= start * (1.0 + 1e-3));
  CHECK(energy_of(simulation.world()).kinetic < 0.1);  // [J] of 66
}

TEST_CASE("A body that flies and turns by radians in a step keeps its energy", "[unit][contact]") {
  const Scene scene = spinning_plate();
  for (const char* technique :
       {"impulse", "damped", "penalty", "faure", "analytic", "time_stepping", "basic", "optimised",
        "timewarp_simple", "timewarp_safer", "timewarp_swept", "timewarp_full"}) {
    Simulation simulation(scene, technique);
    simulation.update_boxes();
    const double start = energy_of(simulation.world()).total();
    CAPTURE(technique);
    for (int k = 0; k < 60; ++k) {
      REQUIRE(simulation.step(0.1085).status == StepStatus::done);
      CHECK(energy_of(simulation.world()).total() < 1.06 * start);
      CHECK(simulation.world().time() == Approx(0.1085 * (k + 1)));
      CHECK(simulation.world().steps() == k + 1);
    }
  }
}
