/// \file
/// \brief Free rotation against GSL: elliptic functions, and an integration of high order.
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/math/rotation.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/catch.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

using namespace tumble;

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

// The solution of Euler's equations for L² > 2 T I2, where ω3 never changes its sign.
struct EllipticTop {
  EllipticTop(const Vec3& moments, const Vec3& omega) {
    const double i1 = moments[0], i2 = moments[1], i3 = moments[2];
    const double energy2 = moments.dot(omega.cwiseProduct(omega));
    const double momentum2 = moments.cwiseProduct(omega).squaredNorm();
    REQUIRE(momentum2 > energy2 * i2);
    amplitude = Vec3(std::sqrt((energy2 * i3 - momentum2) / (i1 * (i3 - i1))),
                     std::sqrt((energy2 * i3 - momentum2) / (i2 * (i3 - i2))),
                     std::sqrt((momentum2 - energy2 * i1) / (i3 * (i3 - i1))));
    rate = std::sqrt((i3 - i2) * (momentum2 - energy2 * i1) / (i1 * i2 * i3));
    m = (i2 - i1) * (energy2 * i3 - momentum2) / ((i3 - i2) * (momentum2 - energy2 * i1));
    quarter = gsl_sf_ellint_Kcomp(std::sqrt(m), GSL_PREC_DOUBLE);
  }

  // At phase u: (w1 cn, w2 sn, w3 dn).
  [[nodiscard]] Vec3 omega(double u) const {
    double sn = 0.0, cn = 0.0, dn = 0.0;
    if (gsl_sf_elljac_e(u, m, &sn, &cn, &dn) != GSL_SUCCESS) FAIL("gsl_sf_elljac_e(" << u << ")");
    return amplitude.cwiseProduct(Vec3(cn, sn, dn));
  }

  Vec3 amplitude;
  double rate = 0.0;
  double m = 0.0;
  double quarter = 0.0;
};

BodyProperties asymmetric() { return box_properties(Vec3(3.0, 2.0, 1.0), 12.0); }

}  // namespace

TEST_CASE("An asymmetric top agrees with Jacobi's elliptic functions over three periods",
          "[reference][advance_pose]") {
  const BodyProperties body = asymmetric();
  const Vec3 omega0(1.0, 0.0, 2.0);
  const EllipticTop exact(body.inertia_b, omega0);
  CHECK(4.0 * exact.quarter / exact.rate == near(4.73462529410).epsilon(1e-11));
  BodyState state = make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega0);
  double worst = 0.0;
  const double dt = 1e-3;
  for (int i = 1; i <= 14200; ++i) {
    advance_pose(body, state, dt, RotationRule::rk4);
    const Vec3 omega_b =
        state.orientation_wb.toRotationMatrix().transpose() * angular_velocity(body, state);
    worst = std::max(worst, (omega_b - exact.omega(exact.rate * i * dt)).norm());
  }
  CHECK(worst < 1e-10);  // [rad/s] error of RK4 at 1 ms; measured 1.4e-11
}

TEST_CASE("The times of a Dzhanibekov flip are the elliptic integrals' and RK4 meets them",
          "[reference][advance_pose]") {
  const BodyProperties body = asymmetric();
  const Vec3 omega0(0.01, 5.0, 0.02);
  const EllipticTop exact(body.inertia_b, omega0);
  CHECK(exact.m == near(0.999972054263).epsilon(1e-12));
  CHECK(exact.rate == near(2.40196227473).epsilon(1e-11));
  CHECK(exact.quarter == near(6.62895664053).epsilon(1e-10));  // 1 - m has lost five digits
  CHECK(2.0 * exact.quarter / exact.rate == near(5.51961761454).epsilon(1e-10));
  CHECK(exact.amplitude.y() == near(5.00001333332).epsilon(1e-11));
  CHECK(exact.amplitude.x() == near(4.33013856591).epsilon(1e-11));
  CHECK(exact.amplitude.z() == near(3.46693391475).epsilon(1e-11));

  // ω2 = w2 sn(u0 + rate t) vanishes at u = 2K. With ω2(0) = 5, ω1 and ω3 > 0: u0 = F(asin ...).
  const double u0 =
      gsl_sf_ellint_F(std::asin(5.0 / exact.amplitude.y()), std::sqrt(exact.m), GSL_PREC_DOUBLE);
  const double first = (2.0 * exact.quarter - u0) / exact.rate;
  CHECK(first == near(2.93634642244).epsilon(1e-9));
  BodyState state = make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega0);
  for (int i = 0; i < 2936; ++i) advance_pose(body, state, first / 2936, RotationRule::rk4);
  const Vec3 omega_b =
      state.orientation_wb.toRotationMatrix().transpose() * angular_velocity(body, state);
  // [rad/s] asked for: 1e-6 s, times the slope of ω2 there, 12 rad/s².
  CHECK(std::abs(omega_b.y()) < 1.2e-5);  // measured 2e-10
}

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
  CHECK(order(RotationRule::frozen) == near(1.0).margin(0.03));     // measured 1.005
  CHECK(order(RotationRule::midpoint) == near(2.0).margin(0.03));   // measured 2.000
  CHECK(order(RotationRule::rk4) == near(4.0).margin(0.03));        // measured 3.999
  CHECK(order(RotationRule::splitting) == near(2.0).margin(0.03));  // measured 2.000

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
