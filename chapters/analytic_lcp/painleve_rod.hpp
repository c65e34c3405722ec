/// \file
/// \brief Painlevé's rod: a stick that slides on its lower end (thesis 2.6.3).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble::chapters {

/// A thin rod of 1 kg and a half length of 1 m. Its lower end is on the ground and slides to the left,
/// away from the side to which the rod leans; the pole pushed over a blackboard like a chalk.
struct PainleveRod {
  double angle = 1.0;     ///< [rad] above the ground, to the right
  double friction = 0.0;  ///< [-] Coulomb's coefficient, at least 0
  double spin = 0.0;      ///< [rad/s] angular velocity
};

/// What a force N does to the acceleration of the lower end, away from the ground, while friction
/// \f$\mu N\f$ pushes it to the right.
/// \param rod the rod
/// \return [1/kg] \f$p = \tfrac1m (1 + 3\cos^2\theta - 3\mu\sin\theta\cos\theta)\f$; below 0, pushing
///         harder makes the end dive
double push_response(const PainleveRod& rod);

/// The acceleration of the lower end away from the ground without a force there.
/// \param rod the rod
/// \return [m/s²] \f$b = l\,\omega^2\sin\theta - g\f$
double free_acceleration(const PainleveRod& rod);

/// All forces that obey \f$N \ge 0,\; pN + b \ge 0,\; N(pN + b) = 0\f$.
/// \param rod the rod
/// \return [N] none, one or two, ascending
std::vector<double> possible_forces(const PainleveRod& rod);

/// The friction beyond which there may be none or two.
/// \param angle  [rad]
/// \return [-] \f$\mu = (4 + \tan^2\theta) / (3\tan\theta)\f$, where p = 0
double critical_friction(double angle);

/// What a time step does to the rod's lower end.
struct RodStep {
  LcpStatus status = LcpStatus::solved;  ///< of Lemke's method
  double normal_impulse = 0.0;           ///< [N s] away from the ground
  double friction_impulse = 0.0;         ///< [N s] to the right
  double slip = 0.0;                     ///< [m/s] to the right, after the step
  double lift = 0.0;                     ///< [m/s] away from the ground, after the step
  double spin = 0.0;                     ///< [rad/s] after the step
};

/// A step of Stewart and Trinkle, and of Anitescu and Potra, on the velocities of a rod whose end
/// slides with -1 m/s.
///
/// Unknown are the impulses \f$c_n\f$ and \f$\beta_+, \beta_-\f$ along the normal and to either
/// side, and the speed of sliding \f$\lambda\f$, complementary to the velocity away from the ground, to
/// \f$\lambda \pm v_t\f$ and to \f$\mu c_n - \beta_+ - \beta_-\f$.
/// \param rod     the rod
/// \param step    [s] its length
/// \param solver  for an LCP whose matrix is not symmetric
/// \return the answer
RodStep step_rod(const PainleveRod& rod, double step, LcpSolver& solver);

}  // namespace tumble::chapters
