/// \file
/// \brief Frames of a chatter detector, and its options.
#include "tumble/filtering/chatter_detector.hpp"

#include "support/allocation_counter.hpp"
#include "support/test.hpp"

TEST_CASE("Half as long steps show a detector the same frames", "[exact][filtering]") {
  const auto noise = [](int k) {
    Random chance = Random(2).fork(static_cast<std::uint64_t>(k));
    return Vec3(chance.uniform(0.0, 2e-3), 0.0, 0.0);
  };
  ChatterDetector whole;
  ChatterDetector halves;
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  World fine = world;
  whole.add(world, std::vector<char>{1});
  halves.add(fine, std::vector<char>{1});
  for (int k = 1; k < 50; ++k) {
    world.finish_step(kFrame);
    world.states()[0].position_w = noise(k);
    whole.add(world, std::vector<char>{1});
    for (const Vec3& place : {Vec3(9.0, 9.0, 9.0), noise(k)}) {
      fine.finish_step(0.5 * kFrame);
      fine.states()[0].position_w = place;
      halves.add(fine, std::vector<char>{1});
    }
  }
  CHECK(whole.motion(BodyId{0}) == Motion::chatters);
  CHECK(halves.motion(BodyId{0}) == Motion::chatters);
  // [m] error of the steps' time, 1e-14 s, times 1000 m/s
  CHECK(halves.history(BodyId{0})->swing == near(whole.history(BodyId{0})->swing, 1e-10));
}

TEST_CASE("Contact in any step since the frame before is contact in a frame",
          "[exact][filtering]") {
  // Four steps in a frame, one of them in contact. A frame without contact in any step would be one too many.
  for (const int touching_step : {0, 1, 2, 3, 4}) {
    ChatterDetector detector;
    World world;
    world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
    for (int step = 0; step <= 160; ++step) {
      if (step > 0) world.finish_step(0.25 * kFrame);
      world.states()[0].position_w.y() = step % 8 < 4 ? 0.0 : 2e-3;
      detector.add(world, std::vector<char>{step % 4 == touching_step ? '\1' : '\0'});
    }
    CHECK((detector.motion(BodyId{0}) == Motion::chatters) == (touching_step < 4));
  }
}

TEST_CASE("A detector sees 60 frames a second between steps of any length", "[exact][filtering]") {
  ChatterDetector detector;
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  for (const double dt : {1.0 / 210.0, 1.0 / 13.0, 1.0 / 47.0})
    for (double time = 0.0; time < 1.0; time += dt) {
      detector.add(world, std::vector<char>{1});
      world.finish_step(dt);
      world.states()[0].position_w.x() = 0.2 * world.time();
    }
  detector.add(world, std::vector<char>{1});
  const MotionHistory history = *detector.history(BodyId{0});
  CHECK(history.displacement == near(0.1, 1e-13));  // [m] half a second at 0.2 m/s; rounding
  CHECK(history.path == near(0.1, 1e-13));
}

TEST_CASE("A detector refuses options out of range", "[unit][filtering]") {
  using Change = std::function<void(ChatterDetectorOptions&)>;
  for (const Change& change :
       std::vector<Change>{[](auto& o) { o.window = 1; }, [](auto& o) { o.window = 121; },
                           [](auto& o) { o.reversals = 0; }, [](auto& o) { o.swing = 0.0; },
                           [](auto& o) { o.rest = -1.0; }, [](auto& o) { o.drift = -1.0; },
                           [](auto& o) { o.share = kNan; }, [](auto& o) { o.contact = 1.1; },
                           [](auto& o) { o.frame_rate = 0.0; }}) {
    ChatterDetectorOptions options;
    change(options);
    CHECK_THROWS_AS(ChatterDetector(options), std::invalid_argument);
  }
  ChatterDetector detector;
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  CHECK_THROWS_AS(detector.add(world, {}), std::invalid_argument);
}

TEST_CASE("A body added during a long step is classified after enough frames",
          "[exact][filtering]") {
  // Steps of a second contain twice the frames of a window, but not for a body added at their end.
  ChatterDetector detector;
  World world;
  const BodyProperties box = box_properties(Vec3::Ones(), 1.0);
  const BodyId first = world.add(box, BodyState{});
  detector.add(world, std::vector<char>{1});
  world.finish_step(1.0);
  const BodyId late = world.add(box, BodyState{});
  detector.add(world, std::vector<char>{1, 1});
  CHECK(detector.motion(first) == Motion::rests);
  CHECK(detector.motion(late) == Motion::moves);
  world.finish_step(29.0 * kFrame);
  detector.add(world, std::vector<char>{1, 1});
  CHECK(detector.motion(late) == Motion::moves);  // 30 frames, its first one included
  world.finish_step(kFrame);
  detector.add(world, std::vector<char>{1, 1});
  CHECK(detector.motion(late) == Motion::rests);
}

TEST_CASE("A detector that knows its bodies allocates nothing", "[exact][filtering]") {
  ChatterDetector detector;
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  const std::vector<char> touches = {1};
  for (int k = 0; k < 40; ++k) {
    world.states()[0].position_w.x() = k % 2 == 0 ? 0.0 : 2e-3;
    detector.add(world, touches);
    world.finish_step(kFrame);
  }
  const AllocationCount allocations;
  detector.add(world, touches);
  const Motion told = detector.motion(BodyId{0});
  CHECK(allocations.value() == 0);
  CHECK(told == Motion::chatters);
}

TEST_CASE("Frames later than a double can count are not shown", "[unit][filtering]") {
  DisplayFrames frames(60.0, 31);
  frames.advance(0.0);
  CHECK(frames.end() == 1);
  frames.advance(1e20);  // its number of frames is beyond a 64-bit integer
  CHECK(frames.end() - frames.first() == 31);
  frames.advance(2e20);
  CHECK(frames.first() == frames.end());
}
