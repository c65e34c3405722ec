/// \file
/// \brief Free rotation against GSL's integration of high order.
#include "tumble/dynamics/advance_pose.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace {

struct Top {
  BodyProperties body;
  Vec3 momentum_w;
};

// dq/dt = 1/2 (0, ω) q, written out anew: not a line of it is the library's.
int slope(double, const double* y, double* dydt, void* data) {
  const Top& top = *static_cast<const Top*>(data);
  const Quat q(y[0], y[1], y[2], y[3]);
  const Mat3 r = q.normalized().toRotationMatrix();
  const Vec3 omega =
      r * (top.body.inertia_b.cwiseInverse().asDiagonal() * (r.transpose() * top.momentum_w));
  dydt[0] = -0.5 * omega.dot(q.vec());
  const Vec3 vector = 0.5 * (q.w() * omega + omega.cross(Vec3(q.vec())));
  for (int k = 0; k < 3; ++k) dydt[k + 1] = vector[k];
  return GSL_SUCCESS;
}

// Prince and Dormand's pair of order 8 and 9 at a tolerance of 1e-14.
Quat reference(const BodyProperties& body, const BodyState& state, double duration) {
  Top top{body, state.angular_momentum_w};
  gsl_odeiv2_system system{slope, nullptr, 4, &top};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-14),
      gsl_odeiv2_driver_free);
  const Quat& q = state.orientation_wb;
  std::array<double, 4> y = {q.w(), q.x(), q.y(), q.z()};
  double t = 0.0;
  REQUIRE(gsl_odeiv2_driver_apply(driver.get(), &t, duration, y.data()) == GSL_SUCCESS);
  return Quat(y[0], y[1], y[2], y[3]).normalized();
}

double error_at_1s(const BodyProperties& body, const BodyState& start, int steps, RotationRule rule,
                   const Quat& truth) {
  BodyState state = start;
  for (int i = 0; i < steps; ++i) advance_pose(body, state, 1.0 / steps, rule);
  return angle_between(state.orientation_wb, truth);
}

BodyProperties asymmetric() { return box_properties(Vec3(3.0, 2.0, 1.0), 12.0); }

}  // namespace

TEST_CASE("Free rotation of random boxes agrees with GSL at order 8", "[reference][advance_pose]") {
  Random random(51);
  double worst_rk4 = 0.0;
  double worst_splitting = 0.0;
  for (int trial = 0; trial < 30; ++trial) {
    const BodyProperties body = random_box(random);
    const BodyState start = random_state(random, body, 0.0, 0.0, 3.0);
    const Quat truth = reference(body, start, 1.0);
    worst_rk4 = std::max(worst_rk4, error_at_1s(body, start, 2000, RotationRule::rk4, truth));
    worst_splitting =
        std::max(worst_splitting, error_at_1s(body, start, 2000, RotationRule::splitting, truth));
  }
  // [rad] The worst are long, thin and fast: 10 rad/s and more, for which (ω dt)^4 is 1e-9 and
  // (ω dt)² 3e-5, times small constants.
  CHECK(worst_rk4 < 1e-9);        // measured 1.0e-11
  CHECK(worst_splitting < 1e-6);  // measured 7.2e-8
}

TEST_CASE("The rules converge at orders 1, 2, 4 and 2", "[reference][advance_pose]") {
  const BodyProperties body = asymmetric();
  const BodyState start =
      make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3(1.0, 2.0, 3.0));
  const Quat truth = reference(body, start, 1.0);
  const auto order = [&](RotationRule rule) {
    const double coarse = error_at_1s(body, start, 160, rule, truth);
    const double fine = error_at_1s(body, start, 320, rule, truth);
    return std::log2(coarse / fine);
  };
  CHECK(order(RotationRule::frozen) == near(1.0, 0.03));     // measured 1.005
  CHECK(order(RotationRule::midpoint) == near(2.0, 0.03));   // measured 2.000
  CHECK(order(RotationRule::rk4) == near(4.0, 0.03));        // measured 3.999
  CHECK(order(RotationRule::splitting) == near(2.0, 0.03));  // measured 2.000

  // At the same step: how much the better rules gain.
  const double frozen = error_at_1s(body, start, 60, RotationRule::frozen, truth);
  const double midpoint = error_at_1s(body, start, 60, RotationRule::midpoint, truth);
  const double splitting = error_at_1s(body, start, 60, RotationRule::splitting, truth);
  const double rk4 = error_at_1s(body, start, 60, RotationRule::rk4, truth);
  INFO("at 1/60 s: frozen " << frozen << ", midpoint " << midpoint << ", splitting " << splitting
                            << ", rk4 " << rk4 << " rad");
  // Measured 2.8e-2, 4.4e-4, 6.4e-5 and 4.1e-7 rad after one second.
  CHECK(midpoint < 0.2 * frozen);
  CHECK(splitting < midpoint);
  CHECK(rk4 < 0.1 * splitting);
}
