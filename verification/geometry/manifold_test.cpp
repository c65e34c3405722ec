/// \file
/// \brief Contact areas of two boxes: closed forms, symmetries, and the degenerate cases.
#include "tumble/geometry/manifold.hpp"

#include "geometry/boxes.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

const ManifoldPoint& point(const Manifold& m, int i) { return m.points[idx(i)]; }

Manifold collided(const Box& a, const Box& b, double margin = 0.0, AxisIndex remembered = kNoAxis) {
  Manifold m;
  collide(a, b, margin, remembered, m);
  return m;
}

double deepest(const Manifold& m) {
  double least = kInfinity;
  for (int i = 0; i < m.count; ++i) least = std::min(least, point(m, i).distance);
  return least;
}

std::set<FeatureId> names(const Manifold& m) {
  std::set<FeatureId> out;
  for (int i = 0; i < m.count; ++i) out.insert(point(m, i).feature);
  return out;
}

// The area around which the points of a level contact lie, seen from above.
double area_from_above(const Manifold& m) {
  double twice = 0.0;  // triangles that fan out from the first point
  for (int i = 2; i < m.count; ++i) {
    const Vec3 p_w = point(m, i - 1).position_w - point(m, 0).position_w;
    const Vec3 q_w = point(m, i).position_w - point(m, 0).position_w;
    twice += p_w.cross(q_w).y();
  }
  return 0.5 * std::abs(twice);
}

// How far a point is from the surface of a box: the largest excess over a half size.
double off_surface(const Box& box, const Vec3& p_w) {
  const Vec3 p = box.axes_w.transpose() * (p_w - box.center_w);
  return std::abs((p.cwiseAbs() - box.half).maxCoeff());
}

// The largest distance of a point of one manifold to the nearest one of the other, both ways.
double mismatch(const Manifold& a, const Manifold& b) {
  double worst = 0.0;
  for (int both = 0; both < 2; ++both) {
    const Manifold& m = both == 0 ? a : b;
    const Manifold& other = both == 0 ? b : a;
    for (int i = 0; i < m.count; ++i) {
      double nearest = kInfinity;
      for (int j = 0; j < other.count; ++j)
        nearest = std::min(nearest, (point(m, i).position_w - point(other, j).position_w).norm() +
                                        std::abs(point(m, i).distance - point(other, j).distance));
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

struct Pair {
  Box a, b;
};

Vec3 sizes(Random& random) {
  const double x = random.uniform(0.3, 2.0);
  const double y = random.uniform(0.3, 2.0);
  const double z = random.uniform(0.3, 2.0);
  return {x, y, z};
}

// A box on a box, `depth` deep, yawed by `yaw` and tilted by `tilt`; the pair turned by `whole`.
Pair stacked(Random& random, double depth, double yaw, double tilt, bool level) {
  const Quat whole = level ? Quat::Identity() : random.orientation();
  const Vec3 size_a = sizes(random);
  const Vec3 size_b = random.below(3) == 0 ? size_a : sizes(random);
  const Vec3 aside = random.in_cube(0.4);
  const Vec3 axis = random.direction();
  const Vec3 offset(aside.x(), 0.5 * (size_a.y() + size_b.y()) - depth, aside.z());
  const Quat turn = about(axis, tilt) * about(Vec3::UnitY(), yaw);
  Pair pair{make_box(Vec3::Zero(), whole, size_a),
            make_box(whole * offset, Quat((whole * turn).normalized()), size_b)};
  if (yaw == 0.0 && tilt == 0.0) pair.b.axes_w = pair.a.axes_w;  // exactly parallel
  return pair;
}

Pair anyhow(Random& random) {
  const Quat q = random.orientation();
  const Quat other = random.orientation();
  const Vec3 size_a = sizes(random);
  const Vec3 size_b = sizes(random);
  const double apart = random.uniform(0.0, 1.6);
  const Vec3 offset = apart * random.direction();
  return {make_box(Vec3::Zero(), q, size_a), make_box(offset, other, size_b)};
}

}  // namespace

TEST_CASE("The contact of two stacked cubes has the area in which their faces overlap",
          "[exact][manifold]") {
  struct Case {
    Vec3 lower, upper;
    double x, z, yaw, area;
    int points;
  };
  const Case cases[] = {
      {Vec3::Ones(), Vec3::Ones(), 0.0, 0.0, M_PI_4, 0.828427124746, 8},
      {Vec3::Ones(), Vec3::Ones(), 0.0, 0.0, M_PI / 6.0, 0.845299461621, 8},
      {Vec3::Ones(), Vec3::Ones(), 0.3, 0.2, 0.0, 0.56, 4},
      {Vec3::Ones(), Vec3::Ones(), 0.0, 0.0, 0.0, 1.0, 4},
      {{2, 1, 1}, {1, 1, 2}, 0.0, 0.0, 0.0, 1.0, 4},
      {Vec3::Ones(), {2, 1, 1}, 0.0, 0.0, M_PI_4, 0.914213562373, 6},
      {{4, 1, 4}, Vec3::Ones(), 0.5, 0.2, 0.3, 1.0, 4},
  };
  for (const Case& c : cases) {
    const Box lower = make_box(Vec3::Zero(), Quat::Identity(), c.lower);
    const Box upper = make_box({c.x, 0.99, c.z}, about(Vec3::UnitY(), c.yaw), c.upper);
    const Manifold m = collided(lower, upper);
    CAPTURE(c.area);
    CHECK(m.count == c.points);
    CHECK(area_from_above(m) == near(c.area, 3e-12));  // digits given, clip slack
    CHECK((m.normal_w - Vec3::UnitY()).norm() < 1e-15);
    for (int i = 0; i < m.count; ++i) {
      CHECK(point(m, i).distance == near(-0.01, 1e-15));
      CHECK(point(m, i).position_w.y() == near(0.495, 1e-15));
    }
  }
}

TEST_CASE("Two crossing edges touch in the one point between them", "[exact][manifold]") {
  const Box lower = cube_at(Vec3::Zero(), about(Vec3::UnitZ(), M_PI_4));
  const Box upper = cube_at({0.1, 1.4, 0.2}, about(Vec3::UnitX(), M_PI_4));
  const Manifold m = collided(lower, upper);
  REQUIRE(m.count == 1);
  CHECK(m.axis == 6 + 3 * 2 + 0);
  CHECK((m.normal_w - Vec3::UnitY()).norm() < 1e-15);
  CHECK(point(m, 0).distance == near(1.4 - std::sqrt(2.0), 1e-15));
  // The lower edge runs along z at x = 0, the upper along x at z = 0.2; halfway in height.
  CHECK((point(m, 0).position_w - Vec3(0.0, 0.7, 0.2)).norm() < 1e-15);
}

TEST_CASE("A beam across an edge gets a point at each end of the edge", "[unit][manifold]") {
  // It rolls on the cube's edge by 0.02 rad, and touches it with one of its own edges.
  const Box cube = cube_at(Vec3::Zero());
  const Quat roll = about(Vec3::UnitX(), 0.02) * about(Vec3::UnitZ(), -0.3);
  const Box beam =
      make_box(Vec3(0.5, 0.5, 0.0) + roll * Vec3(0.1, 0.145, 0.0), roll, Vec3(1.4, 0.3, 0.4));
  Manifold m = collided(cube, beam);
  REQUIRE(m.axis >= 6);
  REQUIRE(m.count == 1);
  const ManifoldPoint first = point(m, 0);
  add_face_points(cube, beam, 0.02, m);
  REQUIRE(m.count >= 2);
  CHECK(point(m, 0).position_w == first.position_w);
  // The other end, higher by the roll of the beam over its width.
  bool found = false;
  for (int i = 1; i < m.count; ++i)
    found =
        found || (std::abs(point(m, i).position_w.z() + first.position_w.z()) < 0.01 &&
                  std::abs(point(m, i).distance - first.distance - 0.4 * std::tan(0.02)) < 1e-3);
  CHECK(found);
}

TEST_CASE("Points of faces beside crossing edges are as far apart as a ray along the normal says",
          "[unit][manifold]") {
  Random random(7);
  int looked_at = 0, agree = 0;
  for (int k = 0; k < 20000; ++k) {
    const Box a = random_box(random, 0.6, 1.0, 0.3);
    const Box b = random_box(random, 0.6, 1.0, 0.3);
    Manifold m = collided(a, b, 0.1);
    if (m.axis < 6 || m.count != 1 || point(m, 0).distance < 0.0) continue;
    add_face_points(a, b, 0.1, m);
    for (int i = 1; i < m.count; ++i) {
      const Vec3 from_w = point(m, i).position_w - 5.0 * m.normal_w;
      const Stretch in_a = stretch_in(a, from_w, m.normal_w);
      const Stretch in_b = stretch_in(b, from_w, m.normal_w);
      CHECK(point(m, i).distance <= 0.1);
      if (in_a.empty() || in_b.empty()) continue;  // it lies on the border of a face
      ++looked_at;
      agree += static_cast<int>(std::abs(in_b.enter - in_a.leave - point(m, i).distance) < 1e-6);
    }
  }
  CHECK(looked_at > 500);
  // Where a point lies on the border, rounding may send the ray through the side of a box.
  CHECK(agree > 0.98 * looked_at);
}

TEST_CASE("Boxes exactly on each other touch with margin 0, and 1e-9 above only with a margin",
          "[exact][manifold]") {
  CHECK(collided(cube_at({0, 0, 0}), cube_at({0, 1, 0})).count == 4);
  CHECK(collided(cube_at({0, 0, 0}), cube_at({0, 1 + 1e-9, 0})).count == 0);
  CHECK(collided(cube_at({0, 0, 0}), cube_at({0, 1 + 1e-9, 0}), 1e-8).count == 4);
  CHECK(deepest(collided(cube_at({0, 0, 0}), cube_at({0, 1, 0}))) == 0.0);
}

TEST_CASE("Faces that meet in a line have two points, in a corner one", "[exact][manifold]") {
  const Box lower = cube_at(Vec3::Zero());
  CHECK(collided(lower, cube_at({1, 1, 0})).count == 2);    // edge on edge
  CHECK(collided(lower, cube_at({1, 1, 0.3})).count == 2);  // edge on edge, shifted
  CHECK(collided(lower, cube_at({1, 1, 1})).count == 1);    // corner on corner
  const double low = std::sqrt(0.5);
  // A cube standing on an edge, in the middle of a face and along the edge of one.
  const Quat on_edge = about(Vec3::UnitZ(), M_PI_4);
  CHECK(collided(lower, cube_at({0, 0.5 + low - 1e-6, 0}, on_edge)).count == 2);
  CHECK(collided(lower, cube_at({0.5, 0.5 + low - 1e-6, 0}, on_edge)).count == 2);
  CHECK(collided(lower, cube_at({0.5, 0.5 + low, 0.2}, on_edge), 1e-9).count == 2);
  // And on a corner.
  const Quat on_corner = test::on_corner();
  const Manifold corner =
      collided(lower, cube_at({0.1, 0.5 + std::sqrt(0.75) - 1e-6, 0}, on_corner));
  CHECK(corner.count == 1);
  CHECK(deepest(corner) == near(-1e-6, 1e-15));
}

TEST_CASE("Face to face, the order of the boxes turns only the normal", "[unit][manifold]") {
  Random random(2);
  double worst_parallel = 0.0, worst_tilted = 0.0, worst_normal = 0.0;
  int names_differ = 0, few = 0;
  for (int n = 0; n < 30000; ++n) {
    const double depth = random.uniform(0.0, 0.01);
    const double yaw = n % 3 == 0 ? 0.0 : random.uniform(-4.0, 4.0);
    const double tilt = n % 2 == 0 ? 0.0 : random.uniform(1e-6, 3e-3);
    const Pair pair = stacked(random, depth, yaw, tilt, n % 5 == 0);
    const Manifold one = collided(pair.a, pair.b, 0.01);
    const Manifold other = collided(pair.b, pair.a, 0.01);
    worst_normal = std::max(worst_normal, (one.normal_w + other.normal_w).norm());
    double& worst = tilt == 0.0 ? worst_parallel : worst_tilted;
    worst = std::max(worst, mismatch(one, other) + std::abs(deepest(one) - deepest(other)));
    if (one.count != other.count) ++names_differ;
    if (one.count < 3) ++few;
  }
  CHECK(few < 3000);              // most are areas, not lines; measured 937
  CHECK(worst_normal < 1e-14);    // the same face is the reference; rounding only. Measured 2e-15
  CHECK(worst_parallel < 1e-13);  // [m] rounding; measured 0: the very same sums
  CHECK(worst_tilted < 1e-13);    // [m] rounding; measured 3e-15
  CHECK(names_differ == 0);
}

TEST_CASE("Every overlap has a point, and every point is where it says", "[unit][manifold]") {
  Random random(3);
  int empty = 0, doubled = 0, beyond = 0, too_far = 0, overlaps = 0, many = 0, edges = 0;
  double worst_surface = 0.0, worst_deepest = 0.0, worst_apart = 0.0;
  for (int n = 0; n < 60000; ++n) {
    const double depth = random.uniform(-0.005, 0.05);
    const double yaw = random.uniform(-4.0, 4.0);
    const double tilt = random.uniform(-0.1, 0.1);
    const Pair pair = n % 2 == 0 ? anyhow(random) : stacked(random, depth, yaw, tilt, false);
    const double margin = n % 3 == 0 ? 0.0 : 0.01;

    // The exact axis: then the deepest point is as deep as the boxes.
    const Separation found =
        separation(pair.a, pair.b, {.prefer_faces = false, .enough = kInfinity});
    Manifold m;
    find_manifold(pair.a, pair.b, found, margin, m);
    if (found.distance <= 0.0) {
      if (m.count == 0) ++empty;
      worst_deepest = std::max(worst_deepest, std::abs(deepest(m) - found.distance));
    }
    // The axis that a simulation would use, remembered or not.
    const AxisIndex remembered = n % 5 == 0 ? static_cast<AxisIndex>(random.below(15)) : kNoAxis;
    Manifold used;
    collide(pair.a, pair.b, margin, remembered, used);
    if (found.distance <= 0.0 && used.count == 0) ++empty;
    if (found.distance > margin && used.count > 0) ++too_far;
    if (used.count == 0) continue;
    ++overlaps;
    if (used.count > 4) ++many;
    if (used.axis >= 6) ++edges;
    if (static_cast<int>(names(used).size()) != used.count) ++doubled;
    for (Manifold* any : {&m, &used}) {
      for (int i = 0; i < any->count; ++i) {
        const ManifoldPoint& p = point(*any, i);
        if (!(p.distance <= margin)) ++beyond;
        const Vec3 half_way = 0.5 * p.distance * any->normal_w;
        const double off = std::max(off_surface(pair.a, p.position_w - half_way),
                                    off_surface(pair.b, p.position_w + half_way));
        // Boxes that are apart may pass each other beyond the ends of their edges.
        double& worst = found.distance <= 0.0 ? worst_surface : worst_apart;
        worst = std::max(worst, off);
      }
    }
  }
  CHECK(overlaps > 30000);
  CHECK(many > 3000);
  CHECK(edges > 3000);
  CHECK(empty == 0);
  CHECK(too_far == 0);
  CHECK(doubled == 0);
  CHECK(beyond == 0);
  CHECK(worst_deepest < 1e-13);  // [m] rounding; measured 4e-16
  CHECK(worst_surface < 1e-11);  // [m] clip slack of 1e-12 half edges; measured 1e-12
  CHECK(worst_apart < 0.02);     // [m] twice the margin; measured 0.001
}

TEST_CASE("Points keep their names when the boxes move a little", "[unit][manifold]") {
  Random random(4);
  int changed = 0, compared = 0, renamed = 0;
  for (int n = 0; n < 20000; ++n) {
    const double depth = random.uniform(0.001, 0.01);
    const double yaw = random.uniform(-4.0, 4.0);
    const double tilt = random.uniform(-1e-3, 1e-3);
    Pair pair = stacked(random, depth, yaw, tilt, false);
    const Manifold before = collided(pair.a, pair.b, 0.02);
    const Vec3 push = random.in_cube(1e-6);
    const Vec3 axis = random.direction();
    pair.b.center_w += push;
    pair.b.axes_w = about(axis, 1e-6) * pair.b.axes_w;
    const Manifold after = collided(pair.a, pair.b, 0.02, before.axis);
    ++compared;
    if (names(before) != names(after)) {
      ++changed;  // a corner crossed an edge: allowed, but rare
      continue;
    }
    // A point's name stays with its place.
    for (int i = 0; i < before.count; ++i)
      for (int j = 0; j < after.count; ++j)
        if (point(before, i).feature == point(after, j).feature &&
            (point(before, i).position_w - point(after, j).position_w).norm() > 1e-3)
          ++renamed;
  }
  CHECK(compared == 20000);
  CHECK(changed < 20);  // about 1e-6 m of motion over 1 m, a few edges each; measured 0
  CHECK(renamed < 20);  // crossings of almost parallel edges run fast; measured 0
}

TEST_CASE("A point is called the same whichever face is the reference", "[unit][manifold]") {
  Random random(5);
  int differ = 0, compared = 0;
  for (int n = 0; n < 10000; ++n) {
    const double yaw = random.uniform(0.1, 1.4);
    const Pair pair = stacked(random, 0.01, yaw, 0.0, false);
    Manifold own, other;
    SeparationOptions options;
    options.remembered = 1;  // the upper face of the lower box
    const Separation of_first = separation(pair.a, pair.b, options);
    options.remembered = 4;  // the lower face of the upper box
    const Separation of_second = separation(pair.a, pair.b, options);
    if (of_first.axis != 1 || of_second.axis != 4) continue;
    find_manifold(pair.a, pair.b, of_first, 0.0, own);
    find_manifold(pair.a, pair.b, of_second, 0.0, other);
    ++compared;
    if (names(own) != names(other)) ++differ;
  }
  CHECK(compared > 9000);
  CHECK(differ == 0);
}

TEST_CASE("Flipping a contact twice gives it back", "[unit][manifold]") {
  for (AxisIndex axis = kNoAxis; axis < 15; ++axis) {
    Manifold m{.axis = axis};
    flip(m);
    CHECK(m.normal_w == -Vec3::UnitY());
    if (axis == 2) CHECK(m.axis == 5);
    if (axis == 6 + 3 * 1 + 2) CHECK(m.axis == 6 + 3 * 2 + 1);
    flip(m);
    CHECK(m.axis == axis);
    CHECK(m.normal_w == Vec3::UnitY());
  }
}

TEST_CASE("A contact that is asked for with bad numbers is refused", "[unit][manifold]") {
  const Box box = cube_at(Vec3::Zero());
  Manifold m;
  CHECK_THROWS_WITH(collide(box, box, -0.1, kNoAxis, m), Contains("margin = -0.1"));
  CHECK_THROWS_AS(collide(box, box, kInfinity, kNoAxis, m), std::invalid_argument);
  CHECK_THROWS_WITH(collide(box, box, 0.0, 15, m), Contains("15"));
  CHECK_THROWS_AS(find_manifold(box, box, separation(box, box), kNan, m), std::invalid_argument);
  CHECK_THROWS_WITH(find_manifold(box, box, Separation(), 0.0, m), Contains("axis"));
}
