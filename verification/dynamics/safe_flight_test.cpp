/// \file
/// \brief Bodies that are said to stay apart do so, and searches built on that are short.
#include "tumble/dynamics/safe_flight.hpp"

#include "tumble/dynamics/pair_search.hpp"

#include "support/test.hpp"

namespace {

// Two boxes of chance, or a box and the ground, in flight.
struct Two {
  std::array<BodyProperties, 2> bodies;
  std::array<BodyState, 2> states;
  Vec3 gravity_w = Vec3(0.0, -9.81, 0.0);
  [[nodiscard]] Flight flight() const {
    return Flight{.bodies = bodies, .states = states, .gravity_w = gravity_w};
  }
};

BodyState random_state(const BodyProperties& body, const Vec3& place_w, Random& random) {
  const Quat orientation = random.orientation();
  const Vec3 velocity_w = random.in_cube(3.0);
  const Vec3 spin_w = random.in_cube(8.0);
  return make_state(body, place_w, orientation, velocity_w, spin_w);
}

Two random_two(std::uint64_t seed) {
  Random random(seed);
  Two two;
  const Vec3 edges = Vec3::Constant(random.uniform(0.5, 2.0));
  two.bodies[0] = box_properties(edges, 1.0);
  two.bodies[1] = box_properties(
      seed % 3 == 0 ? Vec3(random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), 1.0) : edges, 2.0);
  two.states[0] = random_state(two.bodies[0], Vec3::Zero(), random);
  two.states[1] = random_state(two.bodies[1], 2.2 * random.direction(), random);
  if (seed % 5 == 0) {
    two.bodies[0].inverse_mass = 0.0;  // does not move, and gravity parts the two
    two.bodies[0].inverse_inertia_b.setZero();
    two.states[0].linear_momentum_w.setZero();
    two.states[0].angular_momentum_w.setZero();
  }
  return two;
}

}  // namespace

TEST_CASE("Bodies stay apart for as long as they are said to", "[unit][dynamics]") {
  int looked_at = 0;
  double longest = 0.0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const Two two = random_two(seed);
    const Flight flight = two.flight();
    const double end = 0.5;
    const Separation gap = gap_at(flight, {0, 1}, 0.0);
    if (gap.distance < 0.0) continue;
    ++looked_at;
    const double safe = std::min(safe_flight(flight, {0, 1}, gap, 0.0, end), end);
    longest = std::max(longest, safe);
    double least = gap.distance;
    for (int k = 1; k <= 50; ++k)
      least = std::min(least, gap_at(flight, {0, 1}, safe * k / 50.0).distance);
    INFO(seed);
    CHECK(least >= -1e-14);  // [m] rounding of places of a few metres
  }
  CHECK(looked_at > 1000);
  CHECK(longest == 0.5);
}

TEST_CASE("Bodies that spin past each other are searched in a few steps", "[unit][dynamics]") {
  // Turning cubes, found where they first touch to 1e-14 s; 39 separations at most. With the bound of
  // closing_bound() alone, which knows how fast corners are and not where they are, two cubes that
  // grazed each other took 1000.
  int found = 0;
  int most = 0;
  int sum = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    if (seed % 3 == 0) continue;  // a brick: its rate is not constant
    const Two two = random_two(seed);
    const Flight flight = two.flight();
    if (gap_at(flight, {0, 1}, 0.0).distance < 0.0) continue;
    SearchOptions how{.method = SearchMethod::conservative, .resolution = 1e-14};
    const PairCollision search = advance_to_collision(flight, {0, 1}, 0.0, 0.5, how);
    INFO(seed);
    CHECK(search.status != CollisionStatus::cap_reached);
    most = std::max(most, search.evaluations);
    sum += search.evaluations;
    if (search.status != CollisionStatus::found) continue;
    ++found;
    CHECK(gap_at(flight, {0, 1}, search.time).distance >= 0.0);
    CHECK(gap_at(flight, {0, 1}, search.overlap_time).distance < 0.0);
  }
  CHECK(found > 50);
  CHECK(most < 100);
  INFO(sum);
}

TEST_CASE("Cubes that touch and do not move against each other are not followed for ever",
          "[unit][dynamics]") {
  // A gap of rounding size and a speed of rounding size: resolution by resolution it would take 16667
  // separations.
  Two two;
  two.gravity_w.setZero();
  two.bodies.fill(box_properties(Vec3::Ones(), 1.0));
  two.states[0] = make_state(two.bodies[0], Vec3::Zero(), Quat::Identity(), Vec3(1.0, 0.0, 0.0));
  two.states[1] =
      make_state(two.bodies[1], Vec3(1.0, 0.3, 0.0), Quat::Identity(), Vec3(1.0 - 2e-16, 0.0, 0.0));
  const SearchOptions how{.method = SearchMethod::conservative, .resolution = 1e-6};
  const PairCollision search = advance_to_collision(two.flight(), {0, 1}, 0.0, 1.0 / 60.0, how);
  CHECK(search.evaluations < 30);
}
