/// \file
/// \brief Contact points of boxes that are almost aligned lie on both boxes.
#include "tumble/geometry/manifold.hpp"
#include "tumble/geometry/nearest_point.hpp"
#include "tumble/geometry/signed_distance.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

struct Pair {
  Box first, second;
  double shortest, longest;  // [m] edge
};

// An offset at which two boxes of these sizes overlap along an axis, or just touch or miss.
double offset(Random& random, double reach, double shortest) {
  if (random.uniform(0.0, 1.0) < 0.5) return reach * random.uniform(-1.0, 1.0);
  const double gap = shortest * std::pow(10.0, random.uniform(-12.0, -2.5));
  const double out = reach + (random.uniform(0.0, 1.0) < 0.5 ? -gap : gap);
  return std::copysign(out, random.uniform(-1.0, 1.0));
}

// Boxes of sizes 1:100 that are turned against each other by 1e-12 to 1e-1 rad, or not at all.
Pair almost_aligned(Random& random) {
  const double angle =
      random.uniform(0.0, 1.0) < 0.1 ? 0.0 : std::pow(10.0, random.uniform(-12.0, -1.0));
  const Quat turn = about(random.in_cube(1.0), angle);
  const Quat whole = random.orientation();
  Vec3 size_a, size_b, apart;
  for (int k = 0; k < 3; ++k) {
    size_a[k] = std::pow(10.0, random.uniform(-1.0, 1.0));
    size_b[k] = std::pow(10.0, random.uniform(-1.0, 1.0));
  }
  const double shortest = std::min(size_a.minCoeff(), size_b.minCoeff());
  for (int k = 0; k < 3; ++k) apart[k] = offset(random, 0.5 * (size_a[k] + size_b[k]), shortest);
  return {make_box(Vec3::Zero(), whole, size_a),
          make_box(whole * apart, (whole * turn).normalized(), size_b), shortest,
          std::max(size_a.maxCoeff(), size_b.maxCoeff())};
}

// Boxes of sizes 1:1e6 that meet in edges or corners, but for rounding, and are turned by about as little.
Pair just_touching(Random& random) {
  const double angle = random.unit() < 0.5 ? 0.0 : std::pow(10.0, random.uniform(-16.0, -11.0));
  const Quat turn = about(random.in_cube(1.0), angle);
  const Quat whole = random.unit() < 0.5 ? Quat::Identity() : random.orientation();
  Vec3 size_a, size_b, apart;
  for (int k = 0; k < 3; ++k) {
    size_a[k] = std::pow(10.0, random.uniform(-3.0, 3.0));
    size_b[k] = std::pow(10.0, random.uniform(-3.0, 3.0));
  }
  const int overlapping = static_cast<int>(random.below(3));
  for (int k = 0; k < 3; ++k) {
    const double reach = 0.5 * (size_a[k] + size_b[k]);
    const double side = random.uniform(-1.0, 1.0);
    apart[k] = k == overlapping ? reach * side : std::copysign(reach, side);
  }
  return {make_box(Vec3::Zero(), whole, size_a),
          make_box(whole * apart, (whole * turn).normalized(), size_b),
          std::min(size_a.minCoeff(), size_b.minCoeff()),
          std::max(size_a.maxCoeff(), size_b.maxCoeff())};
}

struct Counts {
  int touching = 0, at_edges = 0, missed = 0;
  double worst = 0.0;  // [longest edge] off a box, beyond the margin and half the overlap
};

void count(const Pair& pair, double margin, Counts& counts) {
  Manifold m;
  if (!collide(pair.first, pair.second, margin, kNoAxis, m)) {
    if (separation(pair.first, pair.second, {.prefer_faces = false}).distance <= 0.0)
      ++counts.missed;
    return;
  }
  ++counts.touching;
  if (m.axis >= 6) ++counts.at_edges;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const ManifoldPoint& point = m.points[i];
    const double off = std::max(signed_distance(pair.first, point.position_w).distance,
                                signed_distance(pair.second, point.position_w).distance);
    const double allowed = margin + 0.5 * std::max(-point.distance, 0.0);
    counts.worst = std::max(counts.worst, (off - allowed) / pair.longest);
  }
}

void check_pairs(int pairs, std::uint64_t seed) {
  Random random(seed);
  Counts counts;
  for (int n = 0; n < pairs; ++n) {
    const Pair pair = almost_aligned(random);
    count(pair, 1e-3 * pair.shortest, counts);
  }
  CHECK(counts.touching > pairs / 2);
  CHECK(counts.at_edges > pairs / 50);
  CHECK(counts.missed == 0);
  CHECK(counts.worst <= 1e-6);
}

}  // namespace

TEST_CASE("Contact points of 100000 pairs of almost aligned boxes lie on both boxes",
          "[unit][manifold]") {
  check_pairs(100000, 1);
}

TEST_CASE("Contact points of ten million pairs of almost aligned boxes lie on both boxes",
          "[unit][manifold][.long]") {
  check_pairs(10000000, 2);
}

TEST_CASE(
    "Contact points of boxes of 1 to a million that meet in corners and edges lie on both boxes",
    "[unit][manifold]") {
  Random random(3);
  Counts counts;
  for (int n = 0; n < 100000; ++n) {
    const Pair pair = just_touching(random);
    count(pair, random.unit() < 0.5 ? 0.0 : 1e-3 * pair.shortest, counts);
  }
  CHECK(counts.touching > 50000);
  CHECK(counts.worst <= 1e-6);
}

TEST_CASE("Edges turned by 1e-9 rad touch in the middle of the stretch that they share",
          "[exact][manifold]") {
  // The edges along y of two boxes lie beside each other from y = 0 to 0.5.
  const Box lower = cube_at(Vec3::Zero());
  const Box upper = make_box({1.0, 0.3, 1.0}, about({1.0, 0.0, 1.0}, 1e-9), {1.0, 0.6, 1.0});
  Separation edges{.normal_w = Vec3(1.0, 0.0, 1.0).normalized(), .axis = 6 + 3 * 1 + 1};
  Manifold m;
  find_manifold(lower, upper, edges, 0.1, m);
  REQUIRE(m.count == 1);
  CHECK((m.points[0].position_w - Vec3(0.5, 0.25, 0.5)).norm() < 1e-8);
}

TEST_CASE("Boxes apart with two edges side by side touch at both ends of the stretch they share",
          "[exact][manifold]") {
  // Two cards of a tent.
  const double lean = 65.0 * std::numbers::pi / 180.0;
  const Vec3 size(2.5, 0.02, 1.25);
  const Box left = make_box({-0.55, 1.0, 0.0}, about({0.0, 0.0, 1.0}, lean), size);
  const Box right = make_box({0.55, 1.0, 0.0}, about({0.0, 0.0, 1.0}, -lean), size);
  Manifold m;
  REQUIRE(collide(left, right, 0.2, kNoAxis, m));
  REQUIRE(m.count == 2);
  CHECK(m.points[0].feature != m.points[1].feature);
  CHECK(std::abs(m.points[0].position_w.x()) < 1e-12);
  CHECK(std::abs(m.points[1].position_w.x()) < 1e-12);
  CHECK(std::abs(m.points[0].position_w.z() - m.points[1].position_w.z()) == near(1.25, 1e-12));
}

TEST_CASE("A corner that comes down beside a face is seen before it is in", "[unit][manifold]") {
  constexpr double kMargin = 0.2, kNearer = 0.005;
  Random random(7);
  int missed = 0;
  for (int k = 0; k < 20000; ++k) {
    const Box first = cube_at(Vec3::Zero(), random.orientation());
    const Vec3 center_w = random.in_cube(1.5);
    const Box second = cube_at(center_w, random.orientation());
    const double apart = separation(first, second, {false, kMargin, kNoAxis}).distance;
    if (!(apart > 0.0 && apart < kMargin - kNearer)) continue;
    CAPTURE(k);
    Manifold m;
    if (!collide(first, second, kMargin, kNoAxis, m)) ++missed;
    add_nearest_point(first, second, kMargin, kNearer, m);
    REQUIRE(m.count > 0);
    const double along = (second.center_w - first.center_w).dot(m.normal_w) -
                         reach(first, m.normal_w) - reach(second, m.normal_w);
    double least = kMargin;
    for (int i = 0; i < m.count; ++i) least = std::min(least, m.points[idx(i)].distance);
    CHECK(least < along + kNearer + 1e-9);
    CHECK(least > -1e-9);
  }
  CHECK(missed > 50);  // by collide() alone
}
