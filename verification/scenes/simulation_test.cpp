/// \file
/// \brief Simulations: steps, boxes thrown in and taken away, observers, bodies read by name.
#include "tumble/scenes/simulation.hpp"

#include "tumble/record/run.hpp"

#include "support/test.hpp"

namespace {

constexpr double kDt = 1.0 / 64.0;  // [s] times are sums of it without rounding

// Bodies fly straight and through each other, with no weight; a step does what a test wants besides.
class Puppet : public Cloned<Technique, Puppet> {
 public:
  std::function<StepReport(World&)> act = [](World&) { return StepReport{}; };

  [[nodiscard]] std::string_view name() const override { return "puppet"; }
  StepReport step(World& world, double dt) override {
    for (std::size_t i = 0; i < world.states().size(); ++i)
      world.states()[i].position_w += dt * velocity(world.bodies()[i], world.states()[i]);
    const StepReport report = act(world);
    world.finish_step(dt);
    return report;
  }
};

std::unique_ptr<Technique> made(std::string_view technique, bool sleeping = false) {
  return make_technique(technique, std::vector<std::string>(sleeping ? 1 : 0, "sleeping=on"));
}

SceneBox cube(const Vec3& position_w, const Vec3& velocity_w = Vec3::Zero(),
              const std::string& name = "") {
  return SceneBox{.name = name, .position_w = position_w, .velocity_w = velocity_w};
}

// Two towers of two cubes, and one that flies in at 0.25 s.
Scene towers() {
  Scene scene{.ground = SceneGround{}};
  scene.boxes = {cube(Vec3(0.0, 0.5, 0.0), Vec3::Zero(), "left"),
                 cube(Vec3(0.0, 1.5, 0.0), Vec3::Zero(), "on left"),
                 cube(Vec3(3.0, 0.5, 0.0), Vec3::Zero(), "right"),
                 cube(Vec3(3.0, 1.5, 0.0), Vec3::Zero(), "on right"),
                 cube(Vec3(-2.0, 1.0, 0.0), Vec3(8.0, 0.0, 0.0), "late")};
  scene.boxes.back().appears = 0.25;
  return checked(scene);
}

Scene weightless(std::vector<SceneBox> boxes) {
  return Scene{.gravity_w = Vec3::Zero(), .boxes = std::move(boxes)};
}

void step(Simulation& run, int count, double dt = kDt) {
  for (int k = 0; k < count; ++k) REQUIRE(run.step(dt).status < StepStatus::unsolved);
}

// The hash that `tumble run` comes to with the scene of a run as a file, in as many steps.
std::string repeated(const Simulation& run, std::string_view technique, double dt = kDt) {
  const Scene again = parse_scene(to_toml(run.scene()), "saved.toml");
  const RunResult result =
      run_scene(again, *made(technique),
                {.dt = dt, .duration = static_cast<double>(run.world().steps()) * dt}, {});
  CHECK(result.steps == run.world().steps());
  return result.state_hash;
}

std::string hash_of(const Simulation& run) { return run.world().hash().text(); }

bool is_there(const Simulation& run, const std::string& name) {
  return run.world().find(std::string_view(name)).has_value();
}

}  // namespace

TEST_CASE("What was thrown and taken away is repeated by a run of the scene that is left",
          "[determinism][scenes][live]") {
  const std::string technique =
      GENERATE(as<std::string>(), "contact_damped", "basic", "analytic", "time_stepping", "impulse",
               "damped", "timewarp_simple", "timewarp_full", "glued");
  INFO(technique);
  const auto stepper = made(technique);
  Simulation run(towers(), *stepper);

  // Before the first step.
  run.throw_in(cube(Vec3(0.25, 3.5, 0.0), Vec3(0.0, -2.0, 0.5)));
  run.take_away("on right");
  run.throw_in(cube(Vec3(6.0, 2.5, 0.0), Vec3(-4.0, 0.0, 0.0), "second"));
  run.take_away("second");
  CHECK_FALSE(is_there(run, "second"));
  step(run, 5);
  const std::string first = run.throw_in(cube(Vec3(0.0, 1.0, 4.0), Vec3(0.0, 0.0, -10.0)));
  run.take_away("on left");
  const std::string small = run.throw_in(SceneBox{
      .name = "", .size = Vec3::Constant(0.25), .mass = 0.125, .position_w = Vec3(1.5, 1.0, 0.0)});
  step(run, 11);
  // The late one is due now, and comes in before the one that is thrown now.
  REQUIRE(run.world().time() == 0.25);
  CHECK_FALSE(is_there(run, "late"));
  run.take_away("right");
  run.throw_in(cube(Vec3(3.0, 3.0, 0.0), Vec3(0.0, -5.0, 0.0)));
  REQUIRE(is_there(run, "late"));
  CHECK(*run.world().find("late") < run.world().ids().back());
  step(run, 1);
  run.take_away("late");
  step(run, 7);
  run.take_away(first);
  run.take_away(small);
  run.throw_in(cube(Vec3(-4.0, 0.75, 0.0), Vec3(9.0, 1.0, 0.0)));
  step(run, 12);

  CHECK(run.world().steps() == 36);
  CHECK(run.scene().boxes.size() == 9);  // five, less one, and five
  CHECK(repeated(run, technique) == hash_of(run));
  CHECK(to_toml(parse_scene(to_toml(run.scene()), "saved.toml")) == to_toml(run.scene()));
}

TEST_CASE("Sessions of throws at random are repeated by a run of the scene that is left",
          "[determinism][scenes][live]") {
  Random random(5);
  const double dt = 1.0 / 60.0;  // sums of it are rounded
  for (int session = 0; session < 20; ++session) {
    INFO("session " << session);
    const auto stepper = made("contact_damped");
    Simulation run(make_scene("projectile", {"rows=3", "appears=0.1"}), *stepper);
    int thrown = 0;
    int taken = 0;
    for (int k = 0; k < 30; ++k) {
      for (int deed = 0; deed < 2; ++deed) {
        const std::uint32_t dice = random.below(8);
        const auto any = [&] { return random.uniform(-3.0, 3.0); };
        try {
          if (dice == 0) {
            run.throw_in(cube(Vec3(any(), 4.0 + any(), any()), 3.0 * Vec3(any(), any(), any())));
            ++thrown;
          } else if (dice == 1) {
            const auto count = static_cast<std::uint32_t>(run.world().count());
            run.take_away(run.world().name(static_cast<int>(random.below(count))));
            ++taken;
          }
        } catch (const std::invalid_argument&) {
          // The ground, one that came in just now, or one that overlaps at the start.
        }
      }
      step(run, 1, dt);
    }
    CHECK(thrown > 0);
    CHECK(taken > 0);
    CHECK(repeated(run, "contact_damped", dt) == hash_of(run));
  }
}

TEST_CASE("A box cannot be taken away at the time at which it came in", "[unit][scenes][live]") {
  // Due between two steps; a run of a scene in which it goes at the end of the same step would never
  // see it, and give its id to the next one.
  Scene scene = towers();
  scene.boxes.back().appears = 0.24;
  const auto stepper = made("contact_damped");
  Simulation run(scene, *stepper);
  step(run, 16);
  const auto refused = [&](const std::string& name) {
    CHECK_THROWS_WITH(run.take_away(name), Contains(name + " came in at this very time"));
    CHECK(is_there(run, name));
  };
  CHECK_FALSE(is_there(run, "late"));
  refused("late");  // which has come in by now
  const std::string thrown = run.throw_in(cube(Vec3(0.0, 6.0, 0.0)));
  refused(thrown);
  refused("late");
  step(run, 1);
  run.take_away("late");
  run.take_away(thrown);
  CHECK_FALSE(is_there(run, "late"));
  step(run, 3);
  CHECK(repeated(run, "contact_damped") == hash_of(run));
}

TEST_CASE(
    "A box named by the world's own string is taken away, also when another one leaves just then",
    "[unit][scenes][live]") {
  // Removing a body moves the names of all that come after it.
  Puppet puppet;
  Scene scene = weightless(
      {cube(Vec3::Zero(), Vec3::Zero(), "a"), cube(Vec3(3.0, 0.0, 0.0), Vec3::Zero(), "b"),
       cube(Vec3(6.0, 0.0, 0.0), Vec3::Zero(), "c"), cube(Vec3(9.0, 0.0, 0.0), Vec3::Zero(), "d")});
  scene.boxes[0].disappears = kDt;
  Simulation run(scene, puppet);
  step(run, 1);
  run.take_away(run.world().name(1));
  CHECK_FALSE(is_there(run, "a"));
  CHECK_FALSE(is_there(run, "b"));
  CHECK(is_there(run, "c"));
  CHECK(is_there(run, "d"));
}

TEST_CASE("Before the first step a box that is thrown in or taken away changes the start",
          "[unit][scenes][live]") {
  Puppet puppet;
  Simulation run(towers(), puppet);
  MetricsMeter meter;
  run.observe(meter);
  const std::string before = to_toml(run.scene());
  CHECK_THROWS_WITH(run.throw_in(cube(Vec3(0.0, 1.0, 0.0))),
                    Contains("overlap") && Contains("move them apart"));
  CHECK_THROWS_WITH(run.take_away("late"), Contains("there is no box called late to take away"));
  CHECK_THROWS_WITH(run.take_away("ground"), Contains("there is no box called ground"));
  CHECK(to_toml(run.scene()) == before);

  SceneBox box = cube(Vec3(0.0, 4.0, 0.0));
  box.appears = 7.0;  // is not asked
  const std::string name = run.throw_in(box);
  CHECK(name == "box6");
  CHECK(is_there(run, name));
  CHECK(run.scene().boxes.back().appears == 0.0);
  CHECK(meter.metrics().potential == near(9.81 * (0.5 + 1.5 + 0.5 + 1.5 + 4.0)).epsilon(1e-15));
  run.take_away(name);
  CHECK(to_toml(run.scene()) == before);
  CHECK(hash_of(run) == build_world(towers()).hash().text());

  Simulation alone(weightless({cube(Vec3::Zero())}), puppet);
  CHECK_THROWS_WITH(alone.take_away("box1"), Contains("a scene needs at least one"));
  CHECK(is_there(alone, "box1"));
  CHECK(alone.scene().boxes.size() == 1);
}

TEST_CASE("A throw that is refused leaves the run as it was", "[unit][scenes][live]") {
  const std::vector<std::pair<SceneBox, std::string>> cases = {
      {cube(Vec3(0.0, kNan, 0.0)), "position_w = [0, nan, 0]: expected three finite numbers"},
      {cube(Vec3(0.0, 9.0, 0.0), Vec3(HUGE_VAL, 0.0, 0.0)), "velocity_w = [inf, 0, 0]"},
      {SceneBox{.name = "", .mass = -1.0, .position_w = Vec3(0.0, 9.0, 0.0)},
       "mass = -1: expected"},
      {SceneBox{.name = "", .mass = kNan, .position_w = Vec3(0.0, 9.0, 0.0)},
       "mass = nan: expected"},
      {SceneBox{.name = "", .size = Vec3(1.0, 0.0, 1.0), .position_w = Vec3(0.0, 9.0, 0.0)},
       "size.y = 0"},
      // Finite, but squares would not be.
      {SceneBox{.name = "",
                .mass = 1e10,
                .position_w = Vec3(0.0, 9.0, 0.0),
                .velocity_w = Vec3(0.0, 1e300, 0.0)},
       "velocity_w = [0, 1e+300, 0]: expected at most 299792458 m/s"},
      {SceneBox{.name = "",
                .mass = 1e10,
                .position_w = Vec3(0.0, 9.0, 0.0),
                .angular_velocity_w = Vec3(0.0, 1e300, 0.0)},
       "angular_velocity_w = [0, 1e+300, 0]: expected at most"},
      {cube(Vec3(0.0, 9.0, 0.0), Vec3::Zero(), "left"), "left: two boxes have this name"},
      {cube(Vec3(0.0, 9.0, 0.0), Vec3::Zero(), "ground"), "the ground has this name"},
      {SceneBox{.name = "", .position_w = Vec3(0.0, 9.0, 0.0), .disappears = 0.0},
       "expected later than 0"},
  };
  const int steps = GENERATE(0, 3);
  INFO("after " << steps << " steps");
  for (const auto& [box, message] : cases) {
    INFO(message);
    Puppet puppet;
    Puppet same;
    Simulation run(towers(), puppet);
    Simulation untouched(towers(), same);
    step(run, steps);
    step(untouched, steps);
    CHECK_THROWS_WITH(run.throw_in(box), Contains(message));
    CHECK(to_toml(run.scene()) == to_toml(untouched.scene()));
    CHECK(hash_of(run) == hash_of(untouched));
    // And it goes on as if nothing had been.
    run.throw_in(cube(Vec3(0.0, 9.0, 0.0)));
    untouched.throw_in(cube(Vec3(0.0, 9.0, 0.0)));
    step(run, 20);
    step(untouched, 20);
    CHECK(hash_of(run) == hash_of(untouched));
  }
}

TEST_CASE("Names of boxes that have gone stay taken, and one without a name gets a free one",
          "[unit][scenes][live]") {
  Puppet puppet;
  Simulation run(weightless({cube(Vec3::Zero()), cube(Vec3(3.0, 0.0, 0.0), Vec3::Zero(), "box3")}),
                 puppet);
  step(run, 1);
  CHECK(run.throw_in(cube(Vec3(6.0, 0.0, 0.0))) == "box4");
  step(run, 1);
  run.take_away("box4");
  CHECK_FALSE(is_there(run, "box4"));
  CHECK_THROWS_WITH(run.take_away("box4"), Contains("there is no box called box4 to take away"));
  CHECK_THROWS_WITH(run.throw_in(cube(Vec3(6.0, 0.0, 0.0), Vec3::Zero(), "box4")),
                    Contains("two boxes have this name"));
  CHECK(run.throw_in(cube(Vec3(6.0, 0.0, 0.0))) == "box5");
}

TEST_CASE("The energy of boxes that enter and leave is no error of the technique",
          "[exact][scenes][live]") {
  Puppet puppet;
  Scene scene = weightless({cube(Vec3::Zero(), Vec3(2.0, 0.0, 0.0)), cube(Vec3(0.0, 5.0, 0.0)),
                            cube(Vec3(0.0, 9.0, 0.0), Vec3(4.0, 0.0, 0.0)),
                            cube(Vec3(0.0, 12.0, 0.0), Vec3(6.0, 0.0, 0.0))});
  scene.boxes[2].appears = 2.0 * kDt;
  scene.boxes[3].disappears = 3.0 * kDt;
  Simulation run(scene, puppet);
  MetricsMeter meter;
  run.observe(meter);
  double joules = 2.0 + 18.0;
  const auto measured = [&] {
    step(run, 1);
    CHECK(meter.metrics().kinetic == near(joules).epsilon(1e-15));
    CHECK(std::abs(meter.metrics().energy_error) < 1e-13);
  };
  measured();
  run.throw_in(cube(Vec3(0.0, -9.0, 0.0), Vec3(0.0, 0.0, 3.0), "thrown"));
  joules += 4.5;
  measured();
  joules += 8.0;  // the late one
  measured();
  run.take_away("thrown");
  joules -= 18.0 + 4.5;  // and one goes by itself
  measured();
  // A change from inside a step is an error.
  puppet.act = [](World& world) {
    world.set_velocity(world.ids()[1], Vec3(1.0, 0.0, 0.0), Vec3::Zero());
    return StepReport{};
  };
  step(run, 1);
  CHECK(meter.metrics().energy_error == near(0.5, 1e-13));
}

TEST_CASE(
    "A step that throws leaves the scene as it was, and one with an infinite number reports it",
    "[unit][scenes][live]") {
  Puppet puppet;
  Simulation run(towers(), puppet);
  step(run, 2);
  run.throw_in(cube(Vec3(0.0, 9.0, 0.0)));
  const std::string scene = to_toml(run.scene());
  puppet.act = [](World&) -> StepReport { refuse_step("too much"); };
  CHECK_THROWS_AS(run.step(kDt), StepRefused);
  CHECK_THROWS_WITH(run.step(kDt), "tumble: too much");
  // A part of the step that was handed what it cannot take: not the caller's mistake.
  puppet.act = [](World&) -> StepReport { throw std::invalid_argument("tumble: margin = inf"); };
  CHECK_THROWS_AS(run.step(kDt), StepFault);
  CHECK_THROWS_WITH(run.step(kDt), "tumble: margin = inf");
  CHECK(to_toml(run.scene()) == scene);
  CHECK(run.world().steps() == 2);
  puppet.act = [](World& world) {
    world.states().back().position_w.y() = kNan;
    return StepReport{};
  };
  CHECK(run.step(kDt).status == StepStatus::not_finite);
  CHECK(to_toml(run.scene()) == scene);
}

TEST_CASE("Values out of the range of a scene are refused with body, value and remedy",
          "[unit][scenes]") {
  Scene start{.ground = SceneGround{}};
  SceneBox box;
  box.name = "die";
  box.position_w = Vec3(0.0, 2.0, 0.0);
  start.boxes = {box};
  struct Case {
    std::string what;  // the message has all of these
    std::vector<std::string> message;
    std::function<void(Scene&, SceneBox&)> spoil;
  };
  const std::vector<Case> cases = {
      {"speed",
       {"die", "velocity_w = [4e+19, 0, 0]", "speed of light", "slower"},
       [](Scene&, SceneBox& b) { b.velocity_w.x() = 4e19; }},
      {"speed in all directions",
       {"die", "velocity_w = [2e+08, -2e+08, 2e+08]", "slower"},
       [](Scene&, SceneBox& b) { b.velocity_w = Vec3(2e8, -2e8, 2e8); }},
      {"place",
       {"die", "position_w = [0, 1e+18, 0]", "1e+10 times the shortest edge", "origin"},
       [](Scene&, SceneBox& b) { b.position_w.y() = 1e18; }},
      {"place of a fixed box",
       {"die", "position_w = [-1e+11, 2, 0]", "origin"},
       [](Scene&, SceneBox& b) {
         b.fixed = true;
         b.position_w.x() = -1e11;
       }},
      {"spin",
       {"die", "angular_velocity_w = [0, 0, 1e+12]", "rad/s", "slower"},
       [](Scene&, SceneBox& b) { b.angular_velocity_w.z() = 1e12; }},
      {"mass",
       {"die", "mass = 1e-300", "from 1e-30"},
       [](Scene&, SceneBox& b) { b.mass = 1e-300; }},
      {"friction",
       {"die", "friction = 1e+300", "at most 1e+06", "rough"},
       [](Scene&, SceneBox& b) { b.friction = 1e300; }},
      {"friction of the ground",
       {"friction = 1e+07", "at most 1e+06"},
       [](Scene& s, SceneBox&) { s.ground->friction = 1e7; }},
      {"gravity",
       {"gravity = [0, -1e+10, 0]", "weaker"},
       [](Scene& s, SceneBox&) { s.gravity_w.y() = -1e10; }},
  };
  for (const Case& c : cases) {
    INFO(c.what);
    Scene spoilt = start;
    c.spoil(spoilt, spoilt.boxes[0]);
    std::string message = "not refused";
    try {
      (void)build_world(spoilt);
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    INFO(message);
    for (const std::string& part : c.message) CHECK(message.find(part) != std::string::npos);
  }

  // The same for a program that changes bodies between steps.
  Simulation run(start);
  World& world = run.world();
  const BodyId die = *world.find("die");
  const std::string before = world.hash().text();
  CHECK_THROWS_WITH(world.set_velocity(die, Vec3(0.0, 4e19, 0.0), Vec3::Zero()),
                    Contains("body \"die\": velocity_w = [0, 4e+19, 0]: expected at most"));
  CHECK_THROWS_WITH(world.push(die, Vec3(1e10, 0.0, 0.0), Vec3(0.0, 2.0, 0.0)),
                    Contains("body \"die\": velocity_w"));
  BodyState far = world.states()[1];
  far.position_w.x() = 1e18;
  CHECK_THROWS_WITH(world.set_state(die, far),
                    Contains("body \"die\": position_w = [1e+18, 2, 0]"));
  CHECK(world.hash().text() == before);
  for (const double dt : {1e-30, 1e30})
    CHECK_THROWS_WITH(run.step(dt), Contains("dt = ") && Contains("from 1e-15 to 1e+20"));
  for (int k = 0; k < 10; ++k) run.step(1e3);
  CHECK_THROWS_WITH(run.step(1e-12), Contains("dt = 1e-12: after 10000 s expected more than"));
}

TEST_CASE(
    "A box appears with the step that begins at its time, though times are sums of rounded steps",
    "[unit][scenes]") {
  Scene scene;
  for (int k = 0; k < 600; ++k) {
    SceneBox box;
    box.position_w = Vec3(2.0 * k, 1.0, 0.0);
    box.appears = k / 60.0;
    box.disappears = (k + 2) / 60.0;
    scene.boxes.push_back(box);
  }
  Simulation run(scene, std::make_unique<Puppet>());
  int late = 0;
  for (int k = 0; k < 599; ++k) {
    run.update_boxes();
    const std::size_t expected = k == 0 ? 1 : 2;  // one of this moment, and the one before it
    late += run.world().states().size() == expected ? 0 : 1;
    run.step(1.0 / 60.0);
  }
  CHECK(late == 0);
  // But no step too early.
  Scene later = scene;
  later.boxes.resize(1);
  later.boxes[0].disappears = std::numeric_limits<double>::infinity();
  later.boxes.push_back(scene.boxes[1]);
  later.boxes[1].appears = 1.002 / 60.0;
  later.boxes[1].disappears = std::numeric_limits<double>::infinity();
  Simulation next(later, std::make_unique<Puppet>());
  next.step(1.0 / 60.0);
  next.update_boxes();
  CHECK(next.world().states().size() == 1);
  next.step(1.0 / 60.0);
  next.update_boxes();
  CHECK(next.world().states().size() == 2);
}

TEST_CASE("A technique steps on when all boxes have left", "[unit][scenes][live]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    INFO(recipe.name);
    const auto stepper = made(recipe.name);
    Simulation run(towers(), *stepper);
    MetricsMeter meter;
    run.observe(meter);
    step(run, 1);
    for (const char* name : {"left", "on left", "right", "on right"}) run.take_away(name);
    CHECK(run.world().count() == 1);  // the ground
    step(run, 20);
    run.take_away("late");
    step(run, 5);
    CHECK(run.world().count() == 1);
    CHECK(meter.metrics().kinetic == 0.0);
    CHECK(meter.metrics().chatter.bodies == 0);
    CHECK(repeated(run, recipe.name) == hash_of(run));
  }
}

TEST_CASE("A box that sleeps on one that is taken away wakes and falls",
          "[unit][scenes][sleeping][live]") {
  for (const char* technique : {"contact_damped", "damped", "impulse"}) {
    for (const bool by_scene : {false, true}) {
      INFO(technique << (by_scene ? ", by the scene" : ", by hand"));
      const auto stepper = made(technique, true);
      Scene scene = towers();
      scene.boxes.pop_back();
      // Once the first of all, once the last.
      if (by_scene) std::swap(scene.boxes.front(), scene.boxes.back());
      if (by_scene) scene.boxes.back().disappears = 2.0;
      Simulation run(scene, *stepper);
      const auto sleeps = [&](std::string_view name) { return run.body(name).asleep(); };
      const auto height = [&](std::string_view name) { return run.body(name).position_w().y(); };
      step(run, 128);
      CHECK(sleeps("on left"));
      CHECK(sleeps("on right"));
      if (!by_scene) run.take_away("left");
      step(run, 1);
      CHECK_FALSE(is_there(run, "left"));
      CHECK_FALSE(sleeps("on left"));
      CHECK(sleeps("on right"));  // it stands elsewhere
      step(run, 127);
      CHECK(height("on left") == near(0.5, 0.02));
      CHECK(height("on right") == near(1.5, 0.02));
      CHECK(sleeps("on left"));
    }
  }
}

TEST_CASE("A body is read by its name, and a name that is missing is answered with the closest one",
          "[unit][scenes][live]") {
  Simulation simulation(towers());
  simulation.world().push(*simulation.world().find("on left"), Vec3(2.0, 0.0, 0.0),
                          Vec3(0.0, 2.0, 0.0));
  const BodyView top = simulation.body("on left");
  const World& world = simulation.world();
  CHECK(top.id() == *world.find("on left"));
  CHECK(top.name() == "on left");
  CHECK(top.position_w() == Vec3(0.0, 1.5, 0.0));
  CHECK(top.orientation_wb().coeffs() == Quat::Identity().coeffs());
  CHECK(top.velocity_w() == Vec3(2.0, 0.0, 0.0));
  // ω = (r × j) / I with r = 1/2 and I = 1/6.
  CHECK((top.angular_velocity_w() - Vec3(0.0, 0.0, -6.0)).norm() < 1e-14);
  CHECK(top.kinetic_energy() == near(0.5 * 4.0 + 0.5 * 36.0 / 6.0).epsilon(1e-15));
  CHECK(top.potential_energy() == near(9.81 * 1.5).epsilon(1e-15));
  CHECK_FALSE(top.asleep());
  CHECK(simulation.body("ground").potential_energy() == 0.0);
  CHECK(&world.body(top.id()).state() == &top.state());
  CHECK(world.index_of("right") == world.index_of(*world.find("right")));
  CHECK_THROWS_WITH(simulation.body("on lift"),
                    "tumble: there is no body called on lift: did you mean on left?");
  CHECK_THROWS_WITH(world.index_of("chimney"), "tumble: there is no body called chimney");
  CHECK_THROWS_WITH(world.body(BodyId{99}), Contains("there is no body with id 99"));
}

TEST_CASE("A simulation takes a technique by name, and runs for a time in steps of its own",
          "[unit][scenes]") {
  Simulation by_name(towers(), "damped", {"damping=none"}, 7);
  CHECK(by_name.technique().name() == "damped");
  CHECK(by_name.run_for(0.5) == StepStatus::done);
  CHECK(by_name.world().steps() == 30);
  const auto technique = make_technique("damped", {"damping=none"}, 7);
  Simulation by_hand(towers(), *technique);
  for (int k = 0; k < 30; ++k) by_hand.step(1.0 / 60.0);
  CHECK(hash_of(by_name) == hash_of(by_hand));
  CHECK(by_name.run_for(0.1, 0.05) == StepStatus::done);
  CHECK(by_name.world().steps() == 32);
  CHECK(Simulation(towers()).technique().name() == kDefaultTechnique);

  CHECK_THROWS_WITH(by_name.run_for(-1.0), Contains("seconds = -1"));
  CHECK_THROWS_WITH(by_name.run_for(1.0, 0.0), Contains("dt = 0"));
  CHECK_THROWS_WITH(Simulation(towers(), "dumped"), Contains("did you mean damped?"));
  CHECK_THROWS_WITH(Simulation(towers(), "damped", {"damping"}), Contains("expected key=value"));
  CHECK_THROWS_WITH(Simulation(towers(), std::unique_ptr<Technique>()),
                    Contains("technique is null"));
}

TEST_CASE(
    "Observers of a simulation see its start, events, changes and steps, until they are removed",
    "[unit][scenes]") {
  struct Count : Observer {
    int begins = 0, changes = 0, events = 0, steps = 0;
    double energy = 0.0;
    void on_begin(const World&) override { ++begins; }
    void on_change(const World&, double added) override { ++changes, energy += added; }
    void on_event(const Event&) override { ++events; }
    void on_step(const World&, const StepReport&) override { ++steps; }
  };
  Simulation simulation(
      weightless({cube(Vec3::Zero()), cube(Vec3(1.05, 0.0, 0.0), Vec3(-4.0, 0.0, 0.0))}), "basic");
  Count count;
  simulation.observe(count);
  simulation.throw_in(cube(Vec3(0.0, 9.0, 0.0)));  // the start is another one
  CHECK(count.begins == 2);
  simulation.step(kDt);
  CHECK(count.events == 1);
  simulation.throw_in(cube(Vec3(0.0, 12.0, 0.0), Vec3(2.0, 0.0, 0.0)));
  CHECK(count.energy == near(2.0).epsilon(1e-15));
  simulation.step(kDt);
  CHECK(count.steps == 2);
  const int changes = count.changes;
  simulation.stop_observing(count);
  simulation.step(kDt);
  CHECK(count.steps == 2);
  CHECK(count.changes == changes);
}
