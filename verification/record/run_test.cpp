/// \file
/// \brief The loop of a run: number and length of steps, observers, ends.
#include "tumble/record/run.hpp"

#include "tumble/base/error.hpp"
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/record/table_file.hpp"

#include "support/test.hpp"

namespace {

// A technique that does what a test wants. The default: time passes and nothing moves.
class Puppet : public Cloned<Technique, Puppet> {
 public:
  std::function<StepReport(World&, int)> act = [](World&, int) { return StepReport{}; };
  std::vector<double> steps;  // [s] the lengths that were asked for

  [[nodiscard]] std::string_view name() const override { return "puppet"; }
  StepReport step(World& world, double dt) override {
    steps.push_back(dt);
    const StepReport report = act(world, static_cast<int>(steps.size()));
    world.finish_step(dt);
    if (observer() != nullptr && report.events > 0) observer()->on_event(Event{});
    return report;
  }
  [[nodiscard]] bool is_watched() const { return observer() != nullptr; }
};

struct Counter : RunObserver {
  int begun = 0;
  int steps = 0;
  int events = 0;
  std::function<void(int)> then = [](int) {};
  void on_begin(const World&) override { ++begun; }
  void on_step(const World&, const Technique&, const StepReport&, const Metrics&) override {
    then(++steps);
  }
  void on_event(const World&, const Event&) override { ++events; }
};

Scene one_box() {
  Scene scene;
  scene.boxes.push_back(SceneBox{.name = "box", .position_w = Vec3(0.0, 5.0, 0.0)});
  return scene;
}

RunSettings settings_of(double dt, double duration) {
  return RunSettings{.dt = dt, .duration = duration};
}

}  // namespace

TEST_CASE("The last step of a run is cut to end at the duration", "[unit][record][run]") {
  struct Case {
    double dt, duration;
    std::size_t steps;
    double last;  // [s]
  };
  const std::array<Case, 7> cases = {{{0.25, 1.0, 4, 0.25},
                                      {0.25, 1.1, 5, 0.1},
                                      {0.1, 0.3, 3, 0.1},  // 0.3 / 0.1 rounds to below 3
                                      {1.0 / 60.0, 10.0, 600, 1.0 / 60.0},
                                      {1.0 / 60.0, 1.0 / 60.0 + 1e-6, 2, 1e-6},
                                      {5.0, 1.0, 1, 1.0},
                                      {1.0, 0.0, 0, 0.0}}};
  for (const Case& c : cases) {
    INFO("dt " << c.dt << ", duration " << c.duration);
    Puppet puppet;
    const RunResult result = run_scene(one_box(), puppet, settings_of(c.dt, c.duration), {});
    CHECK(puppet.steps.size() == c.steps);
    CHECK(result.steps == static_cast<std::int64_t>(c.steps));
    CHECK(result.end == RunEnd::complete);
    // Times are sums of steps: half a unit of rounding for each of at most 600. Measured: 5e-14.
    CHECK(result.time == near(c.duration, 1e-12));
    if (c.steps > 0) CHECK(puppet.steps.back() == near(c.last).epsilon(1e-9));
    CHECK(result.last.potential == near(9.81 * 5.0, 1e-12));  // measured even if no step was done
  }
}

TEST_CASE("Settings that make no run are refused before anything is built", "[unit][record][run]") {
  const auto refused = [](RunSettings settings) {
    Puppet puppet;
    return refusal_of([&] { run_scene(one_box(), puppet, settings, {}); });
  };
  CHECK(refused(settings_of(0.0, 1.0)) == "tumble: dt = 0: expected a finite number above 0");
  CHECK(refused(settings_of(kNan, 1.0)).find("dt = nan") != std::string::npos);
  CHECK(refused(settings_of(0.1, -1.0)).find("duration = -1") != std::string::npos);
  CHECK(refused(settings_of(0.1, HUGE_VAL)).find("duration = inf") != std::string::npos);
  CHECK(refused(settings_of(1e-3, 1e300)).find("1e12 steps") != std::string::npos);
  RunSettings never = settings_of(0.1, 1.0);
  never.every = 0;
  CHECK(refused(never).find("every = 0") != std::string::npos);
}

TEST_CASE("Each observer gets the start, every step and every event", "[unit][record][run]") {
  Puppet puppet;
  puppet.act = [](World&, int k) {
    return StepReport{.status = k == 2 ? StepStatus::event_cap : StepStatus::done,
                      .events = k == 3 ? 1 : 0,
                      .pair_tests = k};
  };
  Counter one;
  Counter two;
  const std::array<RunObserver*, 2> observers = {&one, &two};
  const RunResult result = run_scene(one_box(), puppet, settings_of(0.5, 2.0), observers);
  for (const Counter* counter : {&one, &two}) {
    CHECK(counter->begun == 1);
    CHECK(counter->steps == 4);
    CHECK(counter->events == 1);
  }
  CHECK(result.capped_steps == 1);
  CHECK(result.worst == StepStatus::event_cap);
  CHECK(result.end == RunEnd::complete);  // a capped step is no reason to stop
  CHECK(result.totals.pair_tests == 10);
  CHECK(result.last_report.pair_tests == 4);
  CHECK(result.worst_report.pair_tests == 4);
  CHECK(result.worst_report.events == 1);
  CHECK(!puppet.is_watched());
}

TEST_CASE("Numbers at their worst are those farthest from 0", "[unit][record][run]") {
  Puppet puppet;  // throws the box up and down; nothing is booked, so all of it is error
  const std::array<double, 4> speeds = {3.0, -4.0, 1.0, 0.0};
  puppet.act = [&](World& world, int k) {
    world.set_velocity(world.ids()[0], Vec3(0.0, speeds[static_cast<std::size_t>(k - 1)], 0.0),
                       Vec3::Zero());
    return StepReport{};
  };
  const RunResult result = run_scene(one_box(), puppet, settings_of(1.0, 4.0), {});
  CHECK(result.worst_metrics.kinetic == 8.0);
  CHECK(result.worst_metrics.energy_error == near(8.0, 1e-12));
  CHECK(result.worst_metrics.fastest == 4.0);
  CHECK(result.worst_metrics.momentum_w == Vec3(0.0, -4.0, 0.0));
  CHECK(result.worst_metrics.potential == near(9.81 * 5.0, 1e-12));
  CHECK(result.last.kinetic == 0.0);
}

TEST_CASE("A run ends at a step that solved nothing or made a number infinite",
          "[unit][record][run]") {
  for (const bool infinite : {false, true}) {
    Puppet puppet;
    puppet.act = [&](World& world, int k) {
      StepReport report;
      if (k == 3 && infinite) world.states()[0].position_w.x() = kNan;
      if (k == 3 && !infinite) report.status = StepStatus::unsolved;
      return report;
    };
    Counter counter;
    const std::array<RunObserver*, 1> observers = {&counter};
    const RunResult result = run_scene(one_box(), puppet, settings_of(0.1, 1.0), observers);
    CHECK(result.end == RunEnd::failed);
    CHECK(result.worst == (infinite ? StepStatus::not_finite : StepStatus::unsolved));
    CHECK(result.steps == 3);
    CHECK(counter.steps == 3);  // the step that failed is reported too
  }
}

TEST_CASE("A step that is refused or breaks off ends the run and keeps what was before",
          "[unit][record][run]") {
  for (const bool refused : {false, true}) {
    for (const int last : {1, 3}) {
      CAPTURE(refused, last);
      Puppet puppet;
      puppet.act = [&](World&, int k) -> StepReport {
        if (k == last && refused) refuse_step("stiffness = 1e9");
        if (k == last) throw std::invalid_argument("state of box1 is not finite");
        return {};
      };
      Counter counter;
      const std::array<RunObserver*, 1> observers = {&counter};
      const auto run = [&] {
        return run_scene(one_box(), puppet, settings_of(0.1, 1.0), observers);
      };
      if (refused && last == 1) {  // nothing has been done yet
        CHECK_THROWS_AS(run(), StepRefused);
        CHECK(counter.steps == 0);
        continue;
      }
      const RunResult result = run();
      CHECK(result.end == RunEnd::failed);
      CHECK(result.worst == StepStatus::unsolved);
      CHECK(result.refusal ==
            (refused ? "tumble: stiffness = 1e9" : "state of box1 is not finite"));
      CHECK(result.steps == last - 1);
      CHECK(counter.steps == last - 1);
      CHECK(!puppet.is_watched());
    }
  }
}

TEST_CASE("A run stops when it is asked to, between two steps", "[unit][record][run]") {
  Puppet puppet;
  Counter counter;
  bool asked = false;
  counter.then = [&](int k) { asked = k == 3; };
  const std::array<RunObserver*, 1> observers = {&counter};
  const RunResult result =
      run_scene(one_box(), puppet, settings_of(0.1, 1.0), observers, [&] { return asked; });
  CHECK(result.end == RunEnd::interrupted);
  CHECK(result.steps == 3);
  CHECK(result.time == near(0.3, 1e-12));
  CHECK(!result.state_hash.empty());
}

TEST_CASE("After a run that an observer broke off the technique has no observer",
          "[unit][record][run]") {
  Puppet puppet;
  Counter counter;
  counter.then = [](int k) {
    if (k == 2) throw CannotWrite("disk full");
  };
  const std::array<RunObserver*, 1> observers = {&counter};
  CHECK_THROWS_AS(run_scene(one_box(), puppet, settings_of(0.1, 1.0), observers), CannotWrite);
  CHECK(puppet.steps.size() == 2);
  CHECK(!puppet.is_watched());
}
