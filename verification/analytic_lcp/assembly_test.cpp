/// \file
/// \brief The problem of contact forces: matrices and statics known in closed form.
#include "tumble/base/random.hpp"
#include "tumble/contact/effective_mass.hpp"

#include "analytic_lcp/instant.hpp"
#include "dynamics/random_bodies.hpp"
#include "support/touching.hpp"

#include <array>
#include <cmath>

namespace {

using Catch::Matchers::Contains;

Instant cube_on_ground() {
  World world = ground_world();
  add_box(world, Vec3::Ones(), 1.0, Vec3(0, 0.5, 0));
  return Instant(world);
}

// The rows of the corners (x, z) = (-, -), (+, -), (+, +), (-, +) of a cube on the ground.
std::array<int, 4> rows_of_corners(const Instant& cube) {
  std::array<int, 4> rows{};
  for (int i = 0; i < 4; ++i) {
    const Vec3& p = cube.place(idx(i));
    rows[p.z() < 0.0 ? (p.x() < 0.0 ? 0 : 1) : (p.x() < 0.0 ? 3 : 2)] = i;
  }
  return rows;
}

}  // namespace

// --- matrices and statics -----------------------------------------------------------------------

TEST_CASE("The matrix of a cube on the ground is singular and has the rows (4, 1, -2, 1)",
          "[exact][assembly][analytic_lcp]") {
  Instant cube = cube_on_ground();
  cube.assemble();
  const LcpProblem& lcp = cube.problem.lcp();
  REQUIRE(lcp.size() == 4);
  const std::array<int, 4> rows = rows_of_corners(cube);
  const std::array<double, 4> expected{4.0, 1.0, -2.0, 1.0};  // [1/kg] and so on round the corners
  double worst = 0.0;
  for (int i = 0; i < 4; ++i) {
    double null = 0.0;  // A (1, -1, 1, -1)
    for (int j = 0; j < 4; ++j) {
      const double a = lcp.A(rows[idx(i)], rows[idx(j)]);
      worst = std::max(worst, std::abs(a - expected[idx((j - i + 4) % 4)]));
      null += j % 2 == 0 ? a : -a;
    }
    worst = std::max({worst, std::abs(null), std::abs(lcp.b[rows[idx(i)]] + kG)});
  }
  CHECK(worst < 1e-14);  // [1/kg], [m/s²] rounding of products near 4: measured 0
  CHECK(lcp.equality.empty());
  CHECK(lcp.factors.bodies.size() == 1);  // the ground has no block
}

TEST_CASE("A torque of -6 N m tips a cube over its right edge", "[exact][assembly][analytic_lcp]") {
  Instant cube = cube_on_ground();
  cube.external[1].torque_w.z() = -6.0;
  cube.solve();
  const std::array<int, 4> rows = rows_of_corners(cube);
  const std::array<double, 4> b{8.19, -27.81, -27.81, 8.19};
  const std::array<double, 4> f{0.0, 5.562, 5.562, 0.0};
  const std::array<double, 4> a{2.628, 0.0, 0.0, 2.628};
  for (std::size_t i = 0; i < 4; ++i) {
    // Rounding of sums of a few numbers near 30.
    CHECK(cube.problem.lcp().b[rows[i]] == Approx(b[i]).epsilon(1e-14));
    CHECK(cube.answer.f[idx(rows[i])] == Approx(f[i]).epsilon(1e-13).margin(1e-13));
    CHECK(cube.answer.a[idx(rows[i])] == Approx(a[i]).epsilon(1e-13).margin(1e-13));
  }
}

TEST_CASE("The contacts of a stack bear what is above them", "[exact][assembly][analytic_lcp]") {
  World world = ground_world();
  for (int k = 0; k < 5; ++k) add_box(world, Vec3::Ones(), 1.0, Vec3(0, 0.5 + k, 0));
  Instant stack(world);
  stack.solve();
  CHECK(stack.problem.lcp().size() == 20);
  for (int k = 0; k < 5; ++k)
    CHECK(stack.force_between(k, k + 1) == Approx((5 - k) * kG).epsilon(1e-12));
  CHECK(stack.unrest() < 1e-12);  // [m/s²] rounding with 20 rows: measured 3e-14

  // With one point for each contact the matrix is (1, 2, 2, ...), -1 beside the diagonal.
  for (Contact& contact : stack.contacts)
    contact = contact_at(contact.first, contact.second, Vec3(0, contact.first, 0), Vec3::UnitY());
  stack.solve();
  const LcpProblem& lcp = stack.problem.lcp();
  for (int i = 0; i < 5; ++i) {
    CHECK(lcp.b[i] == (i == 0 ? -kG : 0.0));
    for (int j = 0; j < 5; ++j)
      CHECK(lcp.A(i, j) == (i == j ? (i == 0 ? 1.0 : 2.0) : (std::abs(i - j) == 1 ? -1.0 : 0.0)));
    CHECK(stack.answer.f[idx(i)] == Approx((5 - i) * kG).epsilon(1e-14));
  }
}

TEST_CASE("The force on the edge of a rocking block is its weight less what its swing takes",
          "[exact][assembly][analytic_lcp]") {
  // Edge at (x, -y) from the centre: the edge's centripetal acceleration is w² y upwards.
  const double tilt = 0.3, omega = 1.7, mass = 4.0, w = 0.4, h = 2.0;
  const Quat orientation = about(Vec3::UnitZ(), -tilt);
  const Vec3 edge = orientation * Vec3(0.5 * w, -0.5 * h, 0);
  World world = ground_world();
  add_box(world, Vec3(w, h, 1.0), mass, Vec3(0, -edge.y(), 0), orientation,
          Vec3(0, -omega * edge.x(), 0), Vec3(0, 0, omega));
  Instant block(world);
  block.solve();
  REQUIRE(block.problem.lcp().size() == 2);
  CHECK(block.problem.fastest_approach() < 1e-15);
  const double inertia = mass / 12.0 * (w * w + h * h);
  const double load =
      (kG + omega * omega * edge.y()) / (1.0 / mass + edge.x() * edge.x() / inertia);
  CHECK(block.problem.lcp().b[0] == Approx(-kG - omega * omega * edge.y()).epsilon(1e-14));
  CHECK(block.force_between(0, 1) == Approx(load).epsilon(1e-13));
  CHECK(block.accelerations[1].angular_w.z() == Approx(edge.x() * load / inertia).epsilon(1e-13));
}

// --- assembly and answer together -------------------------------------------------------------------------

namespace {

// Boxes thrown together, as they touch or overlap; some immovable, on the ground.
Instant random_heap(std::uint64_t seed) {
  Random random(seed);
  World world;
  if (seed % 3 != 0) world.add_ground();
  for (int k = 0; k < 8; ++k) {
    const BodyProperties body = random_box(random);
    const BodyState state = random_state(random, body, 1.0, 2.0, 3.0);
    if (random.below(6) == 0) {
      add_fixed(world, body.size, state.position_w, state.orientation_wb);
    } else {
      world.add(body, state);
    }
  }
  return Instant(world);
}

}  // namespace

TEST_CASE("With forces on the bodies, assembling again gives A f + b",
          "[exact][assembly][analytic_lcp]") {
  double worst = 0.0, worst_diagonal = 0.0, least_square = 1.0;
  int rows = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Instant heap = random_heap(seed);
    heap.assemble();
    const LcpProblem lcp = heap.problem.lcp();
    Random random(seed);
    std::vector<double> f(idx(lcp.size())), a(idx(lcp.size()));
    for (double& force : f) force = random.uniform(-10.0, 10.0);
    multiply(lcp.A, f, a);
    double square = 0.0, scale = 0.0;
    for (int i = 0; i < lcp.size(); ++i) {
      square += f[idx(i)] * a[idx(i)];
      scale += f[idx(i)] * f[idx(i)] * lcp.A(i, i);
      a[idx(i)] += lcp.b[i];
      const Contact& contact = heap.contacts[idx(heap.problem.rows()[idx(i)].contact)];
      const double mass =
          effective_mass(heap.bodies[idx(contact.first)], heap.bodies[idx(contact.second)],
                         heap.place(idx(i)), contact.normal_w);
      worst_diagonal = std::max(worst_diagonal, std::abs(lcp.A(i, i) * mass - 1.0));
    }
    if (scale > 0.0) least_square = std::min(least_square, square / scale);
    heap.wrenches.assign(heap.bodies.size(), Wrench());
    heap.problem.add_wrenches(f, heap.wrenches);
    accelerate(heap.bodies, heap.wrenches, heap.accelerations);
    heap.problem.assemble(heap.world, heap.bodies, heap.accelerations, heap.contacts, kAll);
    for (int i = 0; i < lcp.size(); ++i)
      worst = std::max(worst, std::abs(heap.problem.lcp().b[i] - a[idx(i)]));
    rows += lcp.size();
  }
  CHECK(rows > 500);
  CHECK(worst < 1e-11);           // [m/s²] rounding of sums of some hundreds: measured 9e-14
  CHECK(worst_diagonal < 1e-12);  // [-] n K n, from the other end: measured 7e-16
  CHECK(least_square > -1e-14);   // [-] f·A f is not negative
}

TEST_CASE("A point that separates faster than asked has no row", "[unit][assembly][analytic_lcp]") {
  World world = ground_world();
  // It turns about its left edge: the right one lifts off with 0.5 m/s.
  add_box(world, Vec3::Ones(), 1.0, Vec3(0, 0.5, 0), Quat::Identity(), Vec3(0, 0.25, 0),
          Vec3(0, 0, 0.5));
  Instant cube(world);
  cube.assemble();
  CHECK(cube.problem.rows().size() == 4);
  CHECK(cube.problem.separating() == 0);
  const auto assemble = [&cube](double speed) {
    cube.problem.assemble(cube.world, cube.bodies, cube.accelerations, cube.contacts, speed);
  };
  assemble(0.6);
  CHECK(cube.problem.separating() == 0);
  assemble(0.4);
  CHECK(cube.problem.separating() == 2);
  REQUIRE(cube.problem.rows().size() == 2);
  CHECK(cube.place(0).x() == -0.5);
  CHECK(cube.place(1).x() == -0.5);
  CHECK(cube.problem.fastest_approach() == 0.0);
  cube.bodies[1].velocity_w.y() = 0.0;  // now the left edge goes down with 0.25 m/s
  assemble(0.0);
  CHECK(cube.problem.separating() == 2);
  CHECK(cube.problem.fastest_approach() == 0.25);
  cube.contacts.clear();
  assemble(0.0);
  CHECK(cube.problem.lcp().size() == 0);
  CHECK(cube.problem.fastest_approach() == 0.0);
}

TEST_CASE("A problem that does not fit its world is refused", "[unit][assembly][analytic_lcp]") {
  Instant cube = cube_on_ground();
  cube.assemble();
  std::vector<MovingBody> one(1);
  std::vector<Acceleration> three(3);
  std::vector<Wrench> wrenches(2);
  CHECK_THROWS_WITH(free_accelerations(cube.world, one, three),
                    Contains("bodies: 1 entries; 2 are needed"));
  const auto assemble = [&cube](double speed) {
    cube.problem.assemble(cube.world, cube.bodies, cube.accelerations, cube.contacts, speed);
  };
  CHECK_THROWS_WITH(assemble(-1.0), Contains("separation_speed = -1: give at least 0"));
  CHECK_THROWS_AS(assemble(std::nan("")), std::invalid_argument);
  CHECK_THROWS_WITH(cube.problem.assemble(cube.world, one, cube.accelerations, cube.contacts, 0.0),
                    Contains("bodies: 1"));
  CHECK_THROWS_WITH(cube.problem.assemble(cube.world, cube.bodies, three, cube.contacts, 0.0),
                    Contains("free: 3"));
  CHECK_THROWS_WITH(cube.problem.add_wrenches(std::vector<double>(5), wrenches),
                    Contains("f: 5 entries; 4 are needed"));
  wrenches.resize(1);
  CHECK_THROWS_WITH(cube.problem.add_wrenches(std::vector<double>(4), wrenches),
                    Contains("wrenches: 1"));
  CHECK_THROWS_WITH(accelerate(cube.bodies, wrenches, cube.accelerations), Contains("wrenches"));
  cube.contacts[0].axis = 15;
  CHECK_THROWS_WITH(assemble(0.0), Contains("contact.axis = 15"));
  cube.contacts[0].axis = 6;  // but the ground's edges and the cube's are parallel
  CHECK_THROWS_WITH(assemble(0.0), Contains("parallel"));
  cube.contacts[0].axis = kNoAxis;
  cube.contacts[0].second = 2;
  CHECK_THROWS_WITH(assemble(0.0), Contains("body 2"));
  cube.contacts[0].second = -1;
  CHECK_THROWS_AS(assemble(0.0), std::invalid_argument);
  cube.contacts[0].second = 1;
  assemble(0.0);  // and it works again
  CHECK(cube.problem.lcp().size() == 4);
}
