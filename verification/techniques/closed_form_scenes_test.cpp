/// \file
/// \brief Scenes of a few boxes whose motion is known in closed form, with the techniques that promise to solve contacts.
#include "tumble/record/run.hpp"

#include "support/test.hpp"

namespace {

constexpr std::array<std::string_view, 2> kBoth = {"contact_damped", "time_stepping"};

SceneBox box(const std::string& name, const Vec3& size, const Vec3& position_w, double friction) {
  return {.name = name, .size = size, .position_w = position_w, .friction = friction};
}

Quat about_z(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

// The world at the end of a run that no check complains about.
World after(const Scene& scene, std::string_view technique, double duration, double dt) {
  Simulation simulation(scene, technique);
  const RunResult result = run_simulation(simulation, {.dt = dt, .duration = duration}, {});
  CAPTURE(technique, result.findings);
  CHECK(result.worst == StepStatus::done);
  return simulation.world();
}

}  // namespace

// On edges m falls as far as both blocks of M give way: a = g m/(m + 2 M), here a third of g.
TEST_CASE("A cube on its edge drives two blocks apart by the closed form", "[exact][technique]") {
  Scene scene{.ground = SceneGround{}};
  const double half_diagonal = std::sqrt(0.5);
  scene.boxes = {box("left", Vec3::Ones(), Vec3(-0.7, 0.5, 0.0), 0.0),
                 box("right", Vec3::Ones(), Vec3(0.7, 0.5, 0.0), 0.0),
                 box("wedge", Vec3::Ones(), Vec3(0.0, 0.8 + half_diagonal, 0.0), 0.0)};
  scene.boxes[2].orientation_wb = about_z(0.25 * std::numbers::pi);
  const double time = 0.2;
  const double way = 0.5 * kGravity / 3.0 * time * time;
  for (const std::string_view technique : kBoth) {
    CAPTURE(technique);
    const World world = after(scene, technique, time, 1.0 / 480.0);
    // The first step moves by its end velocity: g/3 dt t/2 more, 1 %.
    CHECK(world.body("right").position_w().x() - 0.7 == near(way, 0.02 * way));
    CHECK(0.8 + half_diagonal - world.body("wedge").position_w().y() == near(way, 0.02 * way));
  }
}

// On a slope of the angle of friction the speed and its part downhill add up to the same at all times: what is thrown
// across ends downhill with half its speed.
TEST_CASE("A plate that is thrown across a slope of its angle of friction ends with half its speed",
          "[exact][technique]") {
  const double slope = 20.0 * std::numbers::pi / 180.0;
  const double friction = std::tan(slope);
  const Vec3 up_w(-std::sin(slope), std::cos(slope), 0.0);
  Scene scene;
  scene.boxes = {box("slope", Vec3(400.0, 1.0, 400.0), -0.5 * up_w, friction),
                 box("plate", Vec3(1.0, 0.02, 1.0), 0.01 * up_w, friction)};
  for (SceneBox& any : scene.boxes) any.orientation_wb = about_z(slope);
  scene.boxes[0].fixed = true;
  scene.boxes[1].velocity_w = Vec3(0.0, 0.0, 4.0);
  const World world = after(scene, "contact_damped", 12.0, 1.0 / 60.0);
  const Vec3 downhill_w(-std::cos(slope), -std::sin(slope), 0.0);
  CHECK(world.body("plate").velocity_w().dot(downhill_w) == near(2.0, 0.02));
  CHECK(world.body("plate").velocity_w().z() == near(0.0, 0.02));
}

TEST_CASE("A box that slides easily pushes one that brakes, with the mean of both frictions",
          "[exact][technique]") {
  Scene scene{.ground = SceneGround{1.0, 0.0}};
  scene.boxes = {
      box("rear", Vec3(1.0, 0.2, 1.0), Vec3(0.0, 0.1, 0.0), 0.01),    // 0.1 with the ground
      box("front", Vec3(1.0, 0.2, 1.0), Vec3(1.0, 0.1, 0.0), 0.25)};  // 0.5
  for (SceneBox& any : scene.boxes) any.velocity_w = Vec3(3.0, 0.0, 0.0);
  const double way = 9.0 / (2.0 * 0.3 * kGravity);
  for (const std::string_view technique : kBoth) {
    CAPTURE(technique);
    const World world = after(scene, technique, 2.0, 1.0 / 60.0);
    // A step of 3 m/s · dt / 2 is 2.5 cm.
    CHECK(world.body("front").position_w().x() - 1.0 == near(way, 0.025));
    CHECK(world.body("front").position_w().x() - world.body("rear").position_w().x() ==
          near(1.0, 1e-3));
  }
}

// About the edge of the curb the cube keeps its angular momentum, and tips over if what is left lifts its centre above
// that edge.
TEST_CASE("A cube tips over a curb from the closed-form speed on", "[exact][technique]") {
  const double curb = 0.2;
  const double above = 0.5 - curb;  // [m] of the centre over the edge
  const double arm = std::hypot(0.5, above);
  const double inertia = 1.0 / 6.0 + arm * arm;
  const double threshold = std::sqrt(2.0 * kGravity * (arm - above) * inertia) / above;
  for (const std::string_view technique : kBoth) {
    for (const double share : {0.95, 1.06}) {
      CAPTURE(technique, share);
      Scene scene{.ground = SceneGround{0.0, 0.0}};
      scene.boxes = {box("curb", Vec3(1.0, 2.0 * curb, 4.0), Vec3(1.05, 0.0, 0.0), 1e3),
                     box("cube", Vec3::Ones(), Vec3(0.0, 0.5, 0.0), 1e3)};
      scene.boxes[0].fixed = true;
      scene.boxes[1].velocity_w = Vec3(share * threshold, 0.0, 0.0);
      const World world = after(scene, technique, 3.0, 1.0 / 240.0);
      CHECK((world.body("cube").position_w().x() > 0.6) == (share > 1.0));
    }
  }
}

// J = (1 + e) v / (1/M + r²/I) at the distance r from the centre.
TEST_CASE("A rod that lands with one end on an edge turns by the closed form",
          "[exact][technique]") {
  const Vec3 size(4.0, 0.1, 0.1);
  const double arm = 1.9;
  const double inertia = (size.x() * size.x() + size.y() * size.y()) / 12.0;
  for (const double restitution : {0.0, 1.0}) {
    Scene scene{.gravity_w = Vec3::Zero()};
    scene.boxes = {box("edge", Vec3::Constant(0.2), Vec3(arm, -0.07 - std::sqrt(0.02), 0.0), 0.0),
                   box("rod", size, Vec3::Zero(), 0.0)};
    scene.boxes[0].orientation_wb = about_z(0.25 * std::numbers::pi);
    scene.boxes[0].fixed = true;
    scene.boxes[1].velocity_w = Vec3(0.0, -2.0, 0.0);
    for (SceneBox& any : scene.boxes) any.restitution = restitution;
    const double impulse = (1.0 + restitution) * 2.0 / (1.0 + arm * arm / inertia);
    for (const std::string_view technique : kBoth) {
      CAPTURE(technique, restitution);
      const World world = after(scene, technique, 0.03, 1.0 / 960.0);
      CHECK(world.body("rod").velocity_w().y() == near(impulse - 2.0, 0.01));
      CHECK(world.body("rod").angular_velocity_w().z() == near(arm * impulse / inertia, 0.01));
    }
  }
}
