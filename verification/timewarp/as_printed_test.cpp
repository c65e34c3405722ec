/// \file
/// \brief The two printed listings of the timewarp: the effect of each misprint, and that nothing else is
///        wrong with them.
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "support/test.hpp"
#include "timewarp/cases.hpp"

namespace {

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
  return TimewarpAsPrintedOptions{.listing = listing,
                                  .repaired = repaired,
                                  .cap = cap,
                                  .collide_separating = collide_separating};
}

// One frame and the state after it.
struct Frame {
  Frame(const World& start, const TimewarpAsPrintedOptions& options, double dt = 1.0)
      : world(start), technique(options) {
    technique.observe(&observed);
    report = technique.step(world, dt);
  }

  [[nodiscard]] double x(std::size_t body) const {  // before overlap is repaired
    return technique.test_states()[body].position_w.x();
  }
  [[nodiscard]] double v(std::size_t body) const {
    return velocity(world.bodies()[body], technique.test_states()[body]).x();
  }
  [[nodiscard]] double valid_time(std::size_t body) const { return technique.valid_times()[body]; }
  [[nodiscard]] std::size_t events() const { return observed.events.size(); }
  [[nodiscard]] bool capped() const { return report.status == StepStatus::event_cap; }

  World world;
  TimewarpAsPrinted technique;
  Listener observed;
  StepReport report;
};

// Two cubes fly over one another, and two others would collide beneath them while they overlap.
World crossing() {
  World world = weightless_world();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  const auto add = [&](double x, double y, double v) {
    world.add(cube, Vec3(x, y, 0.0), Quat::Identity(), Vec3(v, 0.0, 0.0));
  };
  add(0.0, 0.0, 2.0);
  add(1.5, 0.0, 0.0);
  add(-0.5, 1.3, 4.0);
  add(1.0, 1.3, -4.0);
  return world;
}

World ball_above_ground(double height, double speed_down) {
  World world = ground_world(0.0, 0.5);
  world.add(box_properties(Vec3::Ones(), 1.0, 0.0, 0.5), Vec3(0.0, 0.5 + height, 0.0),
            Quat::Identity(), Vec3(0.0, -speed_down, 0.0));
  return world;
}

// Compares a run with another one, bit by bit.
void check_same(World world, Technique& one, Technique& other, double dt, int steps) {
  World twin = world;
  Listener observed;
  Listener also_observed;
  one.observe(&observed);
  other.observe(&also_observed);
  for (int k = 0; k < steps; ++k) {
    const StepReport a = one.step(world, dt);
    const StepReport b = other.step(twin, dt);
    REQUIRE(a.status == b.status);
    REQUIRE(a.rewinds == b.rewinds);
    REQUIRE(a.restarts == b.restarts);
    REQUIRE(a.fallbacks == b.fallbacks);
    REQUIRE(world.hash().value() == twin.hash().value());
  }
  REQUIRE(observed.events.size() == also_observed.events.size());
  for (std::size_t k = 0; k < observed.events.size(); ++k) {
    REQUIRE(observed.events[k].time == also_observed.events[k].time);
    REQUIRE(observed.events[k].first == also_observed.events[k].first);
    REQUIRE(observed.events[k].second == also_observed.events[k].second);
    REQUIRE(observed.events[k].impulse_w == also_observed.events[k].impulse_w);
    REQUIRE(observed.events[k].rewinds == also_observed.events[k].rewinds);
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
  World world = ground_world(0.3, 0.3);
  for (int k = 0; k < 4; ++k) {
    world.add(box_properties(Vec3::Constant(0.2), 1.0, 0.3, 0.3),
              Vec3(0.1 * random.uniform(-1.0, 1.0), 0.15 + 0.3 * k, 0.0), Quat::Identity(),
              Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, random.uniform(-3.0, 3.0)));
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
  // With the choices mended too, the simple listing is the timewarp with swept volumes.
  const auto [repaired, listing, name] =
      GENERATE(std::tuple(misprints(), kSimple, "timewarp_simple"),
               std::tuple(misprints(), kSafer, "timewarp_safer"),
               std::tuple(TimewarpErrata::all(), kSimple, "timewarp_swept"));
  const TimewarpAsPrintedOptions options = printed(repaired, listing, 100000);
  const std::string form = name;
  const auto compare = [&](const World& world, double dt, int steps) {
    TimewarpAsPrinted as_printed(options);
    check_same(world, as_printed, *make_timewarp(form), dt, steps);
  };
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO(form << ", seed " << seed);
    compare(row(seed), 0.3, 10);
    compare(cage(seed), 1.0 / 30.0, 60);
    compare(pile(seed), 1.0 / 60.0, 30);
  }
  // Cubes in a row that are hit from both sides simultaneously collide together.
  compare(form == "timewarp_swept" ? line_of("0:1,1.5:0,2.5:0,4:-1") : crossing(), 1.0, 1);
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

TEST_CASE("T5: a body that passes through another one within a frame is missed",
          "[exact][timewarp]") {
  const World world = line_of("0:2,1.5:0,2.9:-1");
  const TimewarpErrata all = TimewarpErrata::all();
  const Frame missed(world, printed(but({"T5"}, all)));
  CHECK(missed.events() == 1);
  CHECK(missed.x(1) == near(3.0, kFound));
  CHECK(missed.x(2) == near(1.9, kFound));
  const Frame seen(world, printed(all));
  CHECK(seen.events() == 3);
  CHECK(seen.x(1) == near(1.5, kFound));
  CHECK(seen.x(2) == near(4.0, kFound));
}

TEST_CASE("T3, T4, T6 and T10 do to the safer listing what they do to the simple one",
          "[exact][timewarp]") {
  // The figures of the errata show them in the simple one.
  const auto frame = [](const char* left, const World& world, double dt = 1.0) {
    return Frame(world, printed(left == nullptr ? misprints() : but({left}), kSafer), dt);
  };
  const World pair = line_of("0:2,1.5:0", "0.5");
  CHECK(frame("T3", pair).valid_time(0) == near(1.0, kFound));
  CHECK(frame(nullptr, pair).valid_time(0) == near(0.25, kFound));
  const World three = line_of("0:2,1.5:0,3.4:-1");
  CHECK(frame("T4", three).observed.events[1].time == near(0.3, kFound));
  CHECK(frame(nullptr, three).observed.events[1].time == near(7.0 / 15.0, kFound));
  const World landing = ball_above_ground(0.0, 0.05);
  CHECK(frame("T6", landing, kFrame).capped());
  CHECK_FALSE(frame(nullptr, landing, kFrame).capped());
  CHECK(frame("T10", landing, kFrame).valid_time(0) > 0.0);
  CHECK(frame(nullptr, landing, kFrame).valid_time(0) == 0.0);
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
    for (const char* key : {"repaired", "cap", "separating", "traps"}) {
      Parameters refused = p;
      refused.set(key, std::string(key) == "cap"        ? "20"
                       : std::string(key) == "repaired" ? "T1"
                       : std::string(key) == "traps"    ? "taken"
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
    CHECK(world.states()[1].position_w.x() == near(3.0, kFound));
    p.set("repaired", "C1");
    CHECK_THROWS_AS(recipe.make(p, 1), std::invalid_argument);
  }
  CHECK_THROWS_AS(TimewarpAsPrinted(printed(TimewarpErrata(), kSimple, 0)), std::invalid_argument);
}
