/// \file
/// \brief Synchronised timewarps against closed forms: cubes on a line, bounces, free fall.

#include "support/test.hpp"
#include "timewarp/cases.hpp"

namespace {

double x_of(const World& world, int body) { return world.states()[idx(body)].position_w.x(); }

double v_of(const World& world, int body) {
  const auto k = idx(body);
  return velocity(world.bodies()[k], world.states()[k]).x();
}

// A cube of 10 cm, flat on the ground or above it.
World cube_above_ground(double height, double speed_up, double restitution) {
  World world = ground_world(0.0, restitution);
  world.add(box_properties(Vec3::Constant(0.1), 1.0, 0.0, restitution),
            Vec3(0.0, 0.05 + height, 0.0), Quat::Identity(), Vec3(0.0, speed_up, 0.0));
  return world;
}

// Records the gap of each pair that has just collided.
class Looker final : public TimewarpWatcher {
 public:
  explicit Looker(const World& world) : world_(world) {}
  void on_queue(const TimewarpLook& look) override {
    if (look.current == nullptr) return;
    const IndexPair& pair = look.current->pair;
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    smallest_gap = std::min(
        smallest_gap,
        gap_between(world_.bodies()[a], look.valid[a], world_.bodies()[b], look.valid[b]).distance);
    for (std::size_t k = 1; k < look.foreseen.size(); ++k)
      in_order = in_order && !(look.foreseen[k] < look.foreseen[k - 1]);
    ++collisions;
  }

  double smallest_gap = kInfinity;  // [m]
  bool in_order = true;             // whether the queue is sorted
  int collisions = 0;

 private:
  const World& world_;
};

template <class T>
void step_of(T technique, World& world, double dt, TimewarpWatcher& watcher) {
  technique.watch(&watcher);
  technique.step(world, dt);
}

// A step of an observed technique.
void step_watched(std::string_view name, World& world, double dt, TimewarpWatcher& watcher) {
  if (name == "timewarp_simple") return step_of(TimewarpSimple(), world, dt, watcher);
  if (name == "timewarp_safer") return step_of(TimewarpSafer(), world, dt, watcher);
  step_of(TimewarpSwept(), world, dt, watcher);
}

}  // namespace

TEST_CASE("Three boxes on a line collide at the times of the closed form", "[exact][timewarp]") {
  for (const char* name : kTimewarps) {
    for (const double resolution : {1e-6, 1e-12}) {
      CAPTURE(name, resolution);
      World world = line_of("0:2,1.5:0,3.4:-1");
      const auto technique = make_timewarp(name, {.resolution = resolution});
      Listener heard;
      technique->observe(&heard);
      const StepReport report = technique->step(world, 1.0);
      REQUIRE(heard.events.size() == 3);
      CHECK(report.events == 3);
      CHECK(report.fallbacks == 0);
      CHECK(names_of(world, heard.events[0]) == "a-b");
      CHECK(names_of(world, heard.events[1]) == "b-c");
      CHECK(names_of(world, heard.events[2]) == "a-b");
      // Each collision is reported up to one resolution early. The following ones are moved by
      // the ratio of speeds before and after it, 1.5 resolutions at most, and rounding of 1e-15.
      const double close = 4.0 * resolution + 1e-14;
      CHECK(heard.events[0].time == near(0.25, close));
      CHECK(heard.events[1].time == near(0.2 + 0.8 / 3.0, close));
      CHECK(heard.events[2].time == near(0.9, close));
      CHECK(x_of(world, 0) == near(0.4, close));
      CHECK(x_of(world, 1) == near(1.5, close));
      CHECK(x_of(world, 2) == near(4.0, close));
      CHECK(v_of(world, 0) == near(-1.0, 1e-14));
      CHECK(v_of(world, 1) == near(0.0, 1e-14));
      CHECK(v_of(world, 2) == near(2.0, 1e-14));
      for (const Event& event : heard.events) CHECK(event.rewinds == 2);
    }
  }
}

TEST_CASE("Simultaneous collisions are resolved together", "[exact][timewarp]") {
  // The middle one is hit from both sides; each of the three is rolled back once.
  World world = line_of("0:1,1.5:0,3:-1");
  TimewarpSwept swept;
  Listener heard;
  swept.observe(&heard);
  const StepReport report = swept.step(world, 1.0);
  REQUIRE(heard.events.size() == 2);
  CHECK(heard.events[0].time == heard.events[1].time);
  CHECK(report.rewinds == 3);
  CHECK(v_of(world, 0) == near(-1.0, 1e-14));
  CHECK(v_of(world, 1) == near(0.0, 1e-14));
  CHECK(v_of(world, 2) == near(1.0, 1e-14));

  TimewarpSweptOptions in_a_row;
  in_a_row.ties = TieRule::one_by_one;
  World again = line_of("0:1,1.5:0,3:-1");
  CHECK(TimewarpSwept(in_a_row).step(again, 1.0).events == 3);
  CHECK(v_of(again, 0) == near(-1.0, 1e-14));
  CHECK(v_of(again, 2) == near(1.0, 1e-14));
}

TEST_CASE("Cubes that stick go on together", "[exact][timewarp]") {
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    World world = line_of("0:2,1.5:0,5:0", "0");
    const auto technique = make_timewarp(name);
    std::int64_t events = 0;
    for (int k = 0; k < 100; ++k) events += technique->step(world, 0.02).events;
    CHECK(events == 1);
    CHECK(x_of(world, 0) == near(0.5 + 1.75, 4e-6));
    CHECK(x_of(world, 1) == near(1.5 + 1.75, 4e-6));
    CHECK(v_of(world, 0) == near(1.0, 1e-14));
    CHECK(v_of(world, 1) == near(1.0, 1e-14));
  }
}

TEST_CASE("A neighbour that was met on the way is found by the safer timewarp",
          "[exact][timewarp]") {
  // A flies to C; on the way it collides with B, which sinks and has left at the end of the frame,
  // but not yet when A collides with C.
  World world = line_of("0:2,1.8:0,9:0");
  world.states()[1].position_w = Vec3(1.8, -0.1, 0.0);
  world.states()[1].linear_momentum_w = Vec3(0.0, -1.0, 0.0);
  world.states()[2].position_w = Vec3(2.6, 0.95, 0.0);
  World again = world;
  TimewarpSimple simple;
  Listener simply;
  simple.observe(&simply);
  simple.step(world, 1.0);
  TimewarpSafer safer;
  Listener safely;
  safer.observe(&safely);
  const StepReport report = safer.step(again, 1.0);
  REQUIRE(!simply.events.empty());
  REQUIRE(!safely.events.empty());
  CHECK(names_of(world, simply.events[0]) == "a-c");
  CHECK(names_of(again, safely.events[0]) == "a-b");
  CHECK(safely.events[0].time == near(0.4, 2e-6));
  CHECK(report.restarts == 1);
}

TEST_CASE("A train of bounces ends where its hops get shorter than the resolution",
          "[exact][timewarp]") {
  // It hits the ground at 5 cm/s: separates at 5 cm/s times e, e², ..., and hops of 2 e^k v / g follow.
  for (const char* name : kTimewarps) {
    for (const double e : {0.0, 0.5, 0.9}) {
      CAPTURE(name, e);
      const double g = 9.81;
      const double resolution = 1e-6;
      int hops = 0;
      for (double up = 0.05 * e; 2.0 * up / g > resolution; up *= e) ++hops;
      CHECK(hops == (e == 0.0 ? 0 : e == 0.5 ? 13 : 87));
      World world = cube_above_ground(0.0, -0.05, e);
      const auto technique = make_timewarp(name, {.resolution = resolution});
      Listener heard;
      technique->observe(&heard);
      const double dt = 0.2;  // all of it in one frame: 10.2 ms or 91.7 ms
      const StepReport report = technique->step(world, dt);
      CHECK(report.status == StepStatus::done);
      CHECK(report.fallbacks == 1);
      REQUIRE(static_cast<std::int64_t>(heard.events.size()) == report.events);
      if (std::string_view(name) == "timewarp_swept") {
        // Conservative advancement ends at the ground up to rounding.
        CHECK(report.events == hops + 1);
      } else {
        // Bisection ends up to a resolution earlier, where hops of one or two resolutions are
        // at their top: some more bounces, 3 for e = 0.9.
        CHECK(report.events >= hops + 1);
        CHECK(report.events <= hops + 1 + static_cast<int>(e / 0.15));
      }
      // Each hop may end up to a resolution early, which delays the next ones by as much.
      double time = 0.0;
      double up = 0.05 * e;
      for (int k = 0; k <= std::min(hops, 6); ++k) {
        CAPTURE(k);
        CHECK(heard.events[idx(k)].time == near(time, 2.0 * (k + 1) * resolution));
        time += 2.0 * up / g;
        up *= e;
      }
    }
  }
}

TEST_CASE("A pair that collides too often in a frame is left to its end", "[unit][timewarp]") {
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    World world = cube_above_ground(0.0, -0.05, 0.9);
    const StepReport report = make_timewarp(name, {.pair_events = 7})->step(world, 0.2);
    CHECK(report.events == 7);
    CHECK(report.fallbacks == 1);
    World once = cube_above_ground(0.0, -0.05, 0.9);
    CHECK(make_timewarp(name, {.pair_events = 1})->step(once, 0.2).events == 1);
  }
}

TEST_CASE("Bodies are apart at the time for which they are stamped", "[exact][timewarp]") {
  // A bracket has two ends; the overlapping one would be found again endlessly (T7).
  for (const char* name : kSynchronised) {
    CAPTURE(name);
    World world = line_of("0:2,1.5:0,3.4:-1");
    Looker looker(world);
    step_watched(name, world, 1.0, looker);
    CHECK(looker.collisions == 3);
    CHECK(looker.in_order);
    CHECK(looker.smallest_gap >= 0.0);
    CHECK(looker.smallest_gap < 3e-6);  // 3 m/s for a resolution

    World cube = cube_above_ground(0.0, -0.05, 0.5);
    Looker at_cube(cube);
    step_watched(name, cube, 0.2, at_cube);
    CHECK(at_cube.collisions >= 14);
    CHECK(at_cube.smallest_gap >= 0.0);
  }
}

TEST_CASE("A frame that is cut in two gives the collisions of a whole one", "[exact][timewarp]") {
  // Flights are exact, so the end of a frame has no effect (T8). Times agree to a resolution,
  // accumulated or not; cubes turn by a fixed angle, so that splitting is exact too.
  for (const char* name : {"timewarp_swept"}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(name, seed);
      World whole = world_of("cage", {{"count", "8"}}, seed);
      whole.gravity_w = Vec3(0.0, -9.81, 0.0);
      World parts = whole;
      const auto one = make_timewarp(name, {.resolution = 1e-12});
      const auto two = make_timewarp(name, {.resolution = 1e-12});
      Listener of_whole;
      Listener of_parts;
      one->observe(&of_whole);
      two->observe(&of_parts);
      const double dt = 1.0 / 30.0;
      for (int k = 0; k < 8; ++k) {
        one->step(whole, dt);
        two->step(parts, 0.3 * dt);
        two->step(parts, 0.7 * dt);
      }
      REQUIRE(of_whole.events.size() == of_parts.events.size());
      CHECK(of_whole.events.size() >= 3);
      for (std::size_t k = 0; k < of_whole.events.size(); ++k) {
        CHECK(names_of(whole, of_whole.events[k]) == names_of(parts, of_parts.events[k]));
        CHECK(of_whole.events[k].time == near(of_parts.events[k].time, 1e-9));
      }
      for (std::size_t k = 0; k < whole.states().size(); ++k)
        CHECK((whole.states()[k].position_w - parts.states()[k].position_w).norm() < 1e-9);
    }
  }
}

TEST_CASE("The timewarps refuse options that make no sense", "[unit][timewarp]") {
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    World world = line_of("0:2,1.5:0");
    CHECK_THROWS_WITH(make_timewarp(name, {.resolution = 0.0}), Contains("resolution = 0"));
    CHECK_THROWS_WITH(make_timewarp(name, {.resolution = kNan}), Contains("resolution = nan"));
    CHECK_THROWS_WITH(make_timewarp(name, {.pair_events = 0}), Contains("pair_events = 0"));
    // A resolution below the rounding of the times of a frame.
    CHECK_THROWS_WITH(make_timewarp(name, {.resolution = 1e-20})->step(world, 1.0),
                      Contains("resolution = 1e-20"));
  }
}
