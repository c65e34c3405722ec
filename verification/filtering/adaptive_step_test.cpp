/// \file
/// \brief Adaptive steps: bits, times, reports, copies, refusals (thesis 6.3.1).
#include "tumble/filtering/adaptive_step.hpp"

#include "tumble/dynamics/snapshot.hpp"
#include "tumble/dynamics/step_report.hpp"

#include "filtering/adaptive_cases.hpp"
#include "support/test.hpp"

using namespace tumble::adaptive_cases;

namespace {

bool same(const StepReport& a, const StepReport& b) {
  for (const auto& [name, count] : kReportCounts)
    if (a.*count != b.*count) return false;
  return a.status == b.status && a.deepest_overlap == b.deepest_overlap &&
         a.energy.restitution == b.energy.restitution && a.energy.friction == b.energy.friction &&
         a.energy.damping == b.energy.damping && a.energy.repair == b.energy.repair;
}

// Ends with a prescribed status after a number of steps.
class Failing : public Cloned<Technique, Failing> {
 public:
  Failing(int good, StepStatus status) : good_(good), status_(status) {}
  [[nodiscard]] std::string_view name() const override { return "failing"; }
  StepReport step(World& world, double dt) override {
    StepReport report{.contacts = good_, .pair_tests = 3};
    report.energy.friction = -0.5;
    if (good_-- == 0) {
      report.status = status_;
      if (status_ == StepStatus::done) world.states()[0].position_w.x() = kNan;
      return report;
    }
    world.finish_step(dt);
    return report;
  }

 private:
  int good_;
  StepStatus status_;
};

class Watcher : public Observer {
 public:
  std::vector<double> times;  // [s] of the events
  void on_event(const Event& event) override { times.push_back(event.time); }
};

}  // namespace

TEST_CASE("A step without halvings has the bits of the technique alone", "[exact][filtering]") {
  for (const char* name : {"damped", "contact_damped", "impulse"}) {
    World alone = clump(2);
    World wrapped = alone;
    const auto technique = make(name);
    AdaptiveStep adaptive(make(name), halvings(0));
    for (int k = 0; k < 90; ++k) {
      const StepReport a = technique->step(alone, kStep);
      const StepReport b = adaptive.step(wrapped, kStep);
      REQUIRE(same(a, b));
      REQUIRE(alone.hash().text() == wrapped.hash().text());
      REQUIRE(adaptive.contacts().size() == technique->contacts().size());
    }
    CHECK(adaptive.name() == name);
    CHECK(adaptive.ignores(wrapped) == technique->ignores(alone));
    REQUIRE(adaptive.substeps().size() == 1);
    CHECK(adaptive.substeps()[0] == kStep);
  }
}

TEST_CASE("Divided steps end at the time of whole ones to the bit", "[exact][filtering]") {
  for (const double dt : {kStep, 0.01, 0.1, 1.0 / 3.0}) {
    World world = clump(2);
    AdaptiveStep adaptive(make("damped"), halvings(4, 1));
    double time = 0.0;
    std::int64_t substeps = 0;
    bool varied = false;
    for (int k = 0; k < 120; ++k) {
      adaptive.step(world, dt);
      time += dt;
      REQUIRE(world.time() == time);
      substeps += static_cast<std::int64_t>(adaptive.substeps().size());
      varied = varied || adaptive.substeps().size() > 2;
      for (const double h : adaptive.substeps()) {
        // [s] the clock's rounding, 1e-14 at up to 64 s, a few times over
        const double parts = dt / h;
        REQUIRE(parts == near(static_cast<double>(std::llround(parts)), 1e-9));
      }
    }
    CHECK(varied);
    CHECK(world.steps() == substeps);
  }
}

TEST_CASE("As many halvings at least as at most give the technique's own smaller steps",
          "[exact][filtering]") {
  World fine = clump(2);
  World divided = fine;
  const auto technique = make("damped");
  AdaptiveStep adaptive(make("damped"), halvings(2, 2));
  const double dt = 1.0 / 64.0;  // sums of it are exact
  for (int k = 0; k < 60; ++k) {
    StepReport sum;
    for (int part = 0; part < 4; ++part) {
      const StepReport report = technique->step(fine, dt / 4.0);
      add_report(report, sum);
      sum.contacts = report.contacts;
    }
    REQUIRE(same(adaptive.step(divided, dt), sum));
    REQUIRE(fine.hash().text() == divided.hash().text());
    REQUIRE(adaptive.substeps().size() == 4);
  }
}

TEST_CASE("A longer sub-step begins only where it ends with the step", "[unit][filtering]") {
  World world = clump(2);
  AdaptiveStep adaptive(make("damped"), halvings(4));
  bool mixed = false;
  for (int k = 0; k < 120; ++k) {
    adaptive.step(world, kStep);
    std::int64_t place = 0;  // in sixteenths
    for (const double h : adaptive.substeps()) {
      const auto length = static_cast<std::int64_t>(std::llround(16.0 * h / kStep));
      REQUIRE(length >= 1);
      REQUIRE((length & (length - 1)) == 0);
      REQUIRE(place % length == 0);
      place += length;
      mixed =
          mixed || h < 0.75 * adaptive.substeps().front() || h > 1.5 * adaptive.substeps().front();
    }
    REQUIRE(place == 16);
  }
  CHECK(mixed);
}

TEST_CASE("Going on from a copy of an adaptive step gives the same bits, whenever it was made",
          "[unit][filtering]") {
  World falling = one_cube(Vec3(0.0, -9.0, 0.0));
  falling.add_ground();
  for (const World& world : {falling, clump(2)}) {
    AdaptiveStep adaptive(make("damped"), halvings(3));
    std::vector<Snapshot> copies;
    Snapshot original(world, adaptive);
    for (int k = 0; k < 90; ++k) {
      const StepReport report = original.step(kStep);
      const auto& steps = dynamic_cast<const AdaptiveStep&>(original.technique());
      for (Snapshot& copy : copies) {
        REQUIRE(same(copy.step(kStep), report));
        REQUIRE(copy.world().hash().text() == original.world().hash().text());
        const auto& others = dynamic_cast<const AdaptiveStep&>(copy.technique());
        REQUIRE(std::vector<double>(steps.substeps().begin(), steps.substeps().end()) ==
                std::vector<double>(others.substeps().begin(), others.substeps().end()));
        REQUIRE(std::vector<BodyId>(steps.touched().begin(), steps.touched().end()) ==
                std::vector<BodyId>(others.touched().begin(), others.touched().end()));
      }
      if (k >= 15 && copies.size() < 20) copies.emplace_back(original);
    }
  }
}

TEST_CASE("A step that is not finished ends with the sub-step that failed", "[unit][filtering]") {
  for (const StepStatus status : {StepStatus::unsolved, StepStatus::not_finite, StepStatus::done}) {
    World world = one_cube(Vec3::Zero());
    AdaptiveStep adaptive(std::make_unique<Failing>(2, status), halvings(2, 2));
    const StepReport report = adaptive.step(world, kStep);
    // `done` leaves a state that is not finite.
    CHECK(report.status == (status == StepStatus::done ? StepStatus::not_finite : status));
    CHECK(adaptive.substeps().size() == 3);
    CHECK(world.steps() == 2);
    CHECK(world.time() == kStep / 2.0);
    CHECK(report.pair_tests == 9);
    CHECK(report.contacts == 0);  // of the last sub-step; before there were 2 and 1
    CHECK(report.energy.friction == -1.5);
  }
  World world = one_cube(Vec3::Zero());
  AdaptiveStep adaptive(std::make_unique<Failing>(2, StepStatus::event_cap), halvings(1, 1));
  CHECK(adaptive.step(world, kStep).status == StepStatus::done);
}

TEST_CASE("An observer of an adaptive step receives the events of its sub-steps",
          "[unit][filtering]") {
  World world = one_cube(Vec3(0.0, -9.0, 0.0));
  world.add_ground();
  AdaptiveStep adaptive(make("damped"), halvings(2, 2));
  Watcher watcher;
  adaptive.observe(&watcher);
  std::int64_t events = 0;
  for (int k = 0; k < 60; ++k) events += adaptive.step(world, kStep).events;
  CHECK(events > 0);
  CHECK(static_cast<std::int64_t>(watcher.times.size()) == events);
  adaptive.observe(nullptr);
  const auto told = watcher.times.size();
  world.set_velocity(world.ids()[0], Vec3(0.0, 3.0, 0.0), Vec3::Zero());
  for (int k = 0; k < 90; ++k) adaptive.step(world, kStep);
  CHECK(watcher.times.size() == told);
}

TEST_CASE("An adaptive step refuses invalid arguments and names them", "[unit][filtering]") {
  const auto refused = [](const AdaptiveStepOptions& options, const std::string& word) {
    const std::string message = refusal_of([&] { AdaptiveStep adaptive(make("damped"), options); });
    return message.find(word) != std::string::npos;
  };
  CHECK_THROWS_AS(AdaptiveStep(nullptr), std::invalid_argument);
  CHECK(refused(halvings(-1), "halvings = -1"));
  CHECK(refused(halvings(21), "halvings = 21"));
  CHECK(refused(halvings(2, 3), "fewest = 3"));
  CHECK(refused(halvings(2, -1), "fewest = -1"));
  CHECK_NOTHROW(AdaptiveStep(make("damped"), halvings(20, 20)));
  CHECK(refused({.movement = 0.0}, "movement = 0"));
  CHECK(refused({.turn = kNan}, "turn = nan"));
  CHECK(refused({.overlap = -1.0}, "overlap = -1"));
  CHECK(refused({.shake = 0.0}, "shake = 0"));
  CHECK(refused({.calm = 0}, "calm = 0"));

  World world = one_cube(Vec3::Zero());
  AdaptiveStep adaptive(make("damped"));
  CHECK_THROWS_AS(adaptive.step(world, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(adaptive.step(world, kNan), std::invalid_argument);
}
