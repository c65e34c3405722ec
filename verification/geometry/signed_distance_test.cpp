/// \file
/// \brief The distance function of a box against closed forms and against other ways to get it.
#include "tumble/geometry/signed_distance.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

// [m] Some ten rounding errors of coordinates of order 1.
constexpr double kRounding = 1e-14;

Box cube_of_size(const Vec3& size) { return make_box(Vec3::Zero(), Quat::Identity(), size); }

// How near the point is to a place where the gradient jumps (inside) or bends sharply (the surface).
bool is_near_a_kink(const Box& box, const Vec3& point_w, double margin) {
  const Vec3 p = (box.axes_w.transpose() * (point_w - box.center_w)).cwiseAbs();
  Vec3 q = p - box.half;
  if (q.maxCoeff() > 0.0) return q.cwiseAbs().minCoeff() < margin;
  std::sort(q.data(), q.data() + 3);
  return q[2] - q[1] < margin || -q[2] < margin || p.minCoeff() < margin;
}

}  // namespace

TEST_CASE("The signed distance of a unit cube has its closed-form values",
          "[exact][signed_distance]") {
  const Box cube = cube_of_size(Vec3::Ones());
  const SignedDistance centre = signed_distance(cube, Vec3::Zero());
  CHECK(centre.distance == -0.5);
  CHECK(centre.gradient_w == Vec3::UnitX());

  const SignedDistance inside = signed_distance(cube, Vec3(0.4, 0.3, 0.45));
  CHECK(std::abs(inside.distance + 0.05) < kRounding);
  CHECK(inside.gradient_w == Vec3::UnitZ());

  const SignedDistance corner = signed_distance(cube, Vec3::Ones());
  CHECK(std::abs(corner.distance - std::sqrt(0.75)) < kRounding);
  CHECK((corner.gradient_w - Vec3::Constant(1.0 / std::sqrt(3.0))).norm() < kRounding);

  const SignedDistance edge = signed_distance(cube, Vec3(0.6, -0.7, 0.2));
  CHECK(std::abs(edge.distance - std::sqrt(0.05)) < kRounding);
  CHECK((edge.gradient_w - Vec3(1.0, -2.0, 0.0) / std::sqrt(5.0)).norm() < kRounding);
}

TEST_CASE("On medial planes the lowest axis and the positive side are taken",
          "[unit][signed_distance]") {
  const Box cube = cube_of_size(Vec3::Ones());
  CHECK(signed_distance(cube, Vec3(0.0, -0.3, 0.3)).gradient_w == Vec3(0.0, -1.0, 0.0));
  CHECK(signed_distance(cube, Vec3(-0.3, 0.3, 0.3)).gradient_w == Vec3(-1.0, 0.0, 0.0));
  CHECK(signed_distance(cube, Vec3(-0.0, -0.0, -0.0)).gradient_w == Vec3::UnitX());
  // In a flat box the centre is nearest to the flat faces, whichever number these have.
  const Box plate = cube_of_size(Vec3(4.0, 4.0, 1.0));
  CHECK(signed_distance(plate, Vec3(0.0, 0.0, -0.0)).gradient_w == Vec3::UnitZ());
}

TEST_CASE("No point of a dense sampling of the surface is nearer than the signed distance",
          "[unit][signed_distance]") {
  Random random(12);
  constexpr int kCells = 40;  // per edge
  double worst_nearer = 0.0, worst_farther = 0.0;
  for (int trial = 0; trial < 40; ++trial) {
    const Box box = random_box(random, 1.0, 1.0, 0.2);
    const Vec3 point = box.center_w + random.in_cube(1.0);
    double nearest = kInfinity;
    for (int face = 0; face < 6; ++face) {
      const int k = face / 2, l = (k + 1) % 3, m = (k + 2) % 3;
      for (int a = 0; a <= kCells; ++a) {
        for (int b = 0; b <= kCells; ++b) {
          Vec3 q;
          q[k] = face % 2 == 0 ? -box.half[k] : box.half[k];
          q[l] = box.half[l] * (2.0 * a / kCells - 1.0);
          q[m] = box.half[m] * (2.0 * b / kCells - 1.0);
          nearest = std::min(nearest, (box.center_w + box.axes_w * q - point).norm());
        }
      }
    }
    const double distance = std::abs(signed_distance(box, point).distance);
    worst_nearer = std::max(worst_nearer, distance - nearest);
    worst_farther = std::max(worst_farther, nearest - distance);
  }
  CHECK(worst_nearer < kRounding);  // measured 1.1e-15 m
  // Half the diagonal of a sampling cell of the largest face: 1.2 / 40 / sqrt(2) = 0.021 m.
  CHECK(worst_farther < 0.0213);  // measured 6.6e-4 m
}

TEST_CASE("The gradient of the signed distance is that of finite differences",
          "[unit][signed_distance]") {
  Random random(13);
  constexpr double kStep = 1e-5;  // [m] error of central differences: step² / distance²
  double worst = 0.0;
  int compared = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Box box = random_box(random, 1.0, 1.0, 0.2);
    const Vec3 point = box.center_w + random.in_cube(1.0);
    if (is_near_a_kink(box, point, 0.01)) continue;
    ++compared;
    Vec3 difference;
    for (int k = 0; k < 3; ++k) {
      const Vec3 h = kStep * Vec3::Unit(k);
      difference[k] =
          (signed_distance(box, point + h).distance - signed_distance(box, point - h).distance) /
          (2.0 * kStep);
    }
    worst = std::max(worst, (difference - signed_distance(box, point).gradient_w).norm());
  }
  CHECK(compared > 15000);
  // step² / distance² / 2 = 5e-7 at the distance of 0.01 m that is allowed; measured 2.8e-8.
  CHECK(worst < 1e-6);
}

TEST_CASE("The signed distance refuses a point that is not finite", "[unit][signed_distance]") {
  const Box cube = cube_of_size(Vec3::Ones());
  CHECK_THROWS_AS(signed_distance(cube, Vec3(kNan, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(signed_distance(cube, Vec3(0.0, 0.0, kInfinity)), std::invalid_argument);
  CHECK_THROWS_WITH(signed_distance(cube, Vec3(0.0, kNan, 0.0)), Contains("point_w"));
}
