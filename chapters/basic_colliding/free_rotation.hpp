/// \file
/// \brief The independent judge of tumbling: a free body's exact motion, by GSL.
#pragma once

#include "tumble/base/types.hpp"

#include "driver/experiment.hpp"

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

  // When the second component is 0 for the first time: the body turns over [s].
  [[nodiscard]] double first_flip() const { return (2.0 * quarter_ - phase_) / rate_; }

  // How long the body takes from one such time to the next [s].
  [[nodiscard]] double flip_interval() const { return 2.0 * quarter_ / rate_; }

 private:
  Vec3 amplitude_;    // [rad/s] w1, w2, w3
  double rate_;       // [rad/s] lambda
  double parameter_;  // [-] m
  double quarter_;    // [-] quarter period K(m)
  double phase_;      // [-] u0
};

}  // namespace tumble::chapters
