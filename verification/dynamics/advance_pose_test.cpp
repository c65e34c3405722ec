/// \file
/// \brief Free rotation by four rules: exact motions, symmetries, energy, and bounds.
#include "tumble/dynamics/advance_pose.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

namespace {

// Angular velocity in the body frame, the form of the textbooks' solutions.
Vec3 omega_b(const BodyProperties& body, const BodyState& state) {
  return state.orientation_wb.toRotationMatrix().transpose() * angular_velocity(body, state);
}

// A body at the origin that spins; at the start world and body frame agree.
BodyState spinning(const BodyProperties& body, const Vec3& omega) {
  return make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega);
}

void advance(const BodyProperties& body, BodyState& state, double duration, int steps,
             RotationRule rule) {
  for (int i = 0; i < steps; ++i) advance_pose(body, state, duration / steps, rule);
}

// The asymmetric top of all tests below: moments 5, 10, 13.
BodyProperties asymmetric() { return box_properties(Vec3(3.0, 2.0, 1.0), 12.0); }

}  // namespace

TEST_CASE("Splitting is exact for square bars in every orientation of their axes",
          "[exact][advance_pose]") {
  Random random(41);
  double worst = 0.0;
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 size = Vec3::Constant(random.uniform(0.2, 2.0));
    size[trial % 3] = random.uniform(0.2, 2.0);
    const BodyProperties body = box_properties(size, 3.0);
    const BodyState start = random_state(random, body, 0.0, 0.0, 5.0);
    BodyState state = start;
    advance_pose(body, state, 1.0, RotationRule::splitting);
    // exp(t L / I) q exp(t c e): turn about L, and about the body's own axis of symmetry.
    const int k = trial % 3;
    const double across = body.inverse_inertia_b[(k + 1) % 3];
    const Vec3 momentum_b =
        start.orientation_wb.toRotationMatrix().transpose() * start.angular_momentum_w;
    Vec3 own = Vec3::Zero();
    own[k] = (body.inverse_inertia_b[k] - across) * momentum_b[k];
    const Quat expected = rotation_from_vector(across * start.angular_momentum_w) *
                          start.orientation_wb * rotation_from_vector(own);
    worst = std::max(worst, angle_between(state.orientation_wb, expected));
  }
  CHECK(worst < 1e-13);  // [rad] rounding of angles up to 40; measured 9e-16
}

TEST_CASE("A cube turns uniformly under every rule but the Runge-Kutta one, in one step",
          "[exact][advance_pose]") {
  const BodyProperties cube = box_properties(Vec3::Ones(), 6.0);
  const Vec3 omega(1.0, -2.0, 0.5);
  for (const RotationRule rule : rotation_rules()) {
    BodyState state = spinning(cube, omega);
    advance_pose(cube, state, 1.0, rule);
    const double error = angle_between(state.orientation_wb, rotation_from_vector(omega));
    if (rule == RotationRule::rk4)
      CHECK(error > 1e-3);
    else
      CHECK(error < 1e-15);  // [rad] rounding; measured 6e-17
  }
}

TEST_CASE("An asymmetric top follows its elliptic functions", "[exact][advance_pose]") {
  // ω0 = (1, 0, 2): ω = (cn, w2 sn, 2 dn), period 4.7346 s. RK4 at 1 ms: error of 1e-12.
  const BodyProperties body = asymmetric();
  BodyState state = spinning(body, Vec3(1.0, 0.0, 2.0));
  advance(body, state, 0.5, 500, RotationRule::rk4);
  CHECK((omega_b(body, state) - Vec3(0.774563276506, 0.730343965255, 1.93482727469))
            .cwiseAbs()
            .maxCoeff() < 6e-12);  // the digits given
  advance(body, state, 0.5, 500, RotationRule::rk4);
  CHECK((omega_b(body, state) - Vec3(0.231481146152, 1.12333816753, 1.84209738339))
            .cwiseAbs()
            .maxCoeff() < 6e-12);
  advance(body, state, 1.0, 1000, RotationRule::rk4);
  CHECK((omega_b(body, state) - Vec3(-0.874871758346, 0.559284550652, 1.96204377247))
            .cwiseAbs()
            .maxCoeff() < 6e-12);
  const Quat expected(-0.4999477895, -0.0437805628, 0.0029278643, 0.8649432916);
  CHECK(angle_between(state.orientation_wb, normalised(expected)) < 2e-10);  // the digits given

  BodyState round = spinning(body, Vec3(1.0, 0.0, 2.0));
  advance(body, round, 4.73462529410, 4735, RotationRule::rk4);
  CHECK((omega_b(body, round) - Vec3(1.0, 0.0, 2.0)).norm() < 1e-10);  // measured 2e-12
}

TEST_CASE("Every rule keeps both momenta to the last bit and the quaternion at length 1",
          "[exact][advance_pose]") {
  Random random(42);
  for (const RotationRule rule : rotation_rules()) {
    const BodyProperties body = random_box(random);
    const BodyState start = random_state(random, body, 1.0, 5.0, 5.0);
    BodyState state = start;
    double longest = 0.0;
    for (int i = 0; i < 10000; ++i) {
      advance_pose(body, state, 0.01, rule);
      longest = std::max(longest, std::abs(state.orientation_wb.norm() - 1.0));
    }
    CHECK(state.linear_momentum_w == start.linear_momentum_w);
    CHECK(state.angular_momentum_w == start.angular_momentum_w);
    CHECK(longest < 4e-16);  // two roundings; measured 2.2e-16
  }
}

TEST_CASE("Splitting keeps the energy within a fixed bound over 100 000 steps; the others drift",
          "[exact][advance_pose]") {
  const BodyProperties body = asymmetric();
  const double dt = 1.0 / 60.0;
  // Largest relative energy error in the first and in the last tenth of the run.
  const auto errors = [&](RotationRule rule) {
    BodyState state = spinning(body, Vec3(1.0, 2.0, 3.0));
    const double energy = kinetic_energy(body, state);
    std::array<double, 2> worst{};
    for (int i = 0; i < 100000; ++i) {
      advance_pose(body, state, dt, rule);
      const double error = std::abs(kinetic_energy(body, state) / energy - 1.0);
      if (i < 10000) worst[0] = std::max(worst[0], error);
      if (i >= 90000) worst[1] = std::max(worst[1], error);
    }
    return worst;
  };
  const auto splitting = errors(RotationRule::splitting);
  const auto midpoint = errors(RotationRule::midpoint);
  const auto rk4 = errors(RotationRule::rk4);
  const auto frozen = errors(RotationRule::frozen);
  INFO("splitting " << splitting[0] << " " << splitting[1] << ", midpoint " << midpoint[0] << " "
                    << midpoint[1] << ", rk4 " << rk4[0] << " " << rk4[1] << ", frozen "
                    << frozen[0] << " " << frozen[1]);
  // Measured, first and last tenth: splitting 1.7e-5 both, midpoint 1.1e-3 and 1.1e-2, RK4 1.1e-6
  // and 1.1e-5, frozen 1.4: it has come to spin about another axis long ago.
  CHECK(splitting[0] < 1e-4);
  CHECK(splitting[1] < 1.001 * splitting[0]);
  CHECK(midpoint[1] > 3.0 * midpoint[0]);
  CHECK(rk4[1] > 3.0 * rk4[0]);
  CHECK(frozen[0] > 0.1);
}

TEST_CASE("A mirror image of the motion is the motion of the mirror image, bit for bit",
          "[determinism][advance_pose]") {
  // Mirrored at the plane across axis k: vectors change the sign of component k, and axial vectors
  // (L, and the vector part of q) those of the other two.
  const auto mirrored = [](const BodyState& state, int k) {
    Vec3 sign = Vec3::Ones();
    sign[k] = -1.0;
    BodyState out;
    out.position_w = sign.cwiseProduct(state.position_w);
    out.linear_momentum_w = sign.cwiseProduct(state.linear_momentum_w);
    out.angular_momentum_w = -sign.cwiseProduct(state.angular_momentum_w);
    out.orientation_wb.w() = state.orientation_wb.w();
    out.orientation_wb.vec() = -sign.cwiseProduct(Vec3(state.orientation_wb.vec()));
    return out;
  };
  Random random(43);
  int different = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const BodyProperties body = random_box(random);
    const BodyState start = random_state(random, body, 1.0, 5.0, 10.0);
    for (const RotationRule rule : rotation_rules()) {
      for (int k = 0; k < 3; ++k) {
        BodyState state = start;
        BodyState mirror = mirrored(start, k);
        for (int step = 0; step < 5; ++step) {
          advance_pose(body, state, 1.0 / 60.0, rule);
          advance_pose(body, mirror, 1.0 / 60.0, rule);
        }
        different += same_state(mirrored(state, k), mirror) ? 0 : 1;
      }
    }
  }
  CHECK(different == 0);
}

TEST_CASE("No arc of any rule turns faster than its bound", "[unit][advance_pose]") {
  Random random(45);
  std::array<double, 4> closest{};  // largest share of the bound, by rule
  for (int trial = 0; trial < 10000; ++trial) {
    // Edge ratios up to 20; every fifth box has two equal edges.
    Vec3 size;
    for (int k = 0; k < 3; ++k) {
      const double mantissa = 0.2 + random.unit();
      size[k] = std::ldexp(mantissa, static_cast<int>(random.below(3)));
    }
    if (trial % 5 == 0) size.y() = size.x();
    const BodyProperties body = box_properties(size, 1.0);
    const BodyState start = random_state(random, body, 0.0, 0.0, 1.0);
    const double share_of_arc = random.uniform(0.01, 1.0);
    const double share_of_time = random.unit();
    for (std::size_t r = 0; r < 4; ++r) {
      const RotationRule rule = rotation_rules()[r];
      // Arcs as long as the bound is said to hold.
      const double turning = angular_speed_bound(body, start, 0.0, rule);
      const double swing = angular_speed_bound(body, start, 1.0, rule) / turning - 1.0;
      const double dt = share_of_arc * std::min(3.0 / turning, 4.0 / std::max(swing, 1e-9));
      const double t = share_of_time * dt;
      const double little = 1e-4 * dt;
      BodyState before = start;
      BodyState after = start;
      advance_pose(body, before, t, rule);
      advance_pose(body, after, t + little, rule);
      const double speed = angle_between(before.orientation_wb, after.orientation_wb) / little;
      closest[r] = std::max(closest[r], speed / angular_speed_bound(body, start, dt, rule));
    }
  }
  // Frozen ω is its own bound, up to the rounding of a difference of 1e-4: 1e-16 / 1e-4.
  for (const double share : closest)
    CHECK(share <= 1.0 + 1e-9);  // measured 1, 0.9998, 0.9983 and 1: a cube
  // turns at its bound
  for (const RotationRule rule : rotation_rules())
    CHECK(angular_speed_bound(ground_properties(), BodyState{}, 1.0, rule) == 0.0);
}

TEST_CASE("A body without spin keeps its orientation to the last bit", "[unit][advance_pose]") {
  const BodyProperties body = asymmetric();
  Random random(46);
  for (const RotationRule rule : rotation_rules()) {
    BodyState state = make_state(body, Vec3::Zero(), random.orientation(), Vec3(1.0, 2.0, 3.0));
    const Quat before = state.orientation_wb;
    advance_pose(body, state, 0.5, rule);
    CHECK(state.orientation_wb.coeffs() == before.coeffs());
    CHECK((state.position_w - Vec3(0.5, 1.0, 1.5)).norm() < 1e-15);
  }
}

TEST_CASE("A momentum that is not finite is refused by every rule", "[unit][advance_pose]") {
  const BodyProperties body = asymmetric();
  for (const RotationRule rule : rotation_rules()) {
    for (const double bad : {kNan, kInfinity}) {
      BodyState state;
      state.angular_momentum_w.y() = bad;
      CHECK_THROWS_AS(advance_pose(body, state, 0.1, rule), std::invalid_argument);
    }
  }
}
