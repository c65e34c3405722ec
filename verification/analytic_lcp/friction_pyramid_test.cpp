/// \file
/// \brief The problem of contact with friction: its matrix, small answers, and the pyramid's edges.
#include "tumble/analytic_lcp/friction_pyramid.hpp"

#include "tumble/lcp_solvers/lemke.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

constexpr double kPi = std::numbers::pi;

// The ground, and a particle of 1 kg on it.
std::vector<MovingBody> particle_on_floor() {
  std::vector<MovingBody> bodies(2);
  bodies[1].inverse_mass = Vec3::Ones();
  return bodies;
}

struct Solved {
  LcpStatus status = LcpStatus::solved;
  double residual = 0.0;
  std::vector<Vec3> pushes;
};

Solved solve(const FrictionPyramid& pyramid) {
  LemkeSolver lemke;
  LcpResult result;
  lemke.solve(pyramid.lcp(), result);
  Solved solved{result.status, result.residual, {}};
  pyramid.pushes(result.f, solved.pushes);
  return solved;
}

// The problem of a particle on the ground with a friction of 0.3.
FrictionPyramid particle(const FrictionPoint& point, int directions) {
  const std::array<Contact, 1> contacts{contact_at(0, 1, Vec3::Zero(), Vec3::UnitY(), 0.3)};
  FrictionPyramid pyramid;
  pyramid.assemble(particle_on_floor(), contacts, {&point, 1}, directions);
  return pyramid;
}

// A particle that slides over the ground for one step of 1/60 s, with the least friction on its way.
Solved slide(const Vec3& velocity_w, int directions) {
  return solve(particle({0, 0, -9.81 / 60.0, velocity_w, Vec3::Zero()}, directions));
}

MovingBody random_body(Random& random) {
  MovingBody body{.position_w = random.in_cube(1.0),
                  .inverse_mass = Vec3::Constant(random.uniform(0.2, 5.0))};
  Mat3 root;
  for (int k = 0; k < 9; ++k) root(k / 3, k % 3) = random.uniform(-1.0, 1.0);
  body.inverse_inertia_w = root * root.transpose();
  return body;
}

// Bodies 0 (fixed) to 3 with random contacts, some of them between the same two, in either order.
struct Heap {
  std::vector<MovingBody> bodies{4};
  std::vector<Contact> contacts;
  std::vector<FrictionPoint> points;
};

Heap random_heap(Random& random, int count, bool with_sliding) {
  Heap heap;
  for (int k = 1; k < 4; ++k) heap.bodies[idx(k)] = random_body(random);
  for (int k = 0; k < count; ++k) {
    const int first = static_cast<int>(random.below(4));
    const int second = (first + 1 + static_cast<int>(random.below(3))) % 4;
    const Vec3 place_w = random.in_cube(1.0);
    const Vec3 n = random.direction();
    heap.contacts.push_back(contact_at(first, second, place_w, n, random.uniform(0.1, 1.0)));
    FrictionPoint point{.contact = k};
    if (with_sliding && k % 2 == 0) point.sliding_w = n.cross(random.direction()).normalized();
    heap.points.push_back(point);
  }
  return heap;
}

// The largest angle between an arm of one cross and the nearest arm of another one [rad].
double turn_between(const Tangents& a, const Tangents& b) {
  const double along =
      std::max(std::abs(a.first_w.dot(b.first_w)), std::abs(a.first_w.dot(b.second_w)));
  return std::acos(std::min(1.0, along));
}

}  // namespace

TEST_CASE("The matrix of a sliding particle is that of Stewart and Trinkle",
          "[exact][pyramid][analytic_lcp]") {
  const FrictionPyramid pyramid = particle({0, 0, -0.1635, Vec3(3, 0, 0), Vec3::Zero()}, 4);
  const LcpProblem& lcp = pyramid.lcp();
  REQUIRE(lcp.size() == 6);
  CHECK(pyramid.has_friction());
  MatX expected(6, 6);
  expected << 1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 1, 0, -1, 1, 0, 0, 1, 0, 0, 0, 1, -1, 1, 0, 0, 0,
      -1, 1, 1, 0.3, -1, -1, -1, -1, 0;
  CHECK((lcp.A - expected).cwiseAbs().maxCoeff() == 0.0);
  // The arms of the cross are the world's axes, whichever comes first.
  CHECK(lcp.b[0] == -0.1635);
  CHECK(lcp.b.segment(1, 4).cwiseAbs().sum() == 6.0);
  CHECK(lcp.b[5] == 0.0);
}

TEST_CASE("One step of a sliding particle is Stewart and Trinkle's solution",
          "[exact][pyramid][analytic_lcp]") {
  for (const int directions : {4, 8}) {
    const Solved fast = slide(Vec3(3, 0, 0), directions);
    REQUIRE(fast.status == LcpStatus::solved);
    // [N s] rounding of numbers near 3: measured 0.
    CHECK((fast.pushes[0] - Vec3(-0.04905, 0.1635, 0)).norm() < 1e-15);
    const Solved slow = slide(Vec3(0.01, 0, 0), directions);
    REQUIRE(slow.status == LcpStatus::solved);
    CHECK((slow.pushes[0] - Vec3(-0.01, 0.1635, 0)).norm() < 1e-15);
  }
}

TEST_CASE("Friction of the pyramid is as strong as its cross section in the direction of sliding",
          "[exact][pyramid][analytic_lcp]") {
  // It acts along the edge most opposed to the sliding, so what slows the particle down is mu times
  // the cosine of the angle to the next edge: never below mu cos(180/d).
  const double limit = 0.3 * 9.81 / 60.0;  // [N s]
  for (const int directions : {4, 8}) {
    double weakest = 1.0;
    double worst = 0.0;
    for (int step = 0; step < 24; ++step) {
      const double angle = step * kPi / 12.0;
      const Vec3 sliding(std::cos(angle), 0, std::sin(angle));
      const Solved solved = slide(3.0 * sliding, directions);
      REQUIRE(solved.status == LcpStatus::solved);
      const double strength = -solved.pushes[0].dot(sliding) / limit;
      const double between = 2.0 * kPi / directions;
      const double off = std::abs(std::remainder(angle, between));
      worst = std::max(worst, std::abs(strength - std::cos(off)));
      weakest = std::min(weakest, strength);
    }
    CHECK(worst < 1e-13);                                  // [-] rounding: measured 3e-16
    CHECK(weakest >= std::cos(kPi / directions) - 1e-13);  // 0.7071, 0.9239
  }
}

TEST_CASE("Friction against a known sliding adds no unknown and has its direction",
          "[exact][pyramid][analytic_lcp]") {
  const Vec3 sliding(0.6, 0, -0.8);
  const FrictionPyramid pyramid = particle({0, 0, -9.81, Vec3::Zero(), sliding}, 8);
  REQUIRE(pyramid.lcp().size() == 1);
  const Solved solved = solve(pyramid);
  CHECK((solved.pushes[0] - 9.81 * (Vec3::UnitY() - 0.3 * sliding)).norm() < 1e-14);  // [N]
}

TEST_CASE("The problem predicts the motion that its pushes cause in 200 random heaps",
          "[exact][pyramid][analytic_lcp]") {
  Random random(41);
  double worst = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    Heap heap = random_heap(random, 6, true);
    FrictionPyramid pyramid;
    pyramid.assemble(heap.bodies, heap.contacts, heap.points, trial % 2 == 0 ? 4 : 8);
    const LcpProblem& lcp = pyramid.lcp();
    std::vector<double> f;
    for (int k = 0; k < lcp.size(); ++k) f.push_back(random.uniform(0.0, 1.0));
    std::vector<double> motion(f.size());
    multiply(lcp.A, f, motion);
    std::vector<Vec3> pushes;
    pyramid.pushes(f, pushes);
    for (std::size_t p = 0; p < pushes.size(); ++p) {
      const Contact& contact = heap.contacts[p];
      apply_impulse(heap.bodies[idx(contact.first)], heap.bodies[idx(contact.second)],
                    contact.points[0].position_w, pushes[p]);
    }
    // The row of c is the motion along the normal, that of the first beta along the first arm, where
    // s times the unknown of lambda is added.
    int row = 0;
    for (std::size_t p = 0; p < pushes.size(); ++p) {
      const Contact& contact = heap.contacts[p];
      const Vec3 u =
          relative_velocity(heap.bodies[idx(contact.first)], heap.bodies[idx(contact.second)],
                            contact.points[0].position_w);
      worst = std::max(worst, std::abs(motion[idx(row)] - contact.normal_w.dot(u)));
      if (heap.points[p].sliding_w.isZero(0.0)) {
        const int directions = trial % 2 == 0 ? 4 : 8;
        const int lambda = row + directions + 1;
        const Vec3 t = pyramid_axes(contact.normal_w).first_w;
        const double expected = t.dot(u) + lcp.A(row + 1, lambda) * f[idx(lambda)];
        worst = std::max(worst, std::abs(motion[idx(row + 1)] - expected));
        row = lambda;
      }
      ++row;
    }
  }
  CHECK(worst < 1e-11);  // [m/s] sums of about 60 terms up to 100: measured 7e-15
}

// --- the cross of a normal ----------------------------------------------------------------------

TEST_CASE("The cross of a normal is a frame, the world's axes for the world's axes",
          "[exact][pyramid][analytic_lcp]") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const Tangents t = pyramid_axes(sign * Vec3::Unit(axis));
      CHECK(t.first_w.cwiseAbs().maxCoeff() == 1.0);
      CHECK(t.second_w.cwiseAbs().maxCoeff() == 1.0);
    }
  Random random(53);
  double worst = 0.0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 n = random.direction();
    const Tangents t = pyramid_axes(n);
    worst = std::max(worst, (t.first_w.cross(t.second_w) - n).norm());
    worst = std::max(worst, std::abs(t.first_w.norm() - 1.0));
  }
  CHECK(worst < 1e-14);  // [-] rounding: measured 4e-16
}

TEST_CASE("The cross of a normal turns smoothly except near the space diagonals",
          "[exact][pyramid][analytic_lcp]") {
  Random random(59);
  const double step = 1e-4;  // [rad]
  double fastest = 0.0;      // how much faster than the normal the cross turns
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 n = random.direction();
    const double diagonal = n.cwiseAbs().sum() / std::sqrt(3.0);
    if (diagonal > std::cos(0.2)) continue;  // within 11 degrees of one of the eight
    const Vec3 turned = rotation_from_vector(step * n.cross(random.direction())) * n;
    fastest = std::max(fastest, turn_between(pyramid_axes(n), pyramid_axes(turned)) / step);
  }
  // Measured 1.5 near the limit of 0.2 rad, less farther off; a jump would give 10 000.
  CHECK(fastest < 3.0);
}

// --- refusals -----------------------------------------------------------------------------------

TEST_CASE("The problem with friction refuses what makes no sense",
          "[unit][pyramid][analytic_lcp]") {
  const std::vector<MovingBody> bodies = particle_on_floor();
  std::array<Contact, 1> contacts{contact_at(0, 1, Vec3::Zero(), Vec3::UnitY(), 0.3)};
  std::array<FrictionPoint, 1> points{};
  FrictionPyramid pyramid;
  const auto assemble = [&](int directions) {
    pyramid.assemble(bodies, contacts, points, directions);
  };
  CHECK_THROWS_WITH(assemble(6), Contains("directions = 6"));
  points[0].point = 1;
  CHECK_THROWS_WITH(assemble(4), Contains("points: point = 1"));
  points[0] = {};
  points[0].contact = -1;
  CHECK_THROWS_WITH(assemble(4), Contains("points: contact = -1"));
  points[0] = {};
  points[0].sliding_w = Vec3(2, 0, 0);
  CHECK_THROWS_WITH(assemble(4), Contains("sliding_w"));
  points[0] = {};
  points[0].normal_constant = kNan;
  CHECK_THROWS_WITH(assemble(4), Contains("normal_constant"));
  points[0] = {};
  contacts[0].second = 2;
  CHECK_THROWS_WITH(assemble(4), Contains("contact.second = 2"));
  contacts[0].second = 1;
  contacts[0].friction = -1.0;
  CHECK_THROWS_WITH(assemble(4), Contains("contact.friction"));
  contacts[0].friction = 0.3;
  assemble(4);
  std::vector<Vec3> pushes;
  CHECK_THROWS_WITH(pyramid.pushes(std::vector<double>(5), pushes), Contains("give 6"));
}
