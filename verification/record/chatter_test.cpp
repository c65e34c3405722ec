/// \file
/// \brief The measure of chatter against paths made by hand.
#include "tumble/record/chatter.hpp"

#include "support/test.hpp"

namespace {

// A unit cube led along a path by hand, always in contact unless a test says otherwise.
struct Led {
  std::function<BodyState(double)> path;  // state at a time [s]
  std::function<bool(double)> touches = [](double) { return true; };

  Chatter measured(double dt, double duration) const {
    World world;
    const BodyId id = world.add(box_properties(Vec3::Ones(), 1.0), path(0.0));
    ChatterMeter meter;
    const auto add = [&](double time) {
      world.set_state(id, path(time));
      meter.add(world, std::vector<char>{static_cast<char>(touches(time) ? 1 : 0)});
    };
    add(0.0);
    const int steps = static_cast<int>(std::lround(duration / dt));
    for (int k = 1; k <= steps; ++k) {
      world.finish_step(dt);
      add(k * dt);
    }
    return meter.measure(kGravity);
  }
};

BodyState at(const Vec3& position_w, const Quat& orientation_wb = Quat::Identity()) {
  return BodyState{.position_w = position_w, .orientation_wb = orientation_wb};
}

}  // namespace

TEST_CASE("Chatter of a cube that swings by a known amount is the same at any step",
          "[exact][record][chatter]") {
  // x = A sin(2 pi f t) along a direction; with f = 7.5 Hz a period has 8 frames. Its second
  // difference from frame to frame is -4 sin²(pi f / 60) x, and the mean of the squares of 29 of them
  // in a row is one half exactly.
  const double amplitude = 1e-4;  // [m]
  const double second = 4.0 * amplitude * std::pow(std::sin(M_PI / 8.0), 2);
  for (const Vec3& along : {Vec3(0.0, 1.0, 0.0), Vec3(Vec3::Ones() / std::sqrt(3.0))}) {
    const Led swing{
        .path = [&](double t) { return at(amplitude * std::sin(2.0 * M_PI * 7.5 * t) * along); }};
    for (const double dt : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
      INFO("step " << dt);
      const Chatter chatter = swing.measured(dt, 1.0);
      CHECK(chatter.bodies == 1);
      // Corners are rounded at 1e-16 m, 1e-12 of the amplitude; frame times at 1e-15 s. Measured: 3e-12.
      CHECK(chatter.amplitude == near(2.0 * amplitude).epsilon(1e-10));
      CHECK(chatter.acceleration ==
            near(second / std::sqrt(2.0) * 3600.0 / kGravity).epsilon(1e-10));
    }
  }
}

TEST_CASE("A step that fits no display frame is interpolated to frames",
          "[exact][record][chatter]") {
  // At every step of 1/90 s the cube is at 0 or at A in turn; frames, one and a half steps apart, see
  // 0, A/2, A, A/2, 0, ... with the second differences A, 0, -A, 0.
  const double a = 1e-3;  // [m]
  const Led zigzag{.path = [&](double t) {
    return at(Vec3(0.0, std::lround(t * 90.0) % 2 == 0 ? 0.0 : a, 0.0));
  }};
  const Chatter chatter = zigzag.measured(1.0 / 90.0, 1.0);
  CHECK(chatter.bodies == 1);
  CHECK(chatter.amplitude == near(a).epsilon(1e-9));
  const double rms = a * std::sqrt(14.0 / 29.0);  // even frames from 31 to 59
  CHECK(chatter.acceleration == near(rms * 3600.0 / kGravity).epsilon(1e-9));
}

TEST_CASE("A cube that turns to and fro has the chord of its corners for an amplitude",
          "[exact][record][chatter]") {
  // About z by an angle: each corner goes along a chord 2 r sin(angle / 2), r² = 1/2, and back; the
  // second difference is twice the chord on every frame.
  const double angle = 0.01;  // [deg]
  const Quat turned = rotation_from_degrees(Vec3(0.0, 0.0, angle));
  const Led turning{.path = [&](double t) {
    return at(Vec3::Zero(), std::lround(t * 60.0) % 2 == 0 ? Quat::Identity() : turned);
  }};
  const Chatter chatter = turning.measured(1.0 / 60.0, 0.5);
  const double chord = 2.0 * std::sqrt(0.5) * std::sin(0.5 * angle * M_PI / 180.0);
  CHECK(chatter.bodies == 1);
  CHECK(chatter.amplitude == near(chord).epsilon(1e-10));
  CHECK(chatter.acceleration == near(2.0 * chord * 3600.0 / kGravity).epsilon(1e-10));
}

TEST_CASE("A hop under gravity has the acceleration 1", "[exact][record][chatter]") {
  // Up and back in just the window: y = g t (T - t) / 2, T = 0.5 s, with g T² / 8 for its height.
  const Led hop{
      .path = [](double t) { return at(Vec3(0.0, 0.5 * kGravity * t * (0.5 - t), 0.0)); }};
  const Chatter chatter = hop.measured(1.0 / 60.0, 0.5);
  CHECK(chatter.bodies == 1);
  CHECK(chatter.amplitude == near(kGravity * 0.25 / 8.0).epsilon(1e-12));
  CHECK(chatter.acceleration == near(1.0).epsilon(1e-12));
}

TEST_CASE("A body that slides, loses contact on a frame or is seen too short does not count",
          "[unit][record][chatter]") {
  const auto still = [](double) { return at(Vec3::Zero()); };
  // Net movement in half a second: 9.9 mm of a cube of 1 m rests, 10.1 mm does not.
  const auto slide = [](double speed) {
    return Led{.path = [speed](double t) { return at(Vec3(speed * t, 0.0, 0.0)); }};
  };
  CHECK(slide(0.0198).measured(1.0 / 60.0, 1.0).bodies == 1);
  CHECK(slide(0.0202).measured(1.0 / 60.0, 1.0).bodies == 0);
  // Contact is asked for on frames: one that is lost for a step between two frames is not seen.
  const auto lets_go = [&](double when) {
    return Led{.path = still, .touches = [when](double t) { return std::abs(t - when) > 1e-4; }};
  };
  CHECK(lets_go(0.75).measured(1.0 / 240.0, 1.0).bodies == 0);
  CHECK(lets_go(0.75 + 1.0 / 240.0).measured(1.0 / 240.0, 1.0).bodies == 1);
  CHECK(lets_go(0.45).measured(1.0 / 240.0, 1.0).bodies == 1);  // before the window
  CHECK(Led{.path = still}.measured(1.0 / 60.0, 0.5).bodies == 1);
  CHECK(Led{.path = still}.measured(1.0 / 60.0, 29.0 / 60.0).bodies == 0);
}

TEST_CASE("Bodies that come and go are measured once they have been seen for half a second",
          "[unit][record][chatter]") {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add_ground();
  const BodyId first = world.add(cube, at(Vec3(0.0, 0.5, 0.0)));
  ChatterMeter meter;
  const auto step = [&] {
    world.finish_step(1.0 / 60.0);
    meter.add(world, std::vector<char>(static_cast<std::size_t>(world.count()), 1));
    return meter.measure(kGravity).bodies;
  };
  meter.add(world, std::vector<char>(2, 1));
  int bodies = 0;
  for (int k = 0; k < 30; ++k) bodies = step();
  CHECK(bodies == 1);
  world.add(cube, at(Vec3(3.0, 0.5, 0.0)));
  for (int k = 0; k < 31; ++k) bodies = step();  // seen first in the step after, then 30 frames
  CHECK(bodies == 1);
  CHECK(step() == 2);
  world.remove(first);
  CHECK(step() == 1);
}

TEST_CASE("Each body that rests is reported with its own chatter", "[exact][record][chatter]") {
  // In turn: one that is fixed, one to and fro in every frame by a, one that slides, one to and fro in
  // four frames by 3 a, one that loses contact, one that is still.
  const double a = 1e-4;  // [m]
  World world = ground_world();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(fixed_box_properties(Vec3::Ones()), at(Vec3(-3.0, 0.5, 0.0)));
  std::vector<BodyId> ids;
  for (int k = 0; k < 5; ++k) ids.push_back(world.add(cube, at(Vec3(3.0 * k, 0.5, 0.0))));
  ChatterMeter meter;
  std::vector<char> touches(static_cast<std::size_t>(world.count()), 1);
  const auto add = [&](int step) {
    const auto lead = [&](std::size_t k, double y) {
      world.set_state(ids[k], at(Vec3(3.0 * static_cast<double>(k), 0.5 + y, 0.0)));
    };
    lead(0, step % 2 == 0 ? 0.0 : a);
    lead(1, 0.03 * step / 60.0);
    lead(2, step / 2 % 2 == 0 ? 0.0 : 3.0 * a);
    touches[5] = step == 20 ? 0 : 1;
    meter.add(world, touches);
  };
  add(0);
  CHECK(meter.each(kGravity).empty());
  for (int step = 1; step <= 30; ++step) {
    world.finish_step(1.0 / 60.0);
    add(step);
  }
  const std::vector<BodyChatter> each = meter.each(kGravity);
  REQUIRE(each.size() == 3);
  CHECK(each[0].id == ids[0]);
  CHECK(each[1].id == ids[2]);
  CHECK(each[2].id == ids[4]);
  // Corners are rounded at 1e-16 m, 1e-12 of the amplitude; measured: 2e-12.
  const double unit = 3600.0 / kGravity;
  CHECK(each[0].amplitude == near(a).epsilon(1e-10));
  CHECK(each[0].acceleration == near(2.0 * a * unit).epsilon(1e-10));
  CHECK(each[1].amplitude == near(3.0 * a).epsilon(1e-10));
  // Of 0 0 1 1 0 0 ... every second difference is one of 3 a: 29 of 29.
  CHECK(each[1].acceleration == near(3.0 * a * unit).epsilon(1e-10));
  CHECK(each[2].amplitude == 0.0);
  CHECK(each[2].acceleration == 0.0);

  // The worst of all, each measure by itself.
  const Chatter worst = meter.measure(kGravity);
  CHECK(worst.bodies == 3);
  CHECK(worst.amplitude == each[1].amplitude);
  CHECK(worst.acceleration == each[1].acceleration);
}

TEST_CASE("Of many bodies every other one may leave at once, and the others are measured on",
          "[unit][record][chatter]") {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < 200; ++k) world.add(cube, at(Vec3(2.0 * k, 0.0, 0.0)));
  const std::vector<BodyId> ids(world.ids().begin(), world.ids().end());
  ChatterMeter meter;
  const auto go = [&](int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      meter.add(world, std::vector<char>(world.states().size(), 1));
      world.finish_step(1.0 / 60.0);
    }
  };
  go(20);
  for (std::size_t k = 0; k < ids.size(); k += 2) world.remove(ids[k]);
  go(11);
  const std::vector<BodyChatter> each = meter.each(kGravity);
  REQUIRE(each.size() == 100);
  for (std::size_t k = 0; k < each.size(); ++k) CHECK(each[k].id == ids[2 * k + 1]);
}

TEST_CASE("One step over many frames fills the window with them", "[unit][record][chatter]") {
  const Led still{.path = [](double) { return at(Vec3::Zero()); }};
  CHECK(still.measured(1000.0, 1000.0).bodies == 1);
}
