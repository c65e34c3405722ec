/// \file
/// \brief First collisions among bodies in flight: closed forms, ties, restarts, caps and fuzz.
#include "tumble/dynamics/event_search.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/allocation_counter.hpp"
#include "support/test.hpp"

namespace {

constexpr std::array<SearchMethod, 2> kMethods = {SearchMethod::discrete,
                                                  SearchMethod::conservative};

// Bodies, and a flight over them.
struct TestScene {
  std::vector<BodyProperties> bodies;
  std::vector<BodyState> states;
  std::vector<double> valid_times;
  std::vector<Vec3> accelerations_w;
  Vec3 gravity_w = Vec3::Zero();
  RotationRule rule = RotationRule::splitting;
  double micro_step = kInfinity;

  void add(const BodyProperties& body, const BodyState& state) {
    bodies.push_back(body);
    states.push_back(state);
  }
  void add(const BodyProperties& body, const Vec3& position_w, const Quat& q = Quat::Identity(),
           const Vec3& velocity_w = Vec3::Zero(), const Vec3& omega_w = Vec3::Zero()) {
    add(body, make_state(body, position_w, q, velocity_w, omega_w));
  }
  // A unit cube on the x axis.
  void add_cube(double x, double speed) {
    add(box_properties(Vec3::Ones(), 1.0), Vec3(x, 0.0, 0.0), Quat::Identity(),
        Vec3(speed, 0.0, 0.0));
  }
  [[nodiscard]] Flight flight() const {
    return Flight{.bodies = bodies,
                  .states = states,
                  .valid_times = valid_times,
                  .accelerations_w = accelerations_w,
                  .gravity_w = gravity_w,
                  .rule = rule,
                  .micro_step = micro_step};
  }
  [[nodiscard]] std::vector<IndexPair> all_pairs() const {
    std::vector<IndexPair> pairs;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(bodies.size()); ++j) pairs.push_back({i, j});
    return pairs;
  }
};

SearchOptions with(SearchMethod method, double resolution = 1e-6) {
  return SearchOptions{.method = method, .resolution = resolution};
}

FirstEvent first_event(const TestScene& scene, double end, const SearchOptions& options,
                       double start = 0.0) {
  EventSearch search;
  return search.find(scene.flight(), scene.all_pairs(), start, end, options);
}

// The exact time lies in [time, time + resolution], and rounding.
bool brackets(const FirstEvent& event, double exact, double resolution) {
  return event.status == CollisionStatus::found && event.time <= exact + 1e-14 &&
         exact <= event.time + resolution + 1e-14;
}

}  // namespace

TEST_CASE("Two cubes that meet head-on do so at the time of the closed form", "[exact][search]") {
  TestScene scene;
  scene.add_cube(0.0, 1.0);
  scene.add_cube(2.0, -1.0);  // 1 m apart at 2 m/s
  for (const SearchMethod method : kMethods) {
    for (const double resolution : {1e-3, 1e-6, 1e-9}) {
      const FirstEvent event = first_event(scene, 0.875, with(method, resolution));
      CHECK(brackets(event, 0.5, resolution));
      CHECK(event.touching == std::vector<IndexPair>{{0, 1}});
      CHECK(event.overlapping_at_start.empty());
      CHECK(event.restarts == 0);
    }
    CHECK(first_event(scene, 0.49, with(method)).status == CollisionStatus::none);
    CHECK(first_event(scene, 0.49, with(method)).time == 0.49);
  }
  // 1/60 s to 1e-6 s takes 15 halvings; the separations at both ends come on top.
  scene.states[1].position_w.x() = 1.02;
  const FirstEvent event = first_event(scene, 1.0 / 60.0, with(SearchMethod::discrete));
  CHECK(brackets(event, 0.01, 1e-6));
  CHECK(event.evaluations == 15);
  CHECK(event.pair_tests == 17);
  // Nothing turns, so the conservative search steps right to the contact.
  CHECK(first_event(scene, 1.0 / 60.0, with(SearchMethod::conservative)).pair_tests <= 5);
}

TEST_CASE("A body 1 mm above the ground reaches it after 14.278 ms", "[exact][search]") {
  // An Euler step that is cut in two finds 10.096 ms, or nothing: flight is a flow, Euler is not.
  TestScene scene;
  scene.add(ground_properties(), BodyState{});
  scene.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 0.501, 0.0));
  scene.gravity_w = Vec3(0.0, -9.81, 0.0);
  for (const SearchMethod method : kMethods) {
    const FirstEvent event = first_event(scene, 1.0 / 60.0, with(method, 1e-9));
    CHECK(brackets(event, std::sqrt(2.0 * 0.001 / 9.81), 2e-9));  // 0.501 - 0.5 is off by 3e-17
    CHECK(event.time == near(14.278e-3).epsilon(1e-4));
  }
}

TEST_CASE("The corner of a turning cube reaches the ground at the time of the closed form",
          "[exact][search]") {
  // Centre at 0.7 m, corners 0.7071 m from it, turning about z at 2 rad/s: the lowest corner is at
  // 0.7 - sin(θ + 45°)/√2.
  TestScene scene;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  scene.add(ground_properties(), BodyState{});
  scene.add(cube, Vec3(0.0, 0.7, 0.0), Quat::Identity(), Vec3::Zero(), Vec3(0.0, 0.0, 2.0));
  const double quarter_pi = 0.78539816339744830962;
  const double enter = (std::asin(0.7 * std::sqrt(2.0)) - quarter_pi) / 2.0;
  const double leave = quarter_pi - enter;  // symmetric about 45 degrees, which is at π/8 s
  REQUIRE(leave > enter);
  for (const SearchMethod method : kMethods) {
    for (const RotationRule rule : rotation_rules()) {
      scene.rule = rule;
      // RK4 is not exact for a cube: 0.8 rad in one step are off by some 1e-5.
      const double slack = rule == RotationRule::rk4 ? 2e-4 : 0.0;
      const FirstEvent event = first_event(scene, 0.5 * (enter + leave), with(method, 1e-9));
      CHECK(event.status == CollisionStatus::found);
      CHECK(event.time <= enter + 1e-12 + slack);
      CHECK(event.time >= enter - 2e-9 - slack);
      CHECK(event.touching == std::vector<IndexPair>{{0, 1}});
    }
  }
  // It dips into the ground and comes out again before the end: only one method sees it.
  scene.rule = RotationRule::splitting;
  CHECK(first_event(scene, 0.7, with(SearchMethod::discrete)).status == CollisionStatus::none);
  CHECK(brackets(first_event(scene, 0.7, with(SearchMethod::conservative)), enter, 1e-6));
}

TEST_CASE("Between two spinning bars no overlap is missed that a fine grid of times shows",
          "[exact][search]") {
  Random random(61);
  int checked = 0;
  int wrong = 0;
  for (int trial = 0; trial < 300; ++trial) {
    TestScene scene;
    scene.rule = rotation_rules()[static_cast<std::size_t>(trial % 4)];
    if (trial % 3 == 0) scene.micro_step = 0.0125;
    for (const double x : {-0.7, 0.7}) {
      const Quat q = random.orientation();
      const Vec3 omega = random.in_cube(6.0);
      scene.add(box_properties(Vec3(2.0, 0.3, 0.5), 1.0), Vec3(x, 0.0, 0.0), q, Vec3(-x, 0.0, 0.0),
                omega);
    }
    const Flight flight = scene.flight();
    if (gap_at(flight, {0, 1}, 0.0).distance < 0.0) continue;
    const FirstEvent event = first_event(scene, 0.1, with(SearchMethod::conservative));
    // No time of the grid before the event overlaps, and right after it the bars do.
    for (int k = 0; k <= 1000; ++k)
      if (gap_at(flight, {0, 1}, event.time * k / 1000.0).distance < 0.0) ++wrong;
    // Midpoint and RK4 have weak bounds for long bars and may give up, but never on a wrong time.
    if (event.status == CollisionStatus::cap_reached && trial % 4 != 1 && trial % 4 != 2) ++wrong;
    if (event.status != CollisionStatus::found) continue;
    ++checked;
    if (gap_at(flight, {0, 1}, event.time + 1e-6).distance >= 0.0) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(checked > 15);  // measured 37
}

TEST_CASE("A third body that collided earlier restarts the discrete search", "[exact][search]") {
  // A reaches B after 1 s, which is found first; but C catches up with A after 0.5 s.
  TestScene scene;
  scene.add_cube(0.0, 2.0);   // A
  scene.add_cube(3.0, 0.0);   // B
  scene.add_cube(-1.5, 3.0);  // C
  const FirstEvent event = first_event(scene, 1.1, with(SearchMethod::discrete));
  CHECK(brackets(event, 0.5, 1e-6));
  CHECK(event.touching == std::vector<IndexPair>{{0, 2}});
  CHECK(event.restarts == 1);
  const FirstEvent other = first_event(scene, 1.1, with(SearchMethod::conservative));
  CHECK(brackets(other, 0.5, 1e-6));
  CHECK(other.touching == std::vector<IndexPair>{{0, 2}});
  CHECK(other.restarts == 0);

  // C brushes A from above at the time of the first collision and is gone at the end: it is seen
  // because all pairs are tested at the time found, not only at the end.
  scene.states[2] = make_state(scene.bodies[2], Vec3(2.0, 11.0, 0.0), Quat::Identity(),
                               Vec3(0.0, -11.0, 0.0));  // overlaps A around t = 1, for 0.18 s
  const FirstEvent brushed = first_event(scene, 1.2, with(SearchMethod::discrete));
  CHECK(brushed.restarts == 1);
  CHECK(brackets(brushed, 10.0 / 11.0, 1e-6));
  CHECK(brushed.touching == std::vector<IndexPair>{{0, 2}});
}

TEST_CASE("A box that lands flat on two boxes is one event with two pairs, in any order",
          "[exact][search]") {
  TestScene scene;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  scene.add(ground_properties(), BodyState{});
  scene.add(cube, Vec3(-1.0, 0.5, 0.0));
  scene.add(cube, Vec3(1.0, 0.5, 0.0));
  scene.add(box_properties(Vec3(4.0, 0.5, 1.0), 2.0), Vec3(0.0, 1.26, 0.0));
  scene.gravity_w = Vec3(0.0, -9.81, 0.0);
  // The cubes stand on the ground: held there, as contact forces would.
  scene.accelerations_w = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), scene.gravity_w};
  for (const SearchMethod method : kMethods) {
    std::vector<IndexPair> pairs = scene.all_pairs();
    const EventSearch untouched;
    EventSearch search = untouched;
    const FirstEvent event = search.find(scene.flight(), pairs, 0.0, 0.1, with(method));
    CHECK(brackets(event, std::sqrt(2.0 * 0.01 / 9.81), 1e-6));
    CHECK(event.touching == std::vector<IndexPair>{{1, 3}, {2, 3}});
    std::ranges::reverse(pairs);
    const FirstEvent again = search.find(scene.flight(), pairs, 0.0, 0.1, with(method));
    CHECK(again.time == event.time);
    CHECK(again.touching == event.touching);
    // 3 µs lower on one side: that side is alone.
    scene.states[2].position_w.y() += 3e-6;
    CHECK(search.find(scene.flight(), pairs, 0.0, 0.1, with(method)).touching ==
          std::vector<IndexPair>{{2, 3}});
    scene.states[2].position_w.y() = 0.5;
  }
}

TEST_CASE("Pairs that overlap at the start are listed apart and never found by bisection",
          "[exact][search]") {
  for (const SearchMethod method : kMethods) {
    TestScene scene;
    scene.add_cube(0.0, 1.0);
    scene.add_cube(0.75, 0.0);  // 0.25 m deep, and deeper soon
    scene.add_cube(3.0, -1.0);  // reaches the second after 1.25 s
    scene.add_cube(3.5, 0.0);   // 0.5 m deep in the third, and getting out
    const FirstEvent event = first_event(scene, 1.5, with(method));
    REQUIRE(event.overlapping_at_start.size() == 2);
    CHECK(event.overlapping_at_start[0].pair == IndexPair{0, 1});
    CHECK(event.overlapping_at_start[0].gap == near(-0.25, 1e-12));
    CHECK(event.overlapping_at_start[0].deepening);
    CHECK(event.overlapping_at_start[1].pair == IndexPair{2, 3});
    CHECK(event.overlapping_at_start[1].gap == near(-0.5, 1e-12));
    CHECK_FALSE(event.overlapping_at_start[1].deepening);
    // The overlapping pairs do not hide what else happens: 0 and 2 are 2 m apart at 2 m/s.
    CHECK(brackets(event, 1.0, 1e-6));
    CHECK(event.touching == std::vector<IndexPair>{{0, 2}});
    CHECK(find_collision(scene.flight(), {0, 1}, 0.0, 1.0, with(method)).status ==
          CollisionStatus::overlapping_at_start);
  }
}

TEST_CASE(
    "Bodies that touch and part are no collision; bodies that touch and press are one at "
    "once",
    "[exact][search]") {
  for (const SearchMethod method : kMethods) {
    TestScene parting;
    parting.add_cube(0.0, -1.0);
    parting.add_cube(1.0, 1.0);
    const FirstEvent none = first_event(parting, 1.0, with(method));
    CHECK(none.status == CollisionStatus::none);
    CHECK(none.pair_tests <= 4);
    TestScene pressing;
    pressing.add_cube(0.0, 1.0);
    pressing.add_cube(1.0, -1.0);
    const FirstEvent at_once = first_event(pressing, 0.75, with(method));
    CHECK(at_once.status == CollisionStatus::found);
    CHECK(at_once.time == 0.0);
  }
}

TEST_CASE("Bodies with different valid times are searched from their own states",
          "[exact][search]") {
  // As after an event of the timewarp: the first body is valid at 0.25, the second at 0. Each
  // moves on its own arc; the positions below are those at its valid time.
  TestScene scene;
  scene.add_cube(0.5, 0.5);
  scene.add_cube(3.0, -1.0);
  scene.valid_times = {0.25, 0.0};
  // x1 = 0.5 + 0.5 (t - 0.25), x2 = 3 - t, 1 apart at t = 1.625 / 1.5.
  for (const SearchMethod method : kMethods) {
    const FirstEvent event = first_event(scene, 1.5, with(method), 0.25);
    CHECK(brackets(event, 1.625 / 1.5, 1e-6));
  }
  CHECK_THROWS_AS(first_event(scene, 1.5, {}, 0.1), std::invalid_argument);
}

TEST_CASE("A body flown to the time of an event has the bits that the search saw",
          "[determinism][search]") {
  Random random(62);
  int found = 0;
  int overlapping = 0;
  for (int trial = 0; trial < 200; ++trial) {
    TestScene scene;
    scene.rule = rotation_rules()[static_cast<std::size_t>(trial % 4)];
    scene.gravity_w = Vec3(0.0, -9.81, 0.0);
    scene.add(ground_properties(), BodyState{});
    const BodyProperties body = random_box(random);
    BodyState state = random_state(random, body, 1.0, 3.0, 5.0);
    state.position_w.y() = 0.5 * body.size.norm() + 0.01;
    scene.add(body, state);
    const FirstEvent event = first_event(scene, 0.25, with(SearchMethod::conservative));
    if (event.status != CollisionStatus::found) continue;
    ++found;
    // The next search starts where this one ended. If a bit were different, a pair that just
    // touches would overlap.
    scene.states[1] = state_at(scene.flight(), 1, event.time);
    const FirstEvent next = first_event(scene, 0.25, with(SearchMethod::discrete));
    overlapping += next.overlapping_at_start.empty() ? 0 : 1;
  }
  CHECK(found > 100);
  CHECK(overlapping == 0);
}

TEST_CASE("A cap that is reached is a status, at a time where bodies are apart", "[unit][search]") {
  TestScene scene;
  scene.add_cube(0.0, 1.0);
  scene.add_cube(2.0, -1.0);
  SearchOptions few = with(SearchMethod::discrete);
  few.cap = 3;
  FirstEvent event = first_event(scene, 0.875, few);
  CHECK(event.status == CollisionStatus::cap_reached);
  CHECK(event.touching.empty());
  CHECK(event.time == 0.0);

  // A fast spinning pair at a small distance: the bound is far from the truth.
  few.method = SearchMethod::conservative;
  scene.states[0].linear_momentum_w.setZero();
  scene.states[1] = make_state(scene.bodies[1], Vec3(1.01, 0.0, 0.0), Quat::Identity(),
                               Vec3::Zero(), Vec3(50.0, 0.0, 0.0));
  event = first_event(scene, 0.875, few);
  CHECK(event.status == CollisionStatus::cap_reached);
  CHECK(event.time > 0.0);
  CHECK(event.time < 0.01);
  // With the usual cap it is found out that nothing happens.
  few.cap = 1000000;
  CHECK(first_event(scene, 0.01, few).status == CollisionStatus::none);
}

TEST_CASE("Random piles are searched without hanging, and what is found is true",
          "[unit][search]") {
  Random random(63);
  int wrong = 0;
  int found = 0;
  int late = 0;
  int capped = 0;
  std::int64_t tests = 0;
  for (int trial = 0; trial < 400; ++trial) {
    TestScene scene;
    scene.gravity_w = trial % 3 == 0 ? Vec3::Zero() : Vec3(0.0, -9.81, 0.0);
    scene.rule = rotation_rules()[static_cast<std::size_t>(trial % 4)];
    scene.add(ground_properties(), BodyState{});
    scene.add(fixed_box_properties(Vec3::Ones()), Vec3(0.0, 0.5, 0.0));
    for (int i = 0; i < 4; ++i) {
      const BodyProperties body = random_box(random);
      scene.add(body, random_state(random, body, 3.0, 10.0, 10.0));
      scene.states.back().position_w.y() += 4.0;
    }
    const double end = random.uniform(0.0, 0.2);
    std::array<FirstEvent, 2> events;
    for (const SearchMethod method : kMethods) {
      const FirstEvent event = first_event(scene, end, with(method));
      events[method == SearchMethod::discrete ? 0 : 1] = event;
      tests += event.pair_tests;
      capped += event.status == CollisionStatus::cap_reached ? 1 : 0;
      if (event.status != CollisionStatus::found) continue;
      ++found;
      const Flight flight = scene.flight();
      // All pairs are apart at the time, but for those that were not to begin with.
      for (const IndexPair& pair : scene.all_pairs()) {
        const auto same = [&](const StartOverlap& overlap) { return overlap.pair == pair; };
        const bool excluded = std::ranges::any_of(event.overlapping_at_start, same);
        if (!excluded && gap_at(flight, pair, event.time).distance < 0.0) ++wrong;
      }
      wrong += event.touching.empty() ? 1 : 0;
      wrong += std::ranges::is_sorted(event.touching) ? 0 : 1;
      // Those of the event overlap one resolution later, or did meanwhile (a brush).
      int overlapping = 0;
      for (const IndexPair& pair : event.touching)
        overlapping += gap_at(flight, pair, event.time + 1e-6).distance < 0.0 ? 1 : 0;
      wrong += overlapping == 0 ? 1 : 0;
    }
    // What the discrete search finds, the conservative one finds too, and not later.
    if (events[0].status == CollisionStatus::found && events[1].time > events[0].time + 1e-6)
      ++late;
  }
  CHECK(wrong == 0);
  CHECK(late == 0);
  CHECK(capped == 0);
  CHECK(found > 150);     // measured 184 of 800
  CHECK(tests < 200000);  // measured 57 000 separations
}

TEST_CASE("A warm search does not allocate", "[unit][search]") {
  TestScene scene;
  for (int i = 0; i < 6; ++i) scene.add_cube(1.5 * i, -1.0 * i);
  scene.add_cube(0.5, 0.0);
  const std::vector<IndexPair> pairs = scene.all_pairs();
  const Flight flight = scene.flight();
  EventSearch search;
  for (const SearchMethod method : kMethods) search.find(flight, pairs, 0.0, 0.6, with(method));
  const AllocationCount count;
  for (const SearchMethod method : kMethods) search.find(flight, pairs, 0.0, 0.6, with(method));
  CHECK(count.value() == 0);
}

TEST_CASE("Searches refuse flights, intervals, pairs and options that make no sense",
          "[unit][search]") {
  TestScene scene;
  scene.add_cube(0.0, 1.0);
  scene.add_cube(2.0, -1.0);
  EventSearch search;
  const std::vector<IndexPair> good = {{0, 1}};
  const auto find = [&](const std::vector<IndexPair>& pairs, double start, double end,
                        const SearchOptions& options = {}) {
    search.find(scene.flight(), pairs, start, end, options);
  };
  CHECK_NOTHROW(find(good, 0.0, 0.0));
  CHECK_THROWS_WITH(find(good, 1.0, 0.5), "tumble: end = 0.5: expected at least start = 1");
  CHECK_THROWS_AS(find(good, 0.0, kInfinity), std::invalid_argument);
  CHECK_THROWS_WITH(
      find({{1, 0}}, 0.0, 1.0),
      "tumble: candidate (1, 0): expected two indices below 2, the smaller one first");
  CHECK_THROWS_AS(find({{0, 0}}, 0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(find({{0, 2}}, 0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(find({{-1, 1}}, 0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(find(good, 0.0, 1.0, with(SearchMethod::discrete, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(find(good, 1e6, 1e6 + 1.0, with(SearchMethod::discrete, 1e-12)),
                  std::invalid_argument);
  CHECK_THROWS_AS(find(good, 0.0, 1.0, {.cap = 1}), std::invalid_argument);
  scene.states[0].position_w.x() = kNan;
  CHECK_THROWS_AS(find(good, 0.0, 1.0), std::invalid_argument);
  scene.states.pop_back();
  CHECK_THROWS_WITH(find(good, 0.0, 1.0), "tumble: flight.states: expected one for each body");
}

TEST_CASE("Two immovable bodies are never an event", "[unit][search]") {
  TestScene scene;
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  scene.add(ground_properties(), BodyState{});
  scene.add(fixed, Vec3(0.0, 0.25, 0.0));
  scene.add(fixed, Vec3(0.0, 0.5, 0.0));
  for (const SearchMethod method : kMethods) {
    const FirstEvent event = first_event(scene, 1.0, with(method));
    CHECK(event.status == CollisionStatus::none);
    CHECK(event.overlapping_at_start.empty());
    CHECK(event.pair_tests == 0);
  }
}
