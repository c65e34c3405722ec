/// \file
/// \brief Penalty forces: closed forms of a mass on a spring and a damper, defaults, refusals and weaknesses.
#include "tumble/previous_work/penalty.hpp"

#include "tumble/record/run.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/changed_world.hpp"
#include "support/test.hpp"

namespace {

// A cube of 2 kg at a height above the ground [m], with a speed along y [m/s].
World cube_above(double height, double speed, double gravity, double restitution = 0.0) {
  World world;
  world.gravity_w = Vec3(0.0, -gravity, 0.0);
  world.add_ground();
  BodyProperties cube = box_properties(Vec3::Ones(), 2.0);
  cube.restitution = restitution;
  world.add(cube, Vec3(0.0, 0.5 + height, 0.0), Quat::Identity(), Vec3(0.0, speed, 0.0));
  return world;
}

double height_of(const World& world) { return world.states()[1].position_w.y() - 0.5; }
double speed_of(const World& world) { return 0.5 * world.states()[1].linear_momentum_w.y(); }

// A bounce at 1 m/s on springs of 2000 N/m without gravity: its restitution, and how long it touched [s].
struct Bounced {
  double restitution = 0.0;
  double touched = 0.0;
};

Bounced bounced(const PenaltyOptions& options, double restitution = 0.0) {
  World world = cube_above(1e-5, -1.0, 0.0, restitution);
  Penalty technique(options);
  Bounced bounce;
  for (int k = 0; k < 4000; ++k) {
    technique.step(world, 1e-4);
    if (!technique.contacts().empty()) bounce.touched += 1e-4;
  }
  bounce.restitution = speed_of(world);
  return bounce;
}

// How far a cube at rest on its springs swings after 300 steps, over how far it did at first.
double swing_growth(PenaltyScheme scheme, double damping, double share_of_limit) {
  constexpr double kStiffness = 2000.0;
  const double sunk = 2.0 * kGravity / kStiffness;
  const double push = 1e-4 * sunk;
  World world = cube_above(-sunk - push, 0.0, kGravity);
  Penalty technique({.stiffness = kStiffness,
                     .damping = damping,
                     .substeps = 1,
                     .scheme = scheme,
                     .pull = true,
                     .unstable = true});
  const double h = share_of_limit * stable_step(scheme, {std::sqrt(kStiffness / 2.0), damping});
  double largest = 0.0;
  for (int k = 0; k < 300; ++k) {
    technique.step(world, h);
    if (k >= 290) largest = std::max(largest, std::abs(height_of(world) + sunk));
  }
  return largest / push;
}

}  // namespace

TEST_CASE("A cube on springs sinks by m g / k", "[exact][penalty]") {
  for (const double stiffness : {500.0, 2000.0}) {
    World world = cube_above(0.0, 0.0, kGravity);
    Penalty technique({.stiffness = stiffness, .damping = 1.0});
    run(world, technique, 5.0);
    CHECK(-height_of(world) == near(2.0 * kGravity / stiffness, 1e-9));  // [m]
    REQUIRE(technique.contacts().size() == 4);
    for (const ContactRecord& contact : technique.contacts())
      CHECK(contact.push_w.y() == near(0.5 * kGravity, 1e-7));  // [N] a quarter of 2 kg
  }
}

TEST_CASE("A bounce without damping takes pi sqrt(m / k) and keeps its speed", "[exact][penalty]") {
  const Bounced bounce = bounced({.stiffness = 2000.0, .damping = 0.0, .substeps = 1});
  CHECK(bounce.touched == near(std::numbers::pi * std::sqrt(2.0 / 2000.0), 2.1e-4));  // [s]
  CHECK(bounce.restitution == near(1.0, 1e-4));
}

TEST_CASE("A ball on a spring and a damper bounces by the closed forms of both laws",
          "[exact][penalty]") {
  for (const double zeta : {0.05, 0.2, 0.5, 0.8}) {
    INFO("damping " << zeta);
    const double root = std::sqrt(1.0 - zeta * zeta);
    const double pulled = std::exp(-std::numbers::pi * zeta / root);
    const double pushed = std::exp(-2.0 * zeta * std::acos(zeta) / root);
    CHECK(penalty_restitution(zeta, true) == near(pulled, 1e-14));
    CHECK(penalty_restitution(zeta, false) == near(pushed, 1e-14));
    PenaltyOptions options{.stiffness = 2000.0, .damping = zeta, .substeps = 1};
    CHECK(bounced(options).restitution == near(pushed, 0.01 * pushed));  // measured: 0.003
    options.pull = true;
    CHECK(bounced(options).restitution == near(pulled, 0.02 * pulled));  // measured: 0.013
  }
  // Above critical damping, with arcosh; the two meet at e^-2.
  CHECK(penalty_restitution(1.0, false) == near(std::exp(-2.0), 1e-15));
  CHECK(penalty_restitution(2.0, false) ==
        near(std::exp(-4.0 * std::acosh(2.0) / std::sqrt(3.0)), 1e-15));
  CHECK(penalty_restitution(1.0, true) == 0.0);
}

TEST_CASE("Damping is the inverse of restitution", "[exact][penalty]") {
  for (const bool pull : {false, true})
    for (const double e : {0.2, 0.5, 0.9, 0.999}) {
      INFO(e << (pull ? ", pulled" : ""));
      CHECK(penalty_restitution(penalty_damping_for(e, pull), pull) == near(e, 1e-12));
    }
  CHECK(penalty_damping_for(1.0, false) == 0.0);
  CHECK(penalty_damping_for(0.0, false) == 1.0);
  CHECK_THROWS_WITH(penalty_damping_for(1.5, false), Contains("restitution"));
  CHECK_THROWS_WITH(penalty_restitution(-0.1, false), Contains("damping"));
  CHECK_THROWS_WITH(stable_step(PenaltyScheme::semi_implicit, {0.0, 1.0}), Contains("frequency"));
}

TEST_CASE("Swings on springs decay below the stable step and grow above it", "[exact][penalty]") {
  CHECK(stable_step(PenaltyScheme::semi_implicit, {10.0, 0.0}) == 0.2);  // 2/ω
  CHECK(stable_step(PenaltyScheme::explicit_euler, {10.0, 0.0}) == 0.0);
  CHECK(stable_step(PenaltyScheme::explicit_euler, {10.0, 0.5}) == 0.1);  // 2ζ/ω
  for (const PenaltyScheme scheme : {PenaltyScheme::semi_implicit, PenaltyScheme::explicit_euler})
    for (const double zeta : {0.1, 0.5, 1.5}) {
      INFO((scheme == PenaltyScheme::semi_implicit ? "semi-implicit, " : "explicit, ") << zeta);
      CHECK(swing_growth(scheme, zeta, 0.97) < 0.9);
      CHECK(swing_growth(scheme, zeta, 1.03) > 1.1);
    }
}

TEST_CASE("Penalty forces say which restitution they cannot give", "[unit][penalty]") {
  const std::string none = "a restitution of 0: contacts keep 0.14 of the approach";
  CHECK(Penalty().ignores(cube_above(1.0, 0.0, 9.81)) == std::vector<std::string>{none});
  CHECK(Penalty().ignores(cube_above(1.0, 0.0, 9.81, 0.5)).empty());
  CHECK(Penalty({.pull = true}).ignores(cube_above(1.0, 0.0, 9.81)).empty());
  CHECK(Penalty({.damping = 0.0}).ignores(cube_above(1.0, 0.0, 9.81, 0.5)) ==
        std::vector<std::string>{"a restitution of 0.5: contacts keep 1 of the approach"});
}

TEST_CASE("On their default springs boxes bounce with their restitution", "[exact][penalty]") {
  for (const double e : {0.2, 0.5, 0.9}) {
    INFO(e);
    CHECK(bounced({}, e).restitution == near(e, 0.035));  // measured: 0.031, four substeps a swing
  }
}

TEST_CASE("Springs too stiff for the step are refused with the step that is not",
          "[unit][penalty]") {
  World world = cube_above(0.0, 0.0, kGravity);
  const std::string before = world.hash().text();
  // ω = 1000/s and ζ = 1: h < 2 (√2 - 1)/ω
  Penalty stiff({.stiffness = 2e6, .damping = 1.0});
  CHECK_THROWS_WITH(stiff.step(world, kFrame),
                    "tumble: stiffness = 2e+06 N/m under box1 of 2 kg: substeps of 0.002083 s gain "
                    "energy: expected below 0.0008284 s, as with substeps = 21 or more");
  CHECK(world.hash().text() == before);
  CHECK_THROWS_AS(Penalty({.stiffness = 2e6, .damping = 1.0, .substeps = 20}).step(world, kFrame),
                  std::invalid_argument);
  CHECK_NOTHROW(Penalty({.stiffness = 2e6, .damping = 1.0, .substeps = 21}).step(world, kFrame));
  CHECK_NOTHROW(Penalty({.stiffness = 2e6, .unstable = true}).step(world, kFrame));
  World elastic = cube_above(0.0, 0.0, kGravity, 1.0);
  CHECK_THROWS_WITH(Penalty({.scheme = PenaltyScheme::explicit_euler}).step(elastic, kFrame),
                    Contains("gains energy at any step"));
  CHECK_THROWS_AS(Penalty({.stiffness = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(Penalty({.damping = -2.0}), std::invalid_argument);
  CHECK_THROWS_WITH(Penalty({.substeps = 0}), "tumble: substeps = 0: expected 1 or more");
}

TEST_CASE("Default springs throw no box out of a pile, with either scheme", "[unit][penalty]") {
  for (const PenaltyScheme scheme : {PenaltyScheme::semi_implicit, PenaltyScheme::explicit_euler})
    for (const Settings& settings :
         {Settings{{"rows", "4"}, {"spacing", "1.05"}}, Settings{{"rows", "3"}}}) {
      World world = world_of("pyramid", settings);
      Penalty technique({.scheme = scheme});
      const Course course = run(world, technique, 3.0);
      INFO("fastest " << course.fastest << " m/s, moved " << course.moved << " m");
      CHECK(course.moved < 0.1);    // [m] measured: 0.075
      CHECK(course.fastest < 0.7);  // [m/s] measured: 0.56, while it sinks in
      CHECK(course.not_finite == 0);
    }
}

TEST_CASE("Without gravity springs give back nothing that is not booked as such",
          "[exact][penalty]") {
  World world = world_of("two_boxes");
  const double energy = energy_of(world).kinetic;
  Penalty technique;
  const Course course = run(world, technique, 1.0);
  CHECK(course.unbooked < 1e-12 * energy);  // [J] rounding
  CHECK(course.booked < 0.0);
}

TEST_CASE("Default springs do the same bits in other units", "[determinism][penalty]") {
  for (const char* scene : {"box_drop", "two_boxes", "table"}) {
    INFO(scene);
    CHECK(differ_in_other_units<Penalty>(world_of(scene)) == 0);
  }
}

TEST_CASE("Smoothed friction stops a slide and creeps on a slope, half as fast with half the step",
          "[unit][penalty]") {
  World slide = world_of("slide");
  const double from = slide.states()[1].position_w.x();
  const double speed = velocity(slide.bodies()[1], slide.states()[1]).x();
  const double friction = std::sqrt(slide.bodies()[0].friction * slide.bodies()[1].friction);
  Penalty technique;
  run(slide, technique, 3.0);
  const double way = speed * speed / (2.0 * friction * kGravity);  // [m] Coulomb's
  CHECK(slide.states()[1].position_w.x() - from == near(way, 0.03 * way));

  const auto creep = [](int substeps) {
    World world = world_of("slope", {{"angle", "10"}});
    Penalty springs({.stiffness = 2000.0, .substeps = substeps});
    run(world, springs, 3.0);
    return fastest_of(world);  // [m/s]
  };
  const double coarse = creep(8);
  CHECK(coarse > 1e-3);  // friction should hold it
  CHECK(creep(16) == near(0.5 * coarse, 0.02 * coarse));
}

TEST_CASE("A cube that is shot through a thin plate is reported", "[unit][penalty]") {
  Scene scene;
  SceneBox plate{.name = "plate", .size = Vec3(2.0, 0.02, 2.0), .fixed = true};
  SceneBox cube{.name = "cube",
                .size = Vec3::Constant(0.2),
                .mass = 1.0,
                .position_w = Vec3(0.0, 0.5, 0.0),
                .velocity_w = Vec3(0.0, -200.0, 0.0)};
  scene.boxes = {plate, cube};
  Penalty technique;
  const RunResult result = run_scene(scene, technique, {.duration = 0.1}, {});
  CHECK(result.worst == StepStatus::passed_through);
  REQUIRE(result.findings.size() == 1);
  CHECK_THAT(result.findings[0], Contains("went through"));
}
