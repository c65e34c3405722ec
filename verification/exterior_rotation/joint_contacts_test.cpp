/// \file
/// \brief Bodies in joints that meet others: `glued` with contacts=collide.
#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/record/overlap.hpp"
#include "tumble/record/run.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

const std::vector<std::string> kCollide = {"contacts=collide"};

SceneBox cube_at(const std::string& name, const Vec3& position_w, double mass = 1.0) {
  return {.name = name, .mass = mass, .position_w = position_w};
}

// What the ground carries, as impulses of the last step.
double on_ground(const Simulation& run) {
  double sum = 0.0;
  for (const ContactRecord& record : run.technique().contacts())
    if (record.is_impulse && record.first == *run.world().find("ground")) sum += record.push_w.y();
  return sum;
}

}  // namespace

TEST_CASE("A chain that lies on the ground presses on it with its weight", "[exact][joints]") {
  Scene scene = built("chain", {{"count", "5"}, {"angle", "0.3"}});
  scene.ground = SceneGround{};
  scene.boxes[0].position_w = Vec3(0.0, 50.0, 0.0);  // the hook, out of the way
  scene.joints.erase(scene.joints.begin());          // the chain falls
  Simulation run(scene, "glued", kCollide);
  double gap = 0.0;
  while (run.world().time() < 5.0) {
    run.step();
    gap = std::max(gap, apart(run));
  }
  CHECK(gap < 1e-10);  // [m]
  for (int k = 1; k <= 5; ++k)
    CHECK(run.body("link" + std::to_string(k)).velocity_w().norm() < 0.02);
  CHECK(on_ground(run) == near(5.0 * kGravity * kFrame).epsilon(0.02));
}

TEST_CASE("A box that hits a rod on a hinge gives it the spin of the closed form",
          "[exact][joints]") {
  for (const double restitution : {0.0, 0.5}) {
    Scene scene{.gravity_w = Vec3::Zero()};
    SceneBox rod = cube_at("rod", Vec3(0.0, -1.0, 0.0), 3.0);
    rod.size = Vec3(0.2, 2.0, 0.2);
    SceneBox post = cube_at("post", Vec3(0.0, 0.5, 0.0));
    post.size = Vec3(0.2, 0.9, 0.2);
    post.fixed = true;
    SceneBox hammer = cube_at("hammer", Vec3(-0.3001, -1.5, 0.0), 2.0);
    hammer.size = Vec3::Constant(0.4);
    hammer.velocity_w = Vec3(4.0, 0.0, 0.0);
    hammer.restitution = restitution;
    scene.boxes = {rod, post, hammer};
    for (SceneBox& box : scene.boxes) box.friction = 0.0;
    scene.joints = {{"", JointKind::hinge, "post", "rod", Vec3::Zero(), Vec3::UnitZ()}};
    Simulation run(scene, "glued", kCollide);
    for (int k = 0; k < 5; ++k) run.step(1e-5);
    // Inertia of the rod about its end; two corners of the hammer's face push, so it may turn about the hinge, too:
    // both turn at the same rate w after an inelastic impact. A single point would do with less.
    const double arm = 1.5, inertia = 3.0 * (4.0 + 0.04) / 12.0 + 3.0;
    const double spin = run.body("rod").angular_velocity_w().z();
    const double after = run.body("hammer").velocity_w().x();
    const double own = run.body("hammer").angular_velocity_w().z();
    const double own_inertia = 2.0 * 0.4 * 0.4 / 6.0;
    // Angular momentum about the hinge is kept; its force has no moment there.
    CHECK(inertia * spin + 2.0 * arm * after + own_inertia * own ==
          near(2.0 * arm * 4.0).epsilon(1e-6));
    // Faces that meet flat part at both ends with the restitution.
    for (const double y : {-1.3, -1.7})
      CHECK(-spin * y - (after - own * (y + arm)) == near(restitution * 4.0, 1e-3));
  }
}

TEST_CASE("A train in ball joints slides to a stop at the distance of friction",
          "[exact][joints]") {
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  for (int k = 0; k < 3; ++k) {
    SceneBox box = cube_at("car" + std::to_string(k + 1), Vec3(1.5 * k, 0.25, 0.0));
    box.size = Vec3(1.0, 0.5, 1.0);
    box.velocity_w = Vec3(3.0, 0.0, 0.0);
    scene.boxes.push_back(box);
    if (k > 0)
      scene.joints.push_back({"", JointKind::ball, "car" + std::to_string(k), box.name,
                              Vec3(1.5 * k - 0.75, 0.25, 0.0), Vec3::Zero()});
  }
  Simulation run(scene, "glued", kCollide);
  run.run_for(1.5);
  const double way = 9.0 / (2.0 * 0.5 * kGravity);
  CHECK(run.body("car1").position_w().x() == near(way).epsilon(0.02));
  CHECK(run.body("car3").velocity_w().norm() < 1e-3);
  CHECK(apart(run) < 1e-10);
}

TEST_CASE("The crane knocks bricks off the wall, and all its joints hold", "[unit][joints]") {
  const Scene scene = built("crane", {{"rows", "6"}, {"columns", "2"}});
  const auto technique = make_technique("glued", kCollide);
  Simulation run(scene, *technique);
  const RunResult result = run_simulation(run, {.duration = 1.5}, {});
  CHECK(result.findings.empty());
  CHECK(result.worst == StepStatus::done);
  CHECK(apart(run) < 1e-10);
  int moved = 0;
  for (const SceneBox& box : scene.boxes)
    if (box.name.starts_with("brick") &&
        (run.body(box.name).position_w() - box.position_w).norm() > 0.2)
      ++moved;
  CHECK(moved >= 3);
  CHECK((run.body("boom").position_w() - scene.boxes[1].position_w).norm() < 1e-9);
}

TEST_CASE("Options that do not go with contacts are refused by name", "[unit][joints]") {
  CHECK_THROWS_WITH(make_technique("glued", {"contacts=collide", "scheme=leapfrog"}),
                    Contains("contacts = collide") && Contains("rk4 or midpoint, not leapfrog"));
  CHECK_THROWS_WITH(make_technique("glued", {"contacts=collide", "joints=unilateral"}),
                    Contains("contacts = collide") && Contains("bilateral"));
  CHECK(make_technique("glued", kCollide)->ignores(World()).empty());
}

TEST_CASE("Every scheme holds the joints of a scene, and joints that open are others",
          "[exact][joints]") {
  const Scene chain = built("chain", {{"count", "4"}});
  for (const GluedScheme scheme : glued_schemes()) {
    INFO(name_of(scheme));
    Simulation run(chain, "glued", {"scheme=" + std::string(name_of(scheme))});
    double gap = 0.0;
    for (int k = 0; k < 60; ++k) {
      run.step();
      gap = std::max(gap, apart(run));
    }
    // One step of Newton's method leaves the square of what the first-order schemes open.
    CHECK(gap < 1e-4);
    CHECK(run.body("link4").velocity_w().norm() > 0.1);
  }
  Simulation opens(chain, "glued", {"joints=unilateral"});
  Simulation holds(chain, "glued");
  for (int k = 0; k < 60; ++k) {
    opens.step();
    holds.step();
  }
  CHECK(opens.world().hash().value() == holds.world().hash().value());
}

TEST_CASE("A copy of bodies in joints that collide goes on with the same bits",
          "[determinism][joints]") {
  World world = world_of("plank_bridge", {{"planks", "4"}});
  auto technique = make_technique("glued", kCollide);
  for (int k = 0; k < 40; ++k) technique->step(world, kFrame);
  World again = world;
  const auto copy = technique->clone();
  for (int k = 0; k < 20; ++k) {
    technique->step(world, kFrame);
    copy->step(again, kFrame);
  }
  CHECK(world.hash().value() == again.hash().value());
}

TEST_CASE("Joined boxes that fold into each other are no overlap and no finding",
          "[unit][joints]") {
  Simulation run(built("pendulum", {{"angle", "2.5"}}), "glued");
  CHECK(run_simulation(run, {.duration = 1.0}, {}).findings.empty());
  OverlapMeter meter;
  double folded = 0.0;
  for (int k = 0; k < 60; ++k) {
    run.step();
    folded = std::max(folded, meter.look(run.world().bodies(), run.world().states()));
    CHECK(meter.look(run.world()) == 0.0);
  }
  CHECK(folded > 0.01);  // [m]
}
