/// \file
/// \brief Recorders and snapshots.
#include "tumble/dynamics/trajectory.hpp"

#include "tumble/dynamics/integrate.hpp"
#include "tumble/dynamics/snapshot.hpp"

#include "support/test.hpp"

namespace {

// A technique that is no more than flight, with a memory: it counts its steps and turns the wind
// by them. It reports one event per step to its observer.
class Drift : public Cloned<Technique, Drift> {
 public:
  [[nodiscard]] std::string_view name() const override { return "drift"; }
  StepReport step(World& world, double dt) override {
    ++steps_;
    StepReport report;
    const Vec3 wind(0.125 * steps_, 0.0, 0.0);
    for (std::size_t i = 0; i < world.states().size(); ++i) {
      fly(world.bodies()[i], world.states()[i], world.gravity_w + wind, dt,
          RotationRule::splitting);
      ++report.integrations;
    }
    world.finish_step(dt);
    if (observer() != nullptr) {
      observer()->on_event({.time = world.time()});
      observer()->on_step(world, report);
    }
    return report;
  }

 private:
  int steps_ = 0;
};

World two_boxes() {
  World world;
  const BodyProperties box = box_properties(Vec3(1.0, 2.0, 3.0), 1.0);
  for (int i = 0; i < 2; ++i)
    world.add(box, Vec3(4.0 * i, 5.0, 0.0), Quat::Identity(), Vec3::Zero(), Vec3(1.0, 2.0, 3.0));
  return world;
}

}  // namespace

TEST_CASE("A recorder keeps the start and every n-th step", "[unit][trajectory]") {
  World world = two_boxes();
  TrajectoryRecorder recorder(world, 3);
  Drift technique;
  technique.observe(&recorder);
  for (int i = 0; i < 10; ++i) technique.step(world, 0.25);
  const Trajectory& trajectory = recorder.trajectory();
  REQUIRE(trajectory.count() == 4);
  for (int i = 0; i < 4; ++i) {
    CHECK(trajectory.frame(i).step == 3 * i);
    CHECK(trajectory.frame(i).time == 0.75 * i);
    CHECK(trajectory.frame(i).ids.size() == 2);
  }
  technique.observe(nullptr);
  technique.step(world, 0.25);
  technique.step(world, 0.25);
  CHECK(trajectory.count() == 4);
}

TEST_CASE("A body is found in the frames that have it, and only there", "[unit][trajectory]") {
  World world = two_boxes();
  Trajectory trajectory;
  const BodyId first = world.ids()[0];
  const BodyId second = world.ids()[1];
  trajectory.record(world);
  world.remove(first);
  world.finish_step(0.5);
  trajectory.record(world);
  const BodyId third = world.add(box_properties(Vec3::Ones(), 1.0), Vec3(9.0, 0.0, 0.0));
  world.finish_step(0.5);
  trajectory.record(world);

  REQUIRE(trajectory.count() == 3);
  CHECK(trajectory.samples(first).size() == 1);
  CHECK(trajectory.samples(second).size() == 3);
  CHECK(trajectory.samples(second)[2].time == 1.0);
  CHECK(trajectory.samples(second)[2].state.position_w.x() == 4.0);
  REQUIRE(trajectory.samples(third).size() == 1);
  CHECK(trajectory.samples(third)[0].state.position_w.x() == 9.0);
  CHECK_FALSE(trajectory.state(1, first));
  CHECK(trajectory.state(0, first)->position_w.x() == 0.0);
  CHECK(trajectory.samples(BodyId{77}).empty());
  CHECK(trajectory.frame(1).states.size() == 1);
}

TEST_CASE("Recorders refuse frames that do not exist and no stride", "[unit][trajectory]") {
  const Trajectory empty;
  CHECK_THROWS_WITH(empty.frame(0), "tumble: frame 0: there are 0, counted from 0");
  CHECK_THROWS_AS(empty.state(-1, BodyId{0}), std::invalid_argument);
  CHECK_THROWS_WITH(TrajectoryRecorder(World{}, 0), "tumble: every = 0: expected at least 1");
}

TEST_CASE("Going on from a snapshot gives the bits of going on without one",
          "[determinism][trajectory]") {
  Snapshot run(two_boxes(), Drift());
  for (int i = 0; i < 20; ++i) run.step(0.01);
  const Snapshot kept = run;
  for (int i = 0; i < 100; ++i) run.step(0.01 + 0.001 * (i % 3));
  const std::uint64_t expected = run.world().hash().value();

  Snapshot again = kept;  // with the technique's memory: its wind depends on the step
  for (int i = 0; i < 100; ++i) again.step(0.01 + 0.001 * (i % 3));
  CHECK(again.world().hash().value() == expected);
  CHECK(kept.world().steps() == 20);

  run = kept;
  CHECK(run.world().hash().value() == kept.world().hash().value());
  for (int i = 0; i < 100; ++i) run.step(0.01 + 0.001 * (i % 3));
  CHECK(run.world().hash().value() == expected);
  CHECK(run.technique().name() == "drift");

  // Without the memory it is another run.
  Snapshot forgetful(kept.world(), Drift());
  for (int i = 0; i < 100; ++i) forgetful.step(0.01 + 0.001 * (i % 3));
  CHECK(forgetful.world().hash().value() != expected);
}
