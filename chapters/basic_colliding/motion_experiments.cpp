/// \file
/// \brief Experiments on free motion (thesis 3.1).
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/math/bracket.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

namespace tumble::chapters {
namespace {

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

// A box with three different moments of inertia, 5, 10 and 13 kg m².
BodyProperties uneven_box() { return box_properties(Vec3(3.0, 2.0, 1.0), 12.0); }

// It stands upright in the world at first, so that body and world frame agree.
BodyState spun(const BodyProperties& body, const Vec3& omega) {
  return make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega);
}

// Spun about the middle axis, a little off.
const Vec3 kUnstableSpin(0.01, 5.0, 0.02);  // [rad/s]

double middle_rate(const BodyProperties& body, const BodyState& state) {
  return (state.orientation_wb.conjugate() * angular_velocity(body, state)).y();
}

// When the middle angular velocity is 0 for the first time: whole steps until its sign has changed,
// then the last step again with its length halved until it ends there.
double first_flip(const BodyProperties& body, double step, RotationRule rule) {
  constexpr int cap = 1100;         // enough for any two doubles
  constexpr double give_up = 30.0;  // [s] ten times the true time
  BodyState state = spun(body, kUnstableSpin);
  for (int k = 0; k * step < give_up; ++k) {
    const auto rate_after = [&](double part) {
      BodyState later = state;
      advance_pose(body, later, part, rule);
      return middle_rate(body, later);
    };
    if (rate_after(step) < 0.0)
      return k * step + bisect(rate_after, Bracket{0.0, step}, 0.0, cap).bracket.low;
    advance_pose(body, state, step, rule);
  }
  throw std::runtime_error("the box has not turned over after 30 s");
}

Column of_rule(RotationRule rule, const std::string& ending, const std::string& unit,
               const std::string& meaning) {
  const std::string name(name_of(rule));
  return {name + ending, unit, meaning + ", rule " + name};
}

// How wrong the moment of the first flip is under each rule, for four steps.
Table flip_errors(const FreeRotation& exact) {
  const BodyProperties body = uneven_box();
  Table table{"flips", {{"step_s", "s", "time step"}}};
  for (const RotationRule rule : rotation_rules())
    table.columns.push_back(of_rule(rule, "_s", "s", "error of the first flip"));
  constexpr std::array<double, 4> steps_per_second = {60.0, 120.0, 240.0, 1000.0};
  for (const double frequency : steps_per_second) {
    std::vector<double> errors;
    for (const RotationRule rule : rotation_rules())
      errors.push_back(first_flip(body, 1.0 / frequency, rule) - exact.first_flip());
    table.add(1.0 / frequency, errors);
  }
  return table;
}

Result measure_rotation_rules(const Parameters& settings) {
  const double step = settings.number("step");
  const BodyProperties body = uneven_box();
  const FreeRotation exact(body.inertia_b, kUnstableSpin);
  constexpr double accepted = 1e-6;

  Table table{"",
              {{"time_s", "s", "time"},
               {"exact_rad_s", "rad/s", "middle angular velocity, body frame, exact"}}};
  for (const RotationRule rule : rotation_rules())
    table.columns.push_back(of_rule(rule, "_rad_s", "rad/s", "middle angular velocity"));
  for (const RotationRule rule : rotation_rules())
    table.columns.push_back(of_rule(rule, "_energy", "-", "energy error over the energy"));
  table.columns.push_back({"accepted", "-", "energy error accepted of rule rk4"});

  std::vector<BodyState> states(rotation_rules().size(), spun(body, kUnstableSpin));
  double worst = 0.0;
  const double energy = kinetic_energy(body, states.front());
  const int steps = static_cast<int>(std::lround(settings.number("duration") / step));
  for (int k = 0; k <= steps; ++k) {
    std::vector<double> rates;
    std::vector<double> errors;
    for (std::size_t i = 0; i < states.size(); ++i) {
      rates.push_back(middle_rate(body, states[i]));
      errors.push_back(std::abs(kinetic_energy(body, states[i]) / energy - 1.0));
      if (rotation_rules()[i] == RotationRule::frozen) worst = std::max(worst, errors.back());
      advance_pose(body, states[i], step, rotation_rules()[i]);
    }
    table.add(k * step, exact.at(k * step).y(), rates, errors, accepted);
  }
  return {{table, flip_errors(exact)},
          {{"time between flips, exact", "s", exact.flip_interval()},
           {"largest energy error, frozen", "-", worst}}};
}

const Registered rotation_rules_figure{
    {.name = "rotation_rules",
     .parameters = {number("step", 0.02, 1e-4, 0.2, "s", "time step of the curves"),
                    number("duration", 12.0, 1.0, 60.0, "s", "length of the run")},
     .quick = {"duration=4"},
     .experiment = measure_rotation_rules}};

}  // namespace
}  // namespace tumble::chapters
