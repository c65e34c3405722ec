/// \file
/// \brief The independent judge of tumbling: a free body's exact motion, by GSL.
#pragma once

#include "tumble/base/types.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

namespace tumble::chapters {

// Euler's exact solution for a free body with three different moments of inertia.
//
// With energy T and angular momentum L such that \f$L^2 > 2 T I_2\f$,
// \f[ \omega = (w_1\,\mathrm{cn}\,u,\; w_2\,\mathrm{sn}\,u,\; w_3\,\mathrm{dn}\,u), \qquad
//     u = u_0 + \lambda t, \f]
// with Jacobi's elliptic functions of parameter m.
// \see Landau, Lifshitz, *Mechanics*, section 37
class FreeRotation {
 public:
  // A motion from its start.
  // inertia_b: [kg m²] ascending principal moments, all different
  // omega_b: [rad/s] at time 0, body frame; second component at least 0, third above 0
  FreeRotation(const Vec3& inertia_b, const Vec3& omega_b) {
    const double i1 = inertia_b[0];
    const double i2 = inertia_b[1];
    const double i3 = inertia_b[2];
    const Vec3 momentum = inertia_b.cwiseProduct(omega_b);
    const double energy2 = momentum.dot(omega_b);  // 2 T
    const double momentum2 = momentum.squaredNorm();
    const bool of_this_kind = 0.0 < i1 && i1 < i2 && i2 < i3 && momentum2 > energy2 * i2 &&
                              omega_b[1] >= 0.0 && omega_b[2] > 0.0;
    if (!of_this_kind) throw std::invalid_argument("no motion with L² > 2 T I2 from this start");

    const double above = energy2 * i3 - momentum2;
    const double below = momentum2 - energy2 * i1;
    amplitude_ = Vec3(std::sqrt(above / (i1 * (i3 - i1))), std::sqrt(above / (i2 * (i3 - i2))),
                      std::sqrt(below / (i3 * (i3 - i1))));
    rate_ = std::sqrt((i3 - i2) * below / (i1 * i2 * i3));
    parameter_ = (i2 - i1) * above / ((i3 - i2) * below);

    // GSL's elliptic integrals want the modulus, its elliptic functions the parameter.
    const double modulus = std::sqrt(parameter_);
    quarter_ = gsl_sf_ellint_Kcomp(modulus, GSL_PREC_DOUBLE);
    const double angle = std::atan2(omega_b[1] / amplitude_[1], omega_b[0] / amplitude_[0]);
    phase_ = gsl_sf_ellint_F(angle, modulus, GSL_PREC_DOUBLE);
  }

  // The angular velocity at a time.
  // time: [s]
  // Returns [rad/s] body frame
  [[nodiscard]] Vec3 at(double time) const {
    double sn = 0.0;
    double cn = 0.0;
    double dn = 0.0;
    gsl_sf_elljac_e(phase_ + rate_ * time, parameter_, &sn, &cn, &dn);
    return amplitude_.cwiseProduct(Vec3(cn, sn, dn));
  }

  // When the second component is 0 for the first time: the body turns over.
  // Returns [s]
  [[nodiscard]] double first_flip() const { return (2.0 * quarter_ - phase_) / rate_; }

  // How long the body takes from one such time to the next.
  // Returns [s]
  [[nodiscard]] double flip_interval() const { return 2.0 * quarter_ / rate_; }

 private:
  Vec3 amplitude_;    // [rad/s] w1, w2, w3
  double rate_;       // [rad/s] lambda
  double parameter_;  // [-] m
  double quarter_;    // [-] quarter period K(m)
  double phase_;      // [-] u0
};

// Euler's equations and the quaternion's, in the body's frame: y = (q_w, q_x, q_y, q_z, omega).
inline int derivative(double, const double y[], double rate[], void* inertia) {
  const Vec3& moments = *static_cast<const Vec3*>(inertia);
  const Quat q(y[0], y[1], y[2], y[3]);
  const Vec3 omega(y[4], y[5], y[6]);
  const Quat turn = q * Quat(0.0, omega.x(), omega.y(), omega.z());
  const Vec3 change = -omega.cross(moments.cwiseProduct(omega)).cwiseQuotient(moments);
  rate[0] = 0.5 * turn.w();
  for (int i = 0; i < 3; ++i) {
    rate[1 + i] = 0.5 * turn.vec()[i];
    rate[4 + i] = change[i];
  }
  return GSL_SUCCESS;
}

// The orientation of a free body after a time, by an eighth-order integrator at the limit of double
// precision, from equations in the body's frame (the library's rules use the world's).
// inertia_b: [kg m²] principal moments
// omega_b: [rad/s] at time 0, body frame; the orientation is 1 then
// time: [s] above 0
// Returns [-] body to world
inline Quat free_orientation(const Vec3& inertia_b, const Vec3& omega_b, double time) {
  // Between 1e-14 a step and rounding there is nothing left to gain.
  constexpr double accuracy = 1e-14;
  constexpr double first_step = 1e-3;
  Vec3 moments = inertia_b;
  gsl_odeiv2_system system{derivative, nullptr, 7, &moments};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first_step, accuracy, accuracy),
      gsl_odeiv2_driver_free);
  std::array<double, 7> y{1.0, 0.0, 0.0, 0.0, omega_b.x(), omega_b.y(), omega_b.z()};
  double now = 0.0;
  if (gsl_odeiv2_driver_apply(driver.get(), &now, time, y.data()) != GSL_SUCCESS)
    throw std::runtime_error("the reference integrator gave up");
  return Quat(y[0], y[1], y[2], y[3]).normalized();
}

}  // namespace tumble::chapters
