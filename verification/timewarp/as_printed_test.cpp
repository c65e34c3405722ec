/// \file
/// \brief The two printed listings of the timewarp: the effect of each misprint, and that nothing else is
///        wrong with them.
#include "tumble/base/random.hpp"
#include "tumble/techniques.hpp"
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "support/catch.hpp"
#include "timewarp/cases.hpp"

#include <cmath>
#include <stdexcept>

namespace {

using namespace tumble;
using namespace tumble::test;

constexpr auto kSimple = TimewarpListing::simple;
constexpr auto kSafer = TimewarpListing::safer;
// [-] Times and positions on a line are accurate to a few times the resolution of 1e-6 s.
constexpr double kFound = 1e-5;

// Only the thesis's choices are left as printed.
TimewarpErrata misprints() { return TimewarpErrata::all().without("T5").without("T9"); }

TimewarpErrata but(std::initializer_list<const char*> ids, TimewarpErrata set = misprints()) {
  for (const char* id : ids) set = set.without(id);
  return set;
}

TimewarpAsPrintedOptions printed(const TimewarpErrata& repaired, TimewarpListing listing = kSimple,
                                 int cap = 50, bool collide_separating = false) {
  TimewarpAsPrintedOptions options;
  options.listing = listing;
  options.repaired = repaired;
  options.cap = cap;
  options.collide_separating = collide_separating;
  return options;
}

// One frame and the state after it.
struct Frame {
  Frame(const World& start, const TimewarpAsPrintedOptions& options, double dt = 1.0)
      : world(start), technique(options) {
    technique.observe(&told);
    report = technique.step(world, dt);
  }

  [[nodiscard]] double x(std::size_t body) const {  // before overlap is repaired
    return technique.test_states()[body].position_w.x();
  }
  [[nodiscard]] double v(std::size_t body) const {
    return velocity(world.bodies()[body], technique.test_states()[body]).x();
  }
  [[nodiscard]] double valid_time(std::size_t body) const { return technique.valid_times()[body]; }
  [[nodiscard]] std::size_t events() const { return told.events.size(); }
  [[nodiscard]] bool capped() const { return report.status == StepStatus::event_cap; }

  World world;
  TimewarpAsPrinted technique;
  Listener told;
  StepReport report;
};

// Two cubes fly over one another, and two others would collide beneath them while they overlap.
World crossing() {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  const auto add = [&](double x, double y, double v) {
    world.add(cube, make_state(cube, Vec3(x, y, 0.0), Quat::Identity(), Vec3(v, 0.0, 0.0)));
  };
  add(0.0, 0.0, 2.0);
  add(1.5, 0.0, 0.0);
  add(-0.5, 1.3, 4.0);
  add(1.0, 1.3, -4.0);
  return world;
}

World ball_above_ground(double height, double speed_down) {
  World world;
  world.add_ground(0.0, 0.5);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 0.5);
  world.add(cube, make_state(cube, Vec3(0.0, 0.5 + height, 0.0), Quat::Identity(),
                             Vec3(0.0, -speed_down, 0.0)));
  return world;
}

// Compares a run with another one, bit by bit.
void check_same(World world, Technique& one, Technique& other, double dt, int steps) {
  World twin = world;
  Listener told;
  Listener told_too;
  one.observe(&told);
  other.observe(&told_too);
  for (int k = 0; k < steps; ++k) {
    const StepReport a = one.step(world, dt);
    const StepReport b = other.step(twin, dt);
    REQUIRE(a.status == b.status);
    REQUIRE(a.rewinds == b.rewinds);
    REQUIRE(a.restarts == b.restarts);
    REQUIRE(a.fallbacks == b.fallbacks);
    REQUIRE(world.hash().value() == twin.hash().value());
  }
  REQUIRE(told.events.size() == told_too.events.size());
  for (std::size_t k = 0; k < told.events.size(); ++k) {
    REQUIRE(told.events[k].time == told_too.events[k].time);
    REQUIRE(told.events[k].first == told_too.events[k].first);
    REQUIRE(told.events[k].second == told_too.events[k].second);
    REQUIRE(told.events[k].impulse_w == told_too.events[k].impulse_w);
    REQUIRE(told.events[k].rewinds == told_too.events[k].rewinds);
  }
}

World cage(std::uint64_t seed) {
  return world_of("cage", {{"count", "8"}, {"speed", "6"}, {"spin", "6"}}, seed);
}

World row(std::uint64_t seed) {
  Random random(seed);
  std::string boxes;
  for (int k = 0; k < 6; ++k)
    boxes += (k > 0 ? "," : "") + std::to_string(1.6 * k + random.uniform(0.0, 0.5)) + ":" +
             std::to_string(random.uniform(-2.0, 2.0));
  return line_of(boxes.c_str(), seed % 2 == 0 ? "1" : "0.4");
}

World pile(std::uint64_t seed) {
  Random random(seed);
  World world;
  world.add_ground(0.3, 0.3);
  for (int k = 0; k < 4; ++k) {
    const BodyProperties cube = box_properties(Vec3::Constant(0.2), 1.0, 0.3, 0.3);
    world.add(cube, make_state(cube, Vec3(0.1 * random.uniform(-1.0, 1.0), 0.15 + 0.3 * k, 0.0),
                               Quat::Identity(), Vec3(0.0, -1.0, 0.0),
                               Vec3(0.0, 0.0, random.uniform(-3.0, 3.0))));
  }
  return world;
}

}  // namespace

TEST_CASE("There are 19 errata of the timewarp", "[unit][timewarp]") {
  CHECK(TimewarpErrata::known().size() == 19);  // 10 + 9
  CHECK(TimewarpErrata::known().front() == "T1");
  CHECK(TimewarpErrata::known().back() == "F9");
  CHECK_THROWS_AS(TimewarpErrata("C1"), std::invalid_argument);
}

TEST_CASE(
    "With all misprints mended the printed timewarps give the collisions of the forms as meant to "
    "the last bit",
    "[reference][timewarp]") {
  for (const TimewarpListing listing : {kSimple, kSafer}) {
    const char* name = listing == kSimple ? "timewarp_simple" : "timewarp_safer";
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      INFO(name << ", seed " << seed);
      const auto compare = [&](const World& world, double dt, int steps) {
        TimewarpAsPrinted as_printed(printed(misprints(), listing, 100000));
        check_same(world, as_printed, *make_timewarp(name), dt, steps);
      };
      compare(row(seed), 0.3, 10);
      compare(cage(seed), 1.0 / 30.0, 60);
      compare(pile(seed), 1.0 / 60.0, 30);
    }
    TimewarpAsPrinted as_printed(printed(misprints(), listing));
    check_same(crossing(), as_printed, *make_timewarp(name), 1.0, 1);
  }
}

TEST_CASE(
    "With all errata mended the simple listing is the timewarp with swept volumes, bit by bit",
    "[reference][timewarp]") {
  const TimewarpErrata all = TimewarpErrata::all();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    const auto compare = [&](const World& world, double dt, int steps) {
      TimewarpAsPrinted as_printed(printed(all, kSimple, 100000));
      check_same(world, as_printed, *make_timewarp("timewarp_swept"), dt, steps);
    };
    compare(row(seed), 0.3, 10);
    compare(cage(seed), 1.0 / 30.0, 60);
    compare(pile(seed), 1.0 / 60.0, 30);
  }
  // Cubes in a row that are hit from both sides simultaneously collide together.
  TimewarpAsPrinted as_printed(printed(all, kSimple, 100000));
  check_same(line_of("0:1,1.5:0,2.5:0,4:-1"), as_printed, *make_timewarp("timewarp_swept"), 1.0, 1);
}

TEST_CASE("The timewarp as printed ends every step with finite numbers, whatever is mended",
          "[unit][timewarp]") {
  std::vector<TimewarpErrata> sets{TimewarpErrata(), TimewarpErrata::all(), misprints()};
  for (const std::string& id : TimewarpErrata::known()) {
    sets.push_back(TimewarpErrata().with(id));
    sets.push_back(misprints().without(id));
  }
  Random random(7);
  for (int k = 0; k < 40; ++k) {
    TimewarpErrata set;
    for (const std::string& id : TimewarpErrata::known())
      if (random.uniform(0.0, 1.0) < 0.5) set = set.with(id);
    sets.push_back(set);
  }
  std::uint64_t seed = 0;
  for (const TimewarpErrata& set : sets) {
    ++seed;
    for (const TimewarpListing listing : {kSimple, kSafer}) {
      for (World world : {cage(seed), row(seed), pile(seed)}) {
        INFO(set.text() << (listing == kSimple ? ", simple" : ", safer"));
        TimewarpAsPrinted technique(printed(set, listing, 40, seed % 2 == 0));
        for (int step = 0; step < 6; ++step) {
          const StepReport report = technique.step(world, 1.0 / 20.0);
          const bool ended =
              report.status == StepStatus::done || report.status == StepStatus::event_cap;
          CHECK(ended);
          CHECK(technique.passes() <= 40);
          CHECK(std::isfinite(report.energy.total()));
          for (const BodyState& state : world.states())
            CHECK((state.position_w.allFinite() && state.linear_momentum_w.allFinite()));
        }
        CHECK(std::abs(world.time() - 0.3) < 1e-15);  // [s] rounding of six additions
      }
    }
  }
}

TEST_CASE("T1: a body that collides before it is there is half a metre ahead at the end",
          "[exact][timewarp]") {
  // At 0.5 s the first cube has reached the collision, the second one is still at its start; it
  // is pushed there, and then flies on for the half second that it should have flown before.
  const World world = line_of("0:1,2:-1");
  const Frame ignored(world, printed(but({"T1"})));
  CHECK(ignored.x(0) == near(0.0).margin(kFound));
  CHECK(ignored.x(1) == near(3.0).margin(kFound));
  CHECK(ignored.v(1) == near(1.0).margin(1e-15));
  const Frame mended(world, printed(misprints()));
  CHECK(mended.x(1) == near(2.0).margin(kFound));

  // If the pair is bounced whether it approaches or not, the second impulse undoes the first. In 0.9 s,
  // as at 1 s the two touch, and rounding decides whether that is one more collision.
  const Frame bounced(world, printed(but({"T1"}), kSimple, 50, true), 0.9);
  CHECK(bounced.events() == 2);
  CHECK(bounced.x(0) == near(0.9).margin(kFound));
  CHECK(bounced.x(1) == near(2.1).margin(kFound));
  CHECK(bounced.v(0) == near(1.0).margin(1e-12));
  CHECK(bounced.v(1) == near(-1.0).margin(1e-12));
}

TEST_CASE("T2: with one counter for both loops the second body never comes to the collision",
          "[exact][timewarp]") {
  const Frame shared(line_of("0:1,2:-1"), printed(but({"T1", "T2"})));
  CHECK(shared.x(1) == near(2.5).margin(kFound));
  CHECK(shared.valid_time(0) == near(0.5).margin(kFound));
  CHECK(shared.valid_time(1) == 0.0);
  // It has an effect only in nested loops.
  CHECK(Frame(line_of("0:1,2:-1"), printed(but({"T2"}))).x(1) == near(2.0).margin(kFound));

  // Tested against one another's old test states, and without a contact stage, the two of an
  // inelastic collision collide endlessly at the end of the frame, where the second one is not.
  const World world = line_of("0:2,1.5:0", "0.5");
  for (const bool separating : {false, true}) {
    const Frame endless(world, printed(but({"T1", "T2", "T3", "T6"}), kSimple, 50, separating));
    CHECK(endless.capped());
    CHECK(endless.technique.passes() == 50);
    CHECK(endless.valid_time(0) == near(1.0).margin(kFound));
    CHECK(endless.valid_time(1) == 0.0);
  }
  CHECK_FALSE(Frame(world, printed(but({"T1", "T3", "T6"}))).capped());
}

TEST_CASE("T3: a test against the other's old state is one more collision, at the end of the frame",
          "[exact][timewarp]") {
  const World world = line_of("0:2,1.5:0", "0.5");
  for (const TimewarpListing listing : {kSimple, kSafer}) {
    const Frame ignored(world, printed(but({"T3"}), listing));
    CHECK(ignored.technique.passes() == 2);
    CHECK(ignored.events() == 1);
    CHECK(ignored.v(0) == near(0.5).margin(1e-15));
    CHECK(ignored.v(1) == near(1.5).margin(1e-15));
    for (const std::size_t body : {0u, 1u})
      CHECK(ignored.valid_time(body) == near(1.0).margin(kFound));

    const Frame bounced(world, printed(but({"T3"}), listing, 50, true));
    CHECK(bounced.events() == 2);
    CHECK(bounced.told.events.back().time == near(1.0).margin(kFound));
    CHECK(bounced.v(0) == near(1.25).margin(1e-12));
    CHECK(bounced.v(1) == near(0.75).margin(1e-12));

    const Frame mended(world, printed(misprints(), listing, 50, true));
    CHECK(mended.technique.passes() == 1);
    CHECK(mended.v(0) == near(0.5).margin(1e-15));
    for (const std::size_t body : {0u, 1u})
      CHECK(mended.valid_time(body) == near(0.25).margin(kFound));
  }
  // A search that does not use test states is not affected.
  const Frame swept(world, printed(but({"T3"}, TimewarpErrata::all())));
  CHECK(swept.technique.passes() == 1);
}

TEST_CASE("T4: without valid times a search takes states of different times for those of one",
          "[exact][timewarp]") {
  // After 0.25 s the middle cube is at its old place, and as fast as the first one was. Taken for its
  // state at the start it collides with the third one after 0.9 m / 3 m/s, which is 0.3 s; then follows
  // the first one at 0.3 m / 3 s ...
  const World world = line_of("0:2,1.5:0,3.4:-1");
  const auto check = [](const Frame& frame, std::initializer_list<double> times,
                        std::initializer_list<double> places) {
    REQUIRE(frame.events() == times.size());
    auto time = times.begin();
    for (const Event& event : frame.told.events) CHECK(event.time == near(*time++).margin(kFound));
    std::size_t body = 0;
    for (const double place : places) CHECK(frame.x(body++) == near(place).margin(kFound));
  };
  for (const TimewarpListing listing : {kSimple, kSafer}) {
    check(Frame(world, printed(but({"T4"}), listing)), {0.25, 0.3, 0.1}, {-0.4, 1.8, 4.5});
    check(Frame(world, printed(misprints(), listing)), {0.25, 7.0 / 15.0, 0.9}, {0.4, 1.5, 4.0});
  }
  // F2 has nearly the same effect in the other listing: all stamps stay at the start of the frame. The
  // third cube, a neighbour of the last collision, is flown for a whole second from 3.1 m on.
  check(Frame(world, printed(but({"F2"}), kSafer)), {0.25, 0.3, 0.6}, {0.1, 1.5, 5.1});
}

TEST_CASE("T5: a body that passes through another one within a frame is missed",
          "[exact][timewarp]") {
  const World world = line_of("0:2,1.5:0,2.9:-1");
  const TimewarpErrata all = TimewarpErrata::all();
  const Frame missed(world, printed(but({"T5"}, all)));
  CHECK(missed.events() == 1);
  CHECK(missed.x(1) == near(3.0).margin(kFound));
  CHECK(missed.x(2) == near(1.9).margin(kFound));
  const Frame seen(world, printed(all));
  CHECK(seen.events() == 3);
  CHECK(seen.x(1) == near(1.5).margin(kFound));
  CHECK(seen.x(2) == near(4.0).margin(kFound));
}

TEST_CASE("T6: a ball that comes to rest fills a frame with collisions", "[exact][timewarp]") {
  // Hops of 2 v/g, each half as long as the one before, end at 10.194 ms. The fourteenth begins
  // about then.
  const World world = ball_above_ground(0.0, 0.05);
  const double dt = 1.0 / 60.0;
  for (const TimewarpListing listing : {kSimple, kSafer}) {
    const Frame endless(world, printed(but({"T6"}), listing, 500), dt);
    CHECK(endless.capped());
    CHECK(endless.technique.passes() == 500);
    CHECK(endless.events() >= 14);
    CHECK(endless.told.events[13].time < 10.21e-3);
    CHECK(endless.valid_time(1) == near(10.2e-3).margin(5e-5));  // no progress
    const Frame ended(world, printed(misprints(), listing, 500), dt);
    CHECK_FALSE(ended.capped());
    CHECK(ended.events() == 14);
  }
}

TEST_CASE("T7: a body put into overlap collides at the same time again and again",
          "[exact][timewarp]") {
  // Without the contact stage, which would end it.
  const World world = line_of("0:2,1.5:0", "0");
  const Frame again(world, printed(but({"T6", "T7"})));
  CHECK(again.capped());
  CHECK(again.valid_time(0) > 0.25);
  CHECK(again.valid_time(0) < 0.25 + 2e-6);
  const Frame apart(world, printed(but({"T6"})));
  CHECK(apart.valid_time(0) > 0.3);  // it makes progress, though not to the end

  // With swept volumes, even a pair that separates makes no progress.
  const World bouncing = line_of("0:2,1.5:0", "0.5");
  const TimewarpErrata all = TimewarpErrata::all();
  CHECK(Frame(bouncing, printed(but({"T6", "T7"}, all))).capped());
  CHECK_FALSE(Frame(bouncing, printed(but({"T6"}, all))).capped());
}

TEST_CASE("T8: bisecting an Euler step lets a body land four milliseconds early",
          "[exact][timewarp]") {
  const double dt = 1.0 / 60.0;
  const double g = 9.81;
  const double height = 1e-3;
  const World world = ball_above_ground(height, 0.0);
  const Frame euler(world, printed(but({"T8"})), dt);
  CHECK(euler.told.events.front().time == near(std::sqrt(height / g)).margin(1.5e-6));
  const Frame flight(world, printed(misprints()), dt);
  CHECK(flight.told.events.front().time == near(std::sqrt(2.0 * height / g)).margin(1.5e-6));

  // Two steps of a third and two thirds end 2/9 g dt² above one step.
  const auto dropped = [&](const TimewarpErrata& set, std::initializer_list<double> parts) {
    World free = ball_above_ground(1.0, 0.0);
    PrintedQueries queries(printed(set));
    queries.begin(free, dt, nullptr);
    for (const double part : parts) queries.integrate_forward(free.states()[1], 1, part * dt);
    return free.states()[1].position_w.y();
  };
  const double third = 1.0 / 3.0;
  CHECK(dropped(but({"T8"}), {third, 2.0 * third}) - dropped(but({"T8"}), {1.0}) ==
        near(2.0 / 9.0 * g * dt * dt).margin(1e-12));
  CHECK(dropped(misprints(), {third, 2.0 * third}) - dropped(misprints(), {1.0}) ==
        near(0.0).margin(1e-15));
}

TEST_CASE("T9: met from both sides at one time, one body after the other, a row ends lopsided",
          "[exact][timewarp]") {
  const TimewarpErrata all = TimewarpErrata::all();
  const World world = line_of("0:1,1.5:0,3:-1", "0.5");
  const Frame together(world, printed(all));
  CHECK(together.technique.passes() == 1);
  CHECK(together.v(1) == near(0.0).margin(1e-12));
  CHECK(together.v(0) + together.v(2) == near(0.0).margin(1e-12));
  const Frame in_turn(world, printed(but({"T9"}, all)));
  CHECK(in_turn.technique.passes() > 1);
  CHECK(std::abs(in_turn.v(0) + in_turn.v(2)) > 0.01);
}

TEST_CASE("T10: stamping the ground moves no body", "[exact][timewarp]") {
  World world = ball_above_ground(1e-3, 0.0);
  const BodyProperties cube = world.bodies()[1];
  world.add(cube, make_state(cube, Vec3(3.0, 0.5008, 0.0)));
  for (const TimewarpListing listing : {kSimple, kSafer}) {
    const Frame stamped(world, printed(but({"T10"}), listing), 1.0 / 60.0);
    const Frame mended(world, printed(misprints(), listing), 1.0 / 60.0);
    CHECK(mended.valid_time(0) == 0.0);
    CHECK(stamped.valid_time(0) == near(stamped.valid_time(1)).margin(1e-15));
    REQUIRE(stamped.events() == mended.events());
    for (const std::size_t body : {1u, 2u})
      CHECK((stamped.world.states()[body].position_w - mended.world.states()[body].position_w)
                .norm() < 1e-6);  // [m] the bracket of the second search is another one
  }
}

TEST_CASE("F1: test states that collide and are overwritten have never collided",
          "[exact][timewarp]") {
  const World world = line_of("0:2,1.5:0,10:1");
  const auto check_free = [](const Frame& frame) {
    CHECK(frame.v(0) == near(2.0).margin(1e-15));
    CHECK(frame.v(1) == near(0.0).margin(1e-15));
  };
  // With an unchanged stamp, the same collision repeats endlessly, and the two end in one place.
  const Frame endless(world, printed(but({"F1", "F2"}), kSafer, 20));
  CHECK(endless.capped());
  CHECK(endless.events() == 20);
  CHECK(endless.x(0) == near(1.5).margin(kFound));
  CHECK(endless.x(1) == near(1.5).margin(kFound));
  check_free(endless);
  // F1 alone: a start that is stamped later and later. Four times a quarter of a second is lost.
  const Frame alone(world, printed(but({"F1"}), kSafer, 20));
  CHECK_FALSE(alone.capped());
  CHECK(alone.x(0) == near(0.0).margin(kFound));
  check_free(alone);

  const Frame mended(world, printed(misprints(), kSafer, 20));
  CHECK(mended.events() == 1);
  CHECK(mended.x(0) == near(0.5).margin(kFound));
  CHECK(mended.x(1) == near(3.0).margin(kFound));
  CHECK(mended.x(2) == near(11.0).margin(kFound));
  CHECK(mended.v(1) == near(2.0).margin(1e-12));

  // As printed throughout nothing collides at all: the search among neighbours finds the present
  // pair endlessly (F6).
  const Frame nothing(world, printed(TimewarpErrata(), kSafer, 20));
  CHECK(nothing.capped());
  CHECK(nothing.events() == 0);
  CHECK(nothing.x(0) == near(0.5).margin(kFound));
}

TEST_CASE("F3 and F4: a neighbour is left at the time of a collision that was not its own",
          "[exact][timewarp]") {
  // The third cube flies away to the left. At 0.25 s it is at -1.45 m.
  const World world = line_of("0:2,1.5:0,-1.2:-1");
  for (const char* misprint : {"F3", "F4"}) {
    INFO(misprint);
    const Frame left(world, printed(but({misprint}), kSafer));
    CHECK(left.events() == 1);
    CHECK(left.x(2) == near(-1.45).margin(kFound));
  }
  CHECK(Frame(world, printed(misprints(), kSafer)).x(2) == near(-2.2).margin(kFound));
  // A cube far away keeps its position all the same.
  CHECK(Frame(line_of("0:2,1.5:0,10:1"), printed(but({"F4"}), kSafer)).x(2) ==
        near(11.0).margin(kFound));
}

TEST_CASE("F5: when an earlier collision is found the present one is lost", "[exact][timewarp]") {
  const Frame lost(crossing(), printed(but({"F5"}), kSafer));
  REQUIRE(lost.events() == 1);
  CHECK(lost.told.events[0].time == near(0.0625).margin(kFound));
  CHECK(lost.v(0) == near(2.0).margin(1e-15));
  CHECK(lost.x(0) - lost.x(1) == near(0.5).margin(kFound));  // they overlap undetected

  const Frame mended(crossing(), printed(misprints(), kSafer));
  REQUIRE(mended.events() == 2);
  CHECK(mended.told.events[0].time == near(0.0625).margin(kFound));
  CHECK(mended.told.events[1].time == near(0.25).margin(kFound));
  CHECK(mended.v(0) == near(0.0).margin(1e-12));
}

TEST_CASE("F6: the search among neighbours finds the present pair itself, for ever",
          "[exact][timewarp]") {
  const World world = line_of("0:2,1.5:0");
  // The pair overlaps at its own time if that is the overlapping end of the bracket (T7).
  const Frame endless(world, printed(but({"F6", "T7"}), kSafer, 20));
  CHECK(endless.capped());
  CHECK(endless.events() == 0);
  CHECK(endless.report.restarts == 20);
  CHECK(Frame(world, printed(but({"T7"}), kSafer, 20)).events() == 1);
  CHECK(Frame(world, printed(but({"F6"}), kSafer, 20)).events() == 1);
}

TEST_CASE("F7: a fast neighbour is not near any more at the end of the frame",
          "[exact][timewarp]") {
  const Frame missed(crossing(), printed(but({"F7"}), kSafer));
  REQUIRE(missed.events() == 1);
  CHECK(missed.told.events[0].time == near(0.25).margin(kFound));
  CHECK(missed.x(2) == near(3.5).margin(kFound));
  CHECK(Frame(crossing(), printed(misprints(), kSafer)).x(2) == near(-4.0).margin(kFound));
}

TEST_CASE("F8 and F9 are no misprints of a statement: mending them changes no bit",
          "[unit][timewarp]") {
  for (const TimewarpErrata& set : {misprints(), TimewarpErrata()}) {
    for (const char* id : {"F8", "F9"}) {
      TimewarpAsPrinted with(printed(set.with(id), kSafer));
      TimewarpAsPrinted without(printed(set.without(id), kSafer));
      check_same(cage(3), with, without, 1.0 / 30.0, 10);
    }
  }
}

TEST_CASE("The printed timewarps are made by name, and their options need that reading",
          "[unit][timewarp]") {
  for (const char* name : {"timewarp_simple", "timewarp_safer"}) {
    const TechniqueRecipe& recipe = technique_recipe(name);
    Parameters p = recipe.options();
    for (const char* key : {"repaired", "cap", "separating"}) {
      Parameters refused = p;
      refused.set(key, std::string(key) == "cap"        ? "20"
                       : std::string(key) == "repaired" ? "T1"
                                                        : "collided");
      CHECK_THROWS_AS(recipe.make(refused, 1), std::invalid_argument);
      refused.set("reading", "as_printed");
      CHECK(recipe.make(refused, 1)->name() == name);
    }
    p.set("reading", "as_printed");
    p.set("repaired", misprints().text());
    World world = line_of("0:2,1.5:0");
    const std::unique_ptr<Technique> made = recipe.make(p, 1);
    made->clone()->step(world, 1.0);
    CHECK(world.states()[1].position_w.x() == near(3.0).margin(kFound));
    p.set("repaired", "C1");
    CHECK_THROWS_AS(recipe.make(p, 1), std::invalid_argument);
  }
  CHECK_THROWS_AS(TimewarpAsPrinted(printed(TimewarpErrata(), kSimple, 0)), std::invalid_argument);
}
