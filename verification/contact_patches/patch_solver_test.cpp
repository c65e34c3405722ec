/// \file
/// \brief One contact patch: sticking, the bounds of friction, restitution and overlap correction.
#include "tumble/contact_patches/patch_solver.hpp"

#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/geometry/ground.hpp"

#include "support/test.hpp"

namespace {

// A cube of 1 m and 2 kg over the ground, and its patch.
struct OnGround {
  MovingBody ground;
  MovingBody box;
  ContactPatch patch;

  explicit OnGround(double friction, double height = 0.0) {
    const BodyProperties body = box_properties(Vec3::Ones(), 2.0);
    const BodyState state =
        make_state(body, Vec3(0.3, 0.5 + height, -0.2), rotation_from_vector(Vec3(0.0, 0.4, 0.0)));
    box.position_w = state.position_w;
    box.inverse_mass = Vec3::Constant(0.5);
    box.inverse_inertia_w = 3.0 * Mat3::Identity();  // 2/12 (1 + 1) kg m²
    Manifold found;
    REQUIRE(collide_with_ground(box_of(body, state), 1.0, found));
    // The four upper corners are a metre away.
    REQUIRE(found.count >= 4);
    int count = 0;
    for (int i = 0; i < found.count; ++i)
      if (found.points[idx(i)].distance < 0.5)
        found.points[static_cast<std::size_t>(count++)] = found.points[idx(i)];
    found.count = count;
    REQUIRE(count == 4);
    patch.size = 1.0;
    patch.friction = friction;
    build_patch(found, ground, box, patch);
    set_targets(tolerance::contact_slop, kFrame, patch);
    REQUIRE(patch.spans_area);
  }

  double solve(int iterations) { return solve_patch(patch, ground, box, iterations); }
  // Each call stops early, when it changes little compared with its first iteration.
  void settle() {
    for (int call = 0; call < 300; ++call) solve(2);
  }
  [[nodiscard]] Six motion() const { return motion_of(patch, ground, box); }
  [[nodiscard]] double normal() const { return impulse_of(patch)[2]; }
  [[nodiscard]] double friction() const {
    return std::hypot(patch.along_impulse, patch.across_impulse);
  }
};

double largest(const Six& motion) {
  double worst = 0.0;
  for (const double u : motion) worst = std::max(worst, std::abs(u));
  return worst;
}

}  // namespace

TEST_CASE("A point that pushes goes on touching when it rises by a tenth of the slop",
          "[exact][contact_damped]") {
  OnGround box(0.5);
  ContactPatchPoint& p = box.patch.points[0];
  for (const double rise : {1.05, 1.2}) {
    for (const double impulse : {0.0, 1.0}) {
      p.gap = rise * tolerance::contact_slop;
      p.impulse = impulse;
      set_targets(tolerance::contact_slop, kFrame, box.patch);
      const bool touches = impulse > 0.0 && rise < tolerance::kept_touch;
      CHECK(p.target ==
            near(touches ? 0.0 : (1.0 - rise) * tolerance::contact_slop / kFrame, 1e-18));
    }
  }
}

TEST_CASE("A box that turns about an edge has a patch whose middle does not slide",
          "[exact][contact_damped]") {
  // Its face rises from the edge by a hundredth of a metre; points halfway are 2.5 mm above the ground on average.
  const double tilt = 0.01;
  const BodyProperties body = box_properties(Vec3::Ones(), 2.0);
  const Quat orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, tilt));
  const Vec3 edge_w = orientation_wb * Vec3(-0.5, -0.5, 0.0);
  const BodyState state = make_state(body, -edge_w, orientation_wb);
  Manifold found;
  REQUIRE(collide_with_ground(box_of(body, state), 0.1, found));
  REQUIRE(found.count == 4);
  MovingBody ground;
  MovingBody box{.angular_velocity_w = Vec3(0.0, 0.0, 1.0),
                 .position_w = state.position_w,
                 .inverse_mass = Vec3::Constant(0.5),
                 .inverse_inertia_w = 3.0 * Mat3::Identity()};
  box.velocity_w = box.angular_velocity_w.cross(state.position_w);
  ContactPatch patch{.size = 1.0};
  build_patch(found, ground, box, patch);
  const Six motion = motion_of(patch, ground, box);
  CHECK(std::hypot(motion[0], motion[1]) <
        1e-15);  // [m/s] rounding; 2.5e-3 at the mean of the points
  for (int k = 0; k < 4; ++k) {
    const Vec3 point_w = position_of(patch, ground, patch.points[idx(k)]);
    CHECK(std::abs(point_w.y()) < 1e-15);  // [m] where the edge touches, all of them
  }
}

TEST_CASE("A patch that sticks is stopped in all six motions by one product",
          "[exact][contact_damped]") {
  OnGround one(1.0);
  one.box.velocity_w = Vec3(0.02, -0.1635, 0.01);
  one.box.angular_velocity_w = Vec3(0.03, 0.05, -0.04);
  const double corrected = one.solve(1);
  CHECK(largest(one.motion()) < 1e-15);  // [m/s], [rad/s] rounding of 0.16
  CHECK(corrected > 0.16);
  CHECK(one.friction() <= one.normal());
  // The ground takes the whole momentum: 2 kg at 0.1635 m/s.
  CHECK(one.normal() == near(0.327, 1e-14));
  CHECK(one.solve(1) < 1e-15);  // already solved
  for (int i = 0; i < 4; ++i) CHECK(one.patch.points[idx(i)].impulse > 0.0);
}

TEST_CASE("A box that spins on the ground is braked by mu times pressure times lever",
          "[exact][contact_damped]") {
  OnGround one(0.3);
  one.box.velocity_w = Vec3(0.0, -0.1635, 0.0);
  one.box.angular_velocity_w = Vec3(0.0, 5.0, 0.0);
  one.settle();
  // Four corners with a quarter of 0.327 N s each, half a diagonal from the middle; I = 1/3 kg m².
  const double brake = 0.3 * 0.327 * std::sqrt(0.5);
  CHECK(one.patch.twist_impulse == near(-brake, 1e-12));
  CHECK(one.box.angular_velocity_w.y() == near(5.0 - 3.0 * brake, 1e-12));
  CHECK(std::abs(one.box.velocity_w.x()) < 1e-14);
  OnGround slow(0.3);
  slow.box.velocity_w = Vec3(0.0, -0.1635, 0.0);
  slow.box.angular_velocity_w = Vec3(0.0, 0.1, 0.0);
  slow.solve(1);
  CHECK(largest(slow.motion()) < 1e-15);
}

TEST_CASE("A patch never pulls, and has no friction without pressure", "[exact][contact_damped]") {
  OnGround one(0.5);
  one.box.velocity_w = Vec3(1.0, 0.2, 0.0);
  one.box.angular_velocity_w = Vec3(0.0, 2.0, 0.0);
  CHECK(one.solve(4) == 0.0);
  CHECK(largest(impulse_of(one.patch)) == 0.0);
  // Impulses of the step before are removed.
  for (int i = 0; i < 4; ++i) one.patch.points[idx(i)].impulse = 0.1;
  one.patch.along_impulse = 0.05;
  apply(impulse_of(one.patch), one.patch, one.ground, one.box);
  one.solve(50);
  CHECK(largest(impulse_of(one.patch)) < 1e-15);
  CHECK((one.box.velocity_w - Vec3(1.0, 0.2, 0.0)).norm() < 1e-14);
}

TEST_CASE("A box above the ground may come down by its gap less the slop, in one step",
          "[exact][contact_damped]") {
  OnGround one(0.5, 0.01);
  one.box.velocity_w = Vec3(0.0, -2.0, 0.0);
  one.solve(4);
  CHECK(one.box.velocity_w.y() == near(-(0.01 - tolerance::contact_slop) / kFrame, 1e-13));
  OnGround slow(0.5, 0.01);
  slow.box.velocity_w = Vec3(0.0, -0.5, 0.0);
  slow.solve(4);
  CHECK(slow.box.velocity_w.y() == near(-0.5, 1e-15));
}

TEST_CASE("The overlap correction removes a share of the overlap, and lets nothing sink",
          "[exact][contact_damped]") {
  OnGround one(0.5, -0.01);
  MovingBody move = one.box;
  MovingBody still = one.ground;
  OverlapCorrection correction{inverse_mass_of(one.patch, still, move), {}};
  for (int pass = 0; pass < 60; ++pass) correct_overlap(one.patch, 0.2, correction, still, move);
  CHECK(move.velocity_w.y() == near(0.2 * 0.01, 1e-12));
  OnGround apart(0.5, 0.01);
  MovingBody rest = apart.box;
  OverlapCorrection none{inverse_mass_of(apart.patch, still, rest), {}};
  CHECK(correct_overlap(apart.patch, 0.2, none, still, rest) == 0.0);
  CHECK(rest.velocity_w.norm() == 0.0);
}

TEST_CASE("Pressure at one point, and hardly any at another, has no lever",
          "[exact][contact_damped]") {
  // Pressure that half goes to a neighbour in each turn ends so; the square of its lever is 0.
  OnGround cube(0.5);
  cube.patch.points[0].impulse = 1e-3;
  cube.patch.points[1].impulse = 3e-167;
  cube.patch.along_impulse = 4e-4;
  cube.patch.twist_impulse = 4e-4 * -cube.patch.points[0].across;
  cube.patch.targets_planar = false;
  cube.box.angular_velocity_w = Vec3(0.0, 1e-165, 0.0);
  cube.solve(2);
  CHECK(cube.box.velocity_w.allFinite());
  CHECK(cube.box.angular_velocity_w.allFinite());
}
