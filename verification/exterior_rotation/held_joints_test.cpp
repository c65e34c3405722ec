/// \file
/// \brief Ball joints, hinges and fixed joints of a scene under `glued`: closed forms.
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

// Two boxes in flight without gravity, joined where they touch.
Simulation flying_pair(JointKind kind) {
  Scene scene{.gravity_w = Vec3::Zero()};
  SceneBox a{.name = "a",
             .size = Vec3(1.0, 0.4, 0.6),
             .mass = 2.0,
             .angular_velocity_w = Vec3(0.7, 2.0, -1.1)};
  SceneBox b = a;
  b.name = "b";
  b.size = Vec3(0.5, 0.8, 0.3);
  b.mass = 1.0;
  b.position_w = Vec3(0.75, 0.0, 0.0);
  b.orientation_wb = rotation_from_vector(Vec3(0.3, 0.0, 0.0));
  const Vec3 anchor_w(0.5, 0.0, 0.0), axis_w(0.6, 0.0, 0.8);
  if (kind == JointKind::hinge) b.angular_velocity_w += 3.0 * axis_w;
  b.velocity_w =
      a.angular_velocity_w.cross(anchor_w) + b.angular_velocity_w.cross(b.position_w - anchor_w);
  scene.boxes = {a, b};
  scene.joints = {
      {"", kind, "a", "b", anchor_w, kind == JointKind::hinge ? axis_w : Vec3(Vec3::Zero())}};
  return Simulation(scene, "glued");
}

}  // namespace

TEST_CASE("A link on a hinge swings with the period of a physical pendulum", "[exact][joints]") {
  constexpr double amplitude = 0.02;  // [rad]
  constexpr double length = 0.5, thick = 0.1;
  Simulation run(built("pendulum", {{"count", "1"}, {"angle", "0.02"}}), "glued");
  constexpr double dt = 1.0 / 240.0;
  // When the spin changes its sign: half a period each.
  std::vector<double> turns;
  double before = 0.0;
  while (turns.size() < 21) {
    run.step(dt);
    const double now = run.body("link1").angular_velocity_w().z();
    if (before != 0.0 && (now > 0.0) != (before > 0.0))
      turns.push_back(run.world().time() - dt * now / (now - before));
    before = now;
  }
  const double inertia = (length * length + thick * thick) / 12.0 + 0.25 * length * length;
  const double period = 2.0 * std::numbers::pi * std::sqrt(inertia / (kGravity * 0.5 * length)) *
                        (1.0 + amplitude * amplitude / 16.0);
  // Measured: 4e-8, mostly of the sign change by a straight line.
  CHECK((turns.back() - turns.front()) / 10.0 == near(period).epsilon(1e-6));
}

TEST_CASE("A double pendulum keeps its energy to the fourth order of the step", "[exact][joints]") {
  const auto error = [](int rate) {
    Simulation run(built("pendulum", {}), "glued");
    const double start = energy_of(run.world()).total();
    double most = 0.0;
    for (int k = 0; k < 2 * rate; ++k) {
      run.step(1.0 / rate);
      most = std::max(most, std::abs(energy_of(run.world()).total() - start));
    }
    return most / (kGravity * 0.5);  // over m g L
  };
  const double coarse = error(120), fine = error(240);
  CHECK(coarse < 1e-3);  // measured: 5.8e-4, where the links fold
  CHECK(fine < coarse / 10.0);
}

TEST_CASE("A hinge leaves one of three turns free", "[exact][joints]") {
  Simulation run = flying_pair(JointKind::hinge);
  const BodyJoint joint = run.world().joints()[0];
  const auto across = [&] {
    const Vec3 first_w = run.body("a").orientation_wb() * joint.axes_b[0];
    return first_w.cross(run.body("b").orientation_wb() * joint.axes_b[1]).norm();
  };
  const auto along = [&] {
    const Vec3 first_w = run.body("a").orientation_wb() * joint.axes_b[0];
    return (run.body("b").angular_velocity_w() - run.body("a").angular_velocity_w()).dot(first_w);
  };
  double most = 0.0;
  for (int k = 0; k < 240; ++k) {
    run.step(1.0 / 120.0);
    most = std::max(most, across());
  }
  CHECK(most < 1e-12);  // [rad] measured: 3e-15
  CHECK(std::abs(along()) > 0.5);
  CHECK(apart(run) < 1e-12);
}

TEST_CASE("A fixed joint makes one body of two", "[exact][joints]") {
  Simulation run = flying_pair(JointKind::fixed);
  const auto relative = [&] {
    return Quat(run.body("a").orientation_wb().conjugate() * run.body("b").orientation_wb());
  };
  const Quat start = relative();
  const auto spin = [&] {  // about the origin
    Vec3 sum_w = Vec3::Zero();
    for (const BodyState& s : run.world().states())
      sum_w += s.angular_momentum_w + s.position_w.cross(s.linear_momentum_w);
    return sum_w;
  };
  const Vec3 spin_w = spin();
  double most = 0.0;
  for (int k = 0; k < 240; ++k) {
    run.step(1.0 / 120.0);
    most = std::max(most, angle_between(start, relative()));
  }
  CHECK(most < 1e-7);  // [rad] the root of a rounding, as angles between quaternions are
  CHECK(apart(run) < 1e-12);
  CHECK((run.body("a").angular_velocity_w() - run.body("b").angular_velocity_w()).norm() < 1e-12);
  CHECK((spin() - spin_w).norm() < 1e-6 * spin_w.norm());
}

TEST_CASE("Anchors of a chain stay together to rounding", "[exact][joints]") {
  Simulation run(built("chain", {}), "glued");
  double most = 0.0;
  for (int k = 0; k < 180; ++k) {
    run.step();
    most = std::max(most, apart(run));
  }
  CHECK(most < 1e-11);  // [m]
}

TEST_CASE("Each joint of a chain that hangs carries the weight below it", "[exact][joints]") {
  Simulation run(built("chain", {{"count", "20"}, {"angle", "0"}}), "glued");
  run.step();
  const auto records = run.technique().contacts();
  REQUIRE(records.size() == 20);
  for (std::size_t k = 0; k < records.size(); ++k) {
    const double below = static_cast<double>(records.size() - k) * kGravity;
    CHECK((records[k].push_w - Vec3(0.0, below, 0.0)).norm() < 1e-9 * below);
    CHECK_FALSE(records[k].is_impulse);
  }
}

TEST_CASE("A bridge of planks in hinges is a loop that stays closed and keeps its energy",
          "[exact][joints]") {
  Scene scene = built("plank_bridge", {});
  scene.boxes.pop_back();  // without the load
  Simulation run(scene, "glued");
  const double start = energy_of(run.world()).total();
  double most = 0.0, gained = 0.0;
  for (int k = 0; k < 120; ++k) {
    run.step();
    most = std::max(most, apart(run));
    gained = std::max(gained, std::abs(energy_of(run.world()).total() - start));
  }
  CHECK(most < 1e-11);                                // [m]
  CHECK(gained < 1e-4 * 8.0 * 5.0 * kGravity * 0.5);  // [J] of eight planks, half a metre
}

TEST_CASE("Velocities that a joint forbids end in the first step", "[unit][joints]") {
  Scene scene = built("pendulum", {{"count", "1"}, {"angle", "0"}});
  scene.boxes[1].velocity_w = Vec3(0.0, 1.0, 2.0);
  Simulation run(scene, "glued");
  const StepReport report = run.step(1e-6);
  CHECK(run.body("link1").velocity_w().norm() < 1e-4);
  CHECK(report.energy.restitution == near(-2.5).epsilon(1e-4));
}
