/// \file
/// \brief Bounces: no impact adds energy, bodies that touch part by Newton's law at all points at once, and elastic ones keep their energy.

#include "tumble/record/metrics.hpp"

#include "fuzz/random_world.hpp"
#include "support/shared_data.hpp"
#include "support/test.hpp"

namespace {

SceneBox cube(const std::string& name, double edge, double mass, const Vec3& position_w,
              const Vec3& velocity_w, double restitution) {
  return {.name = name,
          .size = Vec3::Constant(edge),
          .mass = mass,
          .position_w = position_w,
          .velocity_w = velocity_w,
          .friction = 0.0,
          .restitution = restitution};
}

double speed_up(const Simulation& simulation, const std::string& name) {
  return simulation.body(name).velocity_w().y();
}

// The largest rise of the energy in a step that is not the repair of overlap, over the kinetic energy plus the sum of
// m g L, and the largest change of momentum without ground and gravity, over the sum of |m v|.
struct Rise {
  double energy = 0.0, unbooked = 0.0, momentum = 0.0;
};

Rise largest_rise(std::string_view technique, std::uint64_t seed) {
  fuzz::WorldRange range;
  range.mass_ratio = 1e4;
  fuzz::RandomWorld random = fuzz::random_world(seed, range);
  Random chance(seed);
  if (random.scene.ground) random.scene.ground->restitution = chance.unit();
  for (SceneBox& box : random.scene.boxes) box.restitution = chance.unit();
  Simulation simulation(random.scene, technique);
  simulation.update_boxes();
  const World& world = simulation.world();
  const bool closed = !random.scene.ground && random.scene.gravity_w.isZero();
  const Vec3 momentum_w = linear_momentum(world);
  const double scale = energy_of(world).kinetic + lifting_energy(world);
  double speeds = 0.0;
  for (const SceneBox& box : random.scene.boxes) speeds += box.mass * box.velocity_w.norm();
  Rise most;
  if (!(scale > 0.0)) return most;
  for (int k = 0; k < 60; ++k) {
    const double before = energy_of(world).total();
    const StepReport report = simulation.step(random.dt);
    if (report.status != StepStatus::done) break;
    const double rise = energy_of(world).total() - before;
    most.energy = std::max(most.energy, (rise - report.energy.repair) / scale);
    most.unbooked = std::max(most.unbooked, (rise - report.energy.total()) / scale);
    if (closed && speeds > 0.0)
      most.momentum =
          std::max(most.momentum, (linear_momentum(world) - momentum_w).norm() / speeds);
  }
  return most;
}

// Rounding of bounces that follow each other, up to twenty in a step, adds up to a little over 1e-12 of the momentum.
void check_random_worlds(std::string_view technique, std::uint64_t first, std::uint64_t count,
                         int known = 0, double momentum = 1e-12) {
  int gained = 0, unbooked = 0, lost = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Rise most = largest_rise(technique, seed);
    gained += most.energy > 1e-3 ? 1 : 0;
    unbooked += most.unbooked > 1e-3 ? 1 : 0;
    lost += most.momentum > momentum ? 1 : 0;
    if (most.energy > 1e-3 || most.unbooked > 1e-3 || most.momentum > momentum)
      UNSCOPED_INFO(technique << ", seed " << seed << ": energy " << most.energy << ", unbooked "
                              << most.unbooked << ", momentum " << most.momentum);
  }
  CHECK(gained <= known);
  CHECK(unbooked == 0);
  CHECK(lost == 0);
}

// A cube comes at 1 m/s into four with gaps of 1 cm: without loss the last one leaves with 0.5 J, and the others rest.
Scene cradle(bool floor) {
  Scene scene;
  if (floor) scene.ground.emplace(SceneGround{0.0, 1.0});
  if (!floor) scene.gravity_w.setZero();
  for (int k = 0; k < 5; ++k) {
    SceneBox cube;
    cube.size.setConstant(0.2);
    cube.friction = 0.0;
    cube.restitution = 1.0;
    cube.position_w = Vec3(k == 0 ? -0.5 : 0.21 * (k - 1), 0.1, 0.0);
    if (k == 0) cube.velocity_w.x() = 1.0;
    scene.boxes.push_back(cube);
  }
  return scene;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> list) {
  return std::ranges::find(list, name) != list.end();
}

// As the lines of `tumble techniques` say: several impacts of a step are one; nothing bounces; or bodies are damped.
bool may_lose(std::string_view name, bool floor) {
  if (is_one_of(name, {"time_stepping", "faure", "damped", "relaxation", "settling"})) return true;
  return floor && (name.substr(0, 8) == "timewarp" || name == "glued");
}

}  // namespace

// --- energy -------------------------------------------------------------------------------------

TEST_CASE("A box that bounces between the ground and a heavier one gains no energy",
          "[unit][contact_damped][time_stepping][analytic_lcp]") {
  const auto cases = shared_data("../cases");
  if (!cases) return;
  const Scene scene = read_scene(*cases / "robustness/impact_adds_energy.toml");
  for (const char* technique : {"contact_damped", "time_stepping"}) {
    for (const int rate : {60, 120, 240}) {
      CAPTURE(technique, rate);
      Simulation simulation(scene, technique);
      simulation.update_boxes();
      const Energy start = energy_of(simulation.world());
      for (int k = 0; k < 2 * rate; ++k) {
        const double before = energy_of(simulation.world()).total();
        const StepReport report = simulation.step(1.0 / rate);
        REQUIRE(report.status == StepStatus::done);
        const double now = energy_of(simulation.world()).total();
        // Of 99 J of motion. It was 19 J with contact_damped, 28 J with time_stepping.
        CHECK(now - before < 1e-6 * start.kinetic + std::max(report.energy.repair, 0.0));
        CHECK(now - start.total() < 1e-6 * start.kinetic);
        CHECK(std::abs(now - before - report.energy.total()) < 1e-9);
      }
    }
  }
}

TEST_CASE("An elastic cube rises as high as it was, bounce after bounce",
          "[exact][contact_damped][time_stepping][analytic_lcp]") {
  Scene scene{.ground = SceneGround{0.0, 1.0},
              .boxes = {cube("cube", 1.0, 1.0, Vec3(0.0, 1.7, 0.0), Vec3::Zero(), 1.0)}};
  for (const char* technique : {"contact_damped", "time_stepping"}) {
    CAPTURE(technique);
    Simulation simulation(scene, technique);
    const double start = energy_of(simulation.world()).total();
    for (int k = 0; k < 600; ++k) {
      const StepReport report = simulation.step(kFrame);
      CHECK(report.energy.repair == 0.0);
      CHECK(energy_of(simulation.world()).total() < start + 1e-9);
    }
    // [J] Of 16.7: m (g h)²/2 is lost in each step near the ground.
    CHECK(energy_of(simulation.world()).total() > start - 1.0);
  }
}

TEST_CASE("No impact of random worlds adds energy, whatever the masses", "[unit][fuzz]") {
  check_random_worlds("contact_damped", 1, 150);
  check_random_worlds("time_stepping", 1, 30);
}

TEST_CASE("No impact of thousands of random worlds adds energy", "[.long][unit][fuzz]") {
  // Known to fail in up to one in a hundred: friction of impulses without restitution that are not quite solved.
  check_random_worlds("contact_damped", 1, 4000, 40, 2e-12);
  check_random_worlds("time_stepping", 1, 1000);
}

// --- the rule -----------------------------------------------------------------------------------

TEST_CASE("A box on a larger one, dropped together, bounces with it by Newton's law",
          "[exact][contact_damped][time_stepping][analytic_lcp]") {
  // The two do not approach each other, so they part no more: both leave with e times the speed on arrival. One
  // impact after the other would send the upper one up three times as fast.
  for (const char* technique : {"contact_damped", "time_stepping"}) {
    for (const double ratio : {0.1, 1.0, 10.0}) {
      CAPTURE(technique, ratio);
      Scene scene{.ground = SceneGround{0.0, 0.5}};
      const Vec3 down_w(0.0, -3.0, 0.0);
      scene.boxes = {cube("lower", 1.0, 1.0, Vec3(0.0, 0.52, 0.0), down_w, 0.5),
                     cube("upper", 0.5, ratio, Vec3(0.0, 1.27, 0.0), down_w, 0.5)};
      Simulation simulation(scene, technique);
      REQUIRE(simulation.step(kFrame).status == StepStatus::done);
      // [m/s] The approach is that of the fall through the gap, or that of the start with what lifts both in the step.
      const double lifted = kGravity * kFrame;
      const double expected = std::string(technique) == "contact_damped"
                                  ? 0.5 * std::sqrt(9.0 + 2.0 * kGravity * 0.02)
                                  : std::hypot(1.5, lifted) - lifted;
      CHECK(speed_up(simulation, "lower") == near(expected, 1e-3));
      CHECK(speed_up(simulation, "upper") == near(speed_up(simulation, "lower"), 1e-5));
    }
  }
}

TEST_CASE("Elastic cubes in a row that touch part by Newton's law at all points at once",
          "[exact][contact_damped][time_stepping][analytic_lcp]") {
  const auto cases = shared_data("../cases");
  if (!cases) return;
  const Scene scene = read_scene(*cases / "08b-cradle-touching.toml");
  for (const char* technique : {"contact_damped", "time_stepping"}) {
    CAPTURE(technique);
    Simulation simulation(scene, technique);
    simulation.run_for(1.5);
    // The first pair parts at 1 m/s, the others stay together: v + 1 = V and v + 4 V = 1.
    CHECK(simulation.body("b0").velocity_w().x() == near(-0.6, 1e-5));
    for (const char* name : {"b1", "b2", "b3", "b4"})
      CHECK(simulation.body(name).velocity_w().x() == near(0.4, 1e-5));
  }
}

TEST_CASE("A lever that is struck at one end lifts what touches the other one by Newton's law",
          "[exact][contact_damped][time_stepping][analytic_lcp]") {
  // A bar of 3 kg and 2 m in no gravity. The striker has an edge down and hits its right end at 2 m/s, the load has one
  // down as well and lies on the left end. With p and q the impulses that leave the bar and V, w its motion,
  //   3 V = -p - q,  I w = a (q - p),  p/m1 - 2 - (V + w a) = 2 e,  q/m2 - (V - w a) = 0.
  const double m1 = 2.0, m2 = 0.5, bar = 3.0, a = 0.9, e = 0.5, v = 2.0;
  const double inertia = bar * (2.0 * 2.0 + 0.1 * 0.1) / 12.0;
  const double own = 1.0 / bar + a * a / inertia, across = 1.0 / bar - a * a / inertia;
  const double p = (1.0 + e) * v / (1.0 / m1 + own - across * across / (1.0 / m2 + own));
  const double q = -across * p / (1.0 / m2 + own);
  REQUIRE(q > 0.0);
  const Quat edge_down = rotation_from_vector(Vec3(0.0, 0.0, std::atan(1.0)));
  Scene scene{.gravity_w = Vec3::Zero()};
  const double reach = 0.05 + 0.2 * std::sqrt(0.5);
  SceneBox plank = cube("bar", 1.0, bar, Vec3::Zero(), Vec3::Zero(), e);
  plank.size = Vec3(2.0, 0.1, 0.4);
  SceneBox striker = cube("striker", 0.2, m1, Vec3(a, reach + 0.01, 0.0), Vec3(0.0, -v, 0.0), e);
  SceneBox load = cube("load", 0.2, m2, Vec3(-a, reach, 0.0), Vec3::Zero(), e);
  striker.orientation_wb = load.orientation_wb = edge_down;
  scene.boxes = {plank, striker, load};
  for (const char* technique : {"contact_damped", "time_stepping"}) {
    CAPTURE(technique);
    Simulation simulation(scene, technique);
    REQUIRE(simulation.step(kFrame).status == StepStatus::done);
    CHECK(speed_up(simulation, "striker") == near(p / m1 - v, 1e-5));
    CHECK(speed_up(simulation, "load") == near(q / m2, 1e-5));
    CHECK(speed_up(simulation, "bar") == near(-(p + q) / bar, 1e-5));
  }
}

TEST_CASE("Elastic bodies keep their energy, or the technique says that they do not and books it",
          "[unit][technique]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    for (const bool floor : {false, true}) {
      INFO(recipe.name << (floor ? " on a floor" : ""));
      Simulation run(cradle(floor), recipe.name);
      MetricsMeter meter;
      run.observe(meter);
      CHECK(run.run_for(1.2) <= StepStatus::event_cap);
      const Metrics& m = meter.metrics();
      CHECK(std::abs(m.energy_error) < 0.05);  // J, of 0.5 J; springs are not at rest
      const double start = 0.5 + (floor ? 5 * 9.81 * 0.1 : 0.0);  // [J]
      const double lost = start - m.kinetic - m.potential;
      INFO(lost << " J are lost");
      CHECK((lost > 0.06) ==
            may_lose(recipe.name, floor));  // 0.068 or more; springs sink in: 0.048
    }
  }
}
