/// \file
/// \brief Filters on whole runs, in pieces and live: the same bits, with bodies added and removed.
#include "tumble/filtering/filters.hpp"

#include "support/test.hpp"

namespace {

constexpr std::array<const char*, 9> kFilters = {
    "box:1",        "box:3",         "box:5",    "box:15",
    "box:5,causal", "box:15,causal", "envelope", "envelope:2mm,5deg",
    "soft_envelope"};

std::vector<std::string> all_filters() {
  std::vector<std::string> all(kFilters.begin(), kFilters.end());
  all.emplace_back("one_euro");
  all.emplace_back("one_euro:0.2Hz,3");
  return all;
}

bool same_bits(const Trajectory& a, const Trajectory& b) {
  if (a.count() != b.count()) return false;
  for (int k = 0; k < a.count(); ++k) {
    const Frame f = a.frame(k);
    const Frame g = b.frame(k);
    if (f.time != g.time || f.step != g.step || f.ids.size() != g.ids.size()) return false;
    for (std::size_t i = 0; i < f.ids.size(); ++i)
      if (f.ids[i] != g.ids[i] || !(f.states[i] == g.states[i])) return false;
  }
  return true;
}

// Bodies that shake, creep, fly and rest by turns, that are added and removed; q or -q at random.
class Wanderers {
 public:
  explicit Wanderers(std::uint64_t seed) : chance_(seed) {
    for (int k = 0; k < 4; ++k) come();
  }

  void step() {
    if (chance_.below(12) == 0) come();
    if (chance_.below(12) == 0 && world.count() > 0)
      world.remove(world.ids()[chance_.below(static_cast<std::uint32_t>(world.count()))]);
    for (int k = 0; k < world.count(); ++k) {
      BodyState state = world.states()[idx(k)];
      constexpr std::array<double, 5> sizes = {0.0, 0.0, 1e-3, 1e-2, 0.3};  // [m] and [rad]
      const double size = sizes[chance_.below(5)];
      state.position_w += chance_.in_cube(size);
      state.linear_momentum_w = chance_.in_cube(1.0);
      if (size > 0.0)
        state.orientation_wb =
            normalised(rotation_from_vector(chance_.in_cube(5.0 * size)) * state.orientation_wb);
      if (chance_.below(4) == 0) state.orientation_wb.coeffs() *= -1.0;
      world.set_state(world.ids()[idx(k)], state);
    }
    world.finish_step(kFrame);
  }

  World world;

 private:
  void come() { world.add(box_properties(Vec3::Ones(), 1.0), chance_.in_cube(2.0)); }

  Random chance_;
};

Trajectory wandering(std::uint64_t seed, int frames) {
  Wanderers bodies(seed);
  Trajectory run;
  run.record(bodies.world);
  while (run.count() < frames) {
    bodies.step();
    run.record(bodies.world);
  }
  return run;
}

// Adds some frames of a run.
void add(const Trajectory& run, int begin, int end, PoseFilter& filter, Trajectory& shown) {
  for (int k = begin; k < end; ++k)
    filter.add(run.frame(k), [&](const Frame& frame) { shown.record(frame); });
}

void finish(PoseFilter& filter, Trajectory& shown) {
  filter.finish([&](const Frame& frame) { shown.record(frame); });
}

}  // namespace

TEST_CASE("Whole, in pieces and live, a run is shown with the same bits", "[unit][filtering]") {
  for (const std::string& text : all_filters())
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      for (const int every : {1, 3}) {
        INFO(text << ", seed " << seed << ", every " << every);
        const auto filter = filter_of(text);
        Wanderers bodies(seed);
        TrajectoryRecorder recorder(bodies.world, every);
        FilteringObserver live(bodies.world, *filter, every);
        for (int step = 1; step <= 150; ++step) {
          bodies.step();
          recorder.on_step(bodies.world, StepReport{});
          live.on_step(bodies.world, StepReport{});
          const int taken = recorder.trajectory().count();
          CHECK(live.shown().count() == std::max(0, taken - filter->latency()));
        }
        live.finish();
        const Trajectory& run = recorder.trajectory();
        const Trajectory whole = filtered(run, *filter);
        REQUIRE(whole.count() == 1 + 150 / every);
        CHECK(same_bits(live.shown(), whole));

        Random chance(seed);
        Trajectory pieces;
        const auto own = filter->clone();
        for (int begin = 0; begin < run.count();) {
          const int end = std::min(run.count(), begin + static_cast<int>(chance.below(20)));
          add(run, begin, end, *own, pieces);  // sometimes a piece without frames
          begin = end;
        }
        finish(*own, pieces);
        CHECK(same_bits(pieces, whole));
      }
}

TEST_CASE("Filtering changes poses alone: times, bodies and momenta stay", "[unit][filtering]") {
  const Trajectory run = wandering(7, 80);
  for (const std::string& text : all_filters()) {
    INFO(text);
    const Trajectory shown = filtered(run, *filter_of(text));
    REQUIRE(shown.count() == run.count());
    int changed = 0;
    for (int k = 0; k < run.count(); ++k) {
      const Frame f = run.frame(k);
      const Frame g = shown.frame(k);
      CHECK(f.time == g.time);
      CHECK(f.step == g.step);
      REQUIRE(std::equal(f.ids.begin(), f.ids.end(), g.ids.begin(), g.ids.end()));
      for (std::size_t i = 0; i < f.ids.size(); ++i) {
        CHECK(f.states[i].linear_momentum_w == g.states[i].linear_momentum_w);
        CHECK(f.states[i].angular_momentum_w == g.states[i].angular_momentum_w);
        if (f.states[i].position_w != g.states[i].position_w) ++changed;
      }
    }
    CHECK((changed > 0) == (text != "box:1"));
  }
}

TEST_CASE("A filter that is copied in the middle of a run goes on like the original",
          "[unit][filtering]") {
  const Trajectory run = wandering(3, 60);
  const Trajectory other = wandering(4, 60);
  for (const std::string& text : all_filters())
    for (const int middle : {0, 1, 2, 7, 30, 59}) {
      INFO(text << ", copied after " << middle);
      const auto original = filter_of(text);
      Trajectory shown;
      add(run, 0, middle, *original, shown);
      const auto copy = original->clone();
      Trajectory shown_by_copy = shown;

      // The copy does not affect the original, whatever frames it gets.
      const auto astray = original->clone();
      Trajectory elsewhere;
      add(other, middle, other.count(), *astray, elsewhere);
      finish(*astray, elsewhere);

      add(run, middle, run.count(), *original, shown);
      finish(*original, shown);
      add(run, middle, run.count(), *copy, shown_by_copy);
      finish(*copy, shown_by_copy);
      const Trajectory whole = filtered(run, *filter_of(text));
      CHECK(same_bits(shown, whole));
      CHECK(same_bits(shown_by_copy, whole));
    }
}

TEST_CASE("A filter that has finished a run begins the next one afresh", "[unit][filtering]") {
  const Trajectory first = wandering(5, 40);
  const Trajectory second = wandering(6, 40);
  for (const std::string& text : all_filters()) {
    INFO(text);
    const auto filter = filter_of(text);
    Trajectory shown;
    add(first, 0, 40, *filter, shown);
    finish(*filter, shown);
    Trajectory again;
    add(second, 0, 40, *filter, again);
    finish(*filter, again);
    CHECK(same_bits(again, filtered(second, *filter_of(text))));

    add(first, 0, 20, *filter, shown);  // in the middle of a run
    CHECK(same_bits(filtered(second, *filter), again));
    add(first, 20, 40, *filter, shown);  // unaffected by the other one
    finish(*filter, shown);
    CHECK(shown.count() == 80);
    const BodyState last = shown.frame(79).states[0];
    CHECK(last == filtered(first, *filter_of(text)).frame(39).states[0]);
  }
}

TEST_CASE("A frame that a filter refuses leaves no trace in what it shows", "[unit][filtering]") {
  const Trajectory run = wandering(8, 40);
  for (const std::string& text : all_filters())
    for (const int middle : {1, 3, 20}) {
      INFO(text << ", frame " << middle);
      const auto filter = filter_of(text);
      Trajectory shown;
      add(run, 0, middle, *filter, shown);
      const Frame good = run.frame(middle);
      std::vector<BodyState> states(good.states.begin(), good.states.end());
      states.back().position_w.y() = kNan;
      const FrameSink discard = [](const Frame&) {};
      CHECK_THROWS_WITH(filter->add(Frame{good.time, good.step, good.ids, states}, discard),
                        Contains("frame " + std::to_string(middle)));
      const Frame before = run.frame(middle - 1);
      CHECK_THROWS_AS(filter->add(before, discard), std::invalid_argument);
      add(run, middle, run.count(), *filter, shown);
      finish(*filter, shown);
      CHECK(same_bits(shown, filtered(run, *filter_of(text))));
    }
}
