/// \file
/// \brief Classification of motion from earlier frames, for motions of known class.
#include "tumble/filtering/chatter_detector.hpp"

#include "tumble/filtering/tolerances.hpp"

#include "support/test.hpp"

namespace {

constexpr double kPi = std::numbers::pi;

using Pose = std::function<BodyState(int frame)>;

BodyState shifted(const Vec3& way_w) { return BodyState{.position_w = way_w}; }

BodyState turned(const Vec3& angle_w) {
  return BodyState{.orientation_wb = rotation_from_vector(angle_w)};
}

// A film of one box, frame by frame.
struct Film {
  Vec3 size = Vec3::Ones();
  ChatterDetectorOptions options = {};
  double frame = kFrame;  // [s]
  double contact = 1.0;   // share of the frames
  int frames = 40;
  Vec3 gravity_w = Vec3(0.0, -9.81, 0.0);

  [[nodiscard]] ChatterDetector shown(const Pose& pose) const {
    ChatterDetector detector(options);
    World world;
    world.gravity_w = gravity_w;
    world.add(box_properties(size, 1.0), pose(0));
    for (int k = 0; k < frames; ++k) {
      if (k > 0) world.finish_step(frame);
      world.states()[0] = pose(k);
      const bool touches = std::floor((k + 1) * contact) > std::floor(k * contact);
      detector.add(world, std::vector<char>{touches ? '\1' : '\0'});
    }
    return detector;
  }
  [[nodiscard]] Motion classified(const Pose& pose) const { return shown(pose).motion(BodyId{0}); }
};

Motion classified(const Pose& pose) { return Film().classified(pose); }

}  // namespace

TEST_CASE("Chatter is detected at every frequency from a tenth of a cycle per frame on",
          "[exact][filtering]") {
  Random chance(7);
  for (double f = 0.1; f <= 0.5; f += 0.004)
    for (const double swing : {4e-4, 2e-3, 8e-3}) {
      if (2.0 * f * swing > 0.9 * tolerance::chatter_speed * std::sqrt(9.81) * kFrame) continue;
      const double phase = f > 0.49 ? 0.5 * kPi : chance.uniform(0.0, 2.0 * kPi);
      const Vec3 along = Vec3(chance.unit(), chance.unit(), chance.unit()).normalized();
      const auto wave = [&](int k) {
        return 0.5 * swing * elementary::sin(2.0 * kPi * f * k + phase);
      };
      INFO("f = " << f << ", swing = " << swing);
      CHECK(classified([&](int k) { return shifted(wave(k) * along); }) == Motion::chatters);
      CHECK(classified([&](int k) { return turned(wave(k) * along); }) == Motion::chatters);
    }
}

TEST_CASE(
    "Noise with a slow drift and bursts of noise are classified as chatter, a faster drift is not",
    "[unit][filtering]") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto noise = [&](int k) {
      Random chance = Random(seed).fork(static_cast<std::uint64_t>(k));
      return Vec3(chance.uniform(-1e-3, 1e-3), chance.uniform(-1e-3, 1e-3), 0.0);
    };
    const auto drifting = [&](double speed) {
      return
          [&noise, speed](int k) { return shifted(noise(k) + Vec3(0.0, 0.0, speed * kFrame * k)); };
    };
    CHECK(classified(drifting(0.005)) == Motion::chatters);
    CHECK(classified(drifting(0.02)) == Motion::moves);
    // A creep of 5 mm/s that trembles by a tenth of it, and shaking at three times gravity.
    CHECK(classified([&](int k) { return shifted(0.1 * noise(k) + Vec3(0.0, 0.0, 8e-5 * k)); }) ==
          Motion::moves);
    CHECK(classified([&](int k) { return shifted(9.0 * noise(k)); }) == Motion::moves);
    // Eight frames of noise, then eight at rest.
    CHECK(classified([&](int k) { return shifted(k / 8 % 2 == 0 ? noise(k) : Vec3::Zero()); }) ==
          Motion::chatters);
  }
}

TEST_CASE("A sliding body is never classified as chattering, at any speed and deceleration",
          "[exact][filtering]") {
  for (const double speed : {1e-3, 5e-3, 0.02, 0.05, 0.1, 0.3, 3.0, 100.0})
    for (const double friction : {0.0, 1e-3, 0.1, 0.5})
      for (const double heading : {0.0, 0.4, 2.0}) {
        const Vec3 along(elementary::cos(heading), 0.0, elementary::sin(heading));
        const double stop = friction > 0.0 ? speed / (9.81 * friction) : 1e9;  // [s]
        const auto way = [&](int k) {
          const double t = std::min(k * kFrame, stop);
          return shifted((speed - 0.5 * 9.81 * friction * t) * t * along);
        };
        INFO("speed " << speed << ", friction " << friction);
        CHECK(classified(way) != Motion::chatters);
        if (friction == 0.0) CHECK(classified(way) == Motion::moves);
      }
}

TEST_CASE("A body that turns, rocks, falls, is thrown or bounces is classified as moving",
          "[unit][filtering]") {
  for (const double spin : {0.01, 0.1, 1.0, 10.0, 40.0}) {
    CHECK(classified([&](int k) { return turned(Vec3(0.0, spin * kFrame * k, 0.0)); }) ==
          Motion::moves);
    CHECK(classified([&](int k) { return turned(Vec3(spin * kFrame * k, 0.0, 0.0)); }) ==
          Motion::moves);
  }
  // A rocking block: parabolas of its angle, to and fro, each lower than the one before. Each must
  // take more than a quarter of a second: three reversals within half a second are chatter.
  for (const double duration : {0.255, 0.3, 0.4, 0.6}) {
    const auto rocks = [&](int k) {
      const double half = std::floor(k * kFrame / duration);
      const double time = k * kFrame - half * duration;
      const double top =
          0.1 * elementary::pow(0.9, half) * (std::fmod(half, 2.0) < 1.0 ? 1.0 : -1.0);
      return turned(Vec3(0.0, 0.0, top * 4.0 * time * (duration - time) / (duration * duration)));
    };
    for (int frames = 31; frames < 80; ++frames) {
      Film film;
      film.frames = frames;
      film.options.speed = 1.0;  // so that its speed does not decide
      INFO("duration " << duration << ", frame " << frames);
      CHECK(film.classified(rocks) == Motion::moves);
    }
  }
  const auto thrown = [](double speed) {
    return [speed](int k) {
      return shifted(Vec3(0.0, speed * kFrame * k - 0.5 * 9.81 * kFrame * k * kFrame * k, 0.0));
    };
  };
  for (const double speed : {-1.0, 0.0, 2.0, 0.5 * 9.81 * 30.0 * kFrame, 8.0})
    CHECK(classified(thrown(speed)) == Motion::moves);
  CHECK(classified([](int k) {  // hops of a third of a second
          const double t = (k % 20) * kFrame;
          return shifted(Vec3(0.0, 0.5 * 9.81 * t * (20.0 * kFrame - t), 0.0));
        }) == Motion::moves);
}

TEST_CASE("A still body is classified as resting, a creeping one as moving", "[exact][filtering]") {
  CHECK(classified([](int) { return shifted(Vec3(1.0, 2.0, 3.0)); }) == Motion::rests);
  // A creep by `rest` within the window is the limit.
  const auto creep = [](double share) {
    const double step = share * tolerance::rest_excursion / 30.0;
    return [step](int k) { return shifted(Vec3(step * k, 0.0, 0.0)); };
  };
  CHECK(classified(creep(0.99)) == Motion::rests);
  CHECK(classified(creep(1.01)) == Motion::moves);
  // A creep that trembles is chatter if its swing is at least `swing`.
  const auto trembles = [&](double share) {
    return [&creep, share](int k) {
      BodyState state = creep(1.5)(k);
      state.position_w.y() += k % 2 == 0 ? 0.0 : share * tolerance::chatter_swing;
      return state;
    };
  };
  CHECK(classified(trembles(0.95)) == Motion::moves);
  CHECK(classified(trembles(1.05)) == Motion::chatters);
}

TEST_CASE("Chatter needs contact, gravity, enough frames and numbers", "[unit][filtering]") {
  const auto chatter = [](int k) { return shifted(Vec3(0.0, k % 2 == 0 ? 0.0 : 2e-3, 0.0)); };
  Film film;
  CHECK(film.classified(chatter) == Motion::chatters);
  film.contact = 0.55;
  CHECK(film.classified(chatter) == Motion::chatters);
  film.contact = 0.45;
  CHECK(film.classified(chatter) == Motion::moves);
  film = Film();
  film.gravity_w.setZero();
  CHECK(film.classified(chatter) == Motion::moves);
  film = Film();
  film.frames = 31;
  CHECK(film.classified(chatter) == Motion::chatters);
  film.frames = 30;
  CHECK(film.classified(chatter) == Motion::moves);
  CHECK_FALSE(film.shown(chatter).history(BodyId{0}).has_value());
  CHECK(Film().shown(chatter).motion(BodyId{7}) == Motion::moves);
  CHECK(classified([&](int k) {
          BodyState state = chatter(k);
          if (k == 35) state.position_w.y() = kNan;
          return state;
        }) == Motion::moves);
  for (const double bad : {kNan, kInfinity})
    CHECK(classified([&](int k) { return shifted(Vec3(0.0, k < 20 ? 0.0 : bad, 0.0)); }) ==
          Motion::moves);
}

TEST_CASE("A rotated, larger and slower film is classified with the same thresholds",
          "[exact][filtering]") {
  const auto noisy = [](double length, double yaw) {
    return [length, yaw](int k) {
      Random chance = Random(11).fork(static_cast<std::uint64_t>(k));
      const Quat turn = rotation_from_vector(Vec3(0.0, yaw, 0.0));
      BodyState state;
      state.position_w = turn * (length * Vec3(chance.uniform(-1e-3, 1e-3), 2e-4 * k,
                                               chance.uniform(-2e-3, 2e-3)));
      state.orientation_wb = turn * rotation_from_vector(Vec3(1e-3 * chance.unit(), 0.0, 0.0));
      return state;
    };
  };
  const ChatterDetector one = Film().shown(noisy(1.0, 0.0));
  const MotionHistory expected = *one.history(BodyId{0});
  REQUIRE(one.swing_ratio(BodyId{0}) > 0.0);
  for (const double scale : {0.01, 1.0, 100.0})
    for (const double yaw : {0.0, 0.7, 2.9}) {
      Film film;
      film.size = Vec3::Constant(scale);
      film.frame = kFrame * std::sqrt(scale);
      film.options.frame_rate = 60.0 / std::sqrt(scale);
      const ChatterDetector other = film.shown(noisy(scale, yaw));
      const MotionHistory history = *other.history(BodyId{0});
      const double margin = 1e-12;  // [-] rounding; measured 1e-14
      CHECK(history.path / scale == near(expected.path, margin));
      CHECK(history.drift / scale == near(expected.drift, margin));
      CHECK(history.swing / scale == near(expected.swing, margin));
      CHECK(other.motion(BodyId{0}) == one.motion(BodyId{0}));
    }
}

TEST_CASE("The classification of a body does not depend on other bodies that come and go",
          "[exact][filtering]") {
  const auto chatter = [](int k) { return shifted(Vec3(0.0, k % 3 == 0 ? 0.0 : 2e-3, 0.1)); };
  const ChatterDetector alone = Film().shown(chatter);
  ChatterDetector detector;
  World world;
  const BodyProperties box = box_properties(Vec3::Ones(), 1.0);
  const BodyId first = world.add(box, shifted(Vec3(9.0, 0.0, 0.0)));
  const BodyId body = world.add(box, chatter(0));
  BodyId late{};
  for (int k = 0; k < 40; ++k) {
    if (k > 0) world.finish_step(kFrame);
    if (k == 12) world.remove(first);
    if (k == 20) late = world.add(box, chatter(0));
    world.states()[static_cast<std::size_t>(world.index_of(body))] = chatter(k);
    if (k >= 20) world.states().back() = chatter(k);
    detector.add(world, std::vector<char>(world.states().size(), 1));
  }
  CHECK(detector.motion(body) == Motion::chatters);
  CHECK(detector.history(body)->swing == alone.history(BodyId{0})->swing);
  CHECK(detector.history(body)->drift == alone.history(BodyId{0})->drift);
  CHECK(detector.motion(late) == Motion::moves);  // 20 frames are too few
  CHECK(detector.motion(first) == Motion::moves);
}
