/// \file
/// \brief Painlevé's rod: a stick that slides on its lower end (thesis 2.6.3).
#include "analytic_lcp/painleve_rod.hpp"

#include "tumble/math/elementary.hpp"

#include "driver/common_numbers.hpp"

#include <algorithm>

namespace tumble::chapters {
namespace {

constexpr double kSlip = -1.0;  // [m/s] of the lower end before the step

// What an impulse (tangential, normal) at the lower end changes. The end is at -(cos, sin) from the
// centre, the moment of inertia is 1/3.
struct Response {
  double tangent_tangent;  // [1/kg]
  double tangent_normal;   // [1/kg]
  double normal_normal;    // [1/kg]
};

Response response(double angle) {
  const double sine = elementary::sin(angle);
  const double cosine = elementary::cos(angle);
  return {1.0 + 3.0 * sine * sine, -3.0 * sine * cosine, 1.0 + 3.0 * cosine * cosine};
}

}  // namespace

double push_response(const PainleveRod& rod) {
  const Response k = response(rod.angle);
  return k.normal_normal + rod.friction * k.tangent_normal;
}

double free_acceleration(const PainleveRod& rod) {
  return rod.spin * rod.spin * elementary::sin(rod.angle) - kGravity;
}

std::vector<double> possible_forces(const PainleveRod& rod) {
  const double p = push_response(rod);
  const double b = free_acceleration(rod);
  std::vector<double> forces;
  if (b >= 0.0) forces.push_back(0.0);                     // the end lifts off
  if (p != 0.0 && -b / p > 0.0) forces.push_back(-b / p);  // it stays
  return forces;
}

double critical_friction(double angle) {
  const double tangent = elementary::sin(angle) / elementary::cos(angle);
  return (4.0 + tangent * tangent) / (3.0 * tangent);
}

RodStep step_rod(const PainleveRod& rod, double step, LcpSolver& solver) {
  // Rows and unknowns: normal, right, left, speed of sliding.
  const Response k = response(rod.angle);
  const double tt = k.tangent_tangent;
  const double tn = k.tangent_normal;
  LcpProblem problem{MatX(4, 4), VecX(4), {}};
  problem.A << k.normal_normal, tn, -tn, 0.0, tn, tt, -tt, 1.0, -tn, -tt, tt, 1.0, rod.friction,
      -1.0, -1.0, 0.0;
  problem.b << -kGravity * step, kSlip, -kSlip, 0.0;
  LcpResult answer;
  solver.solve(problem, answer);

  RodStep after;
  after.status = answer.status;
  const double normal = answer.f[0];
  const double tangential = answer.f[1] - answer.f[2];
  after.normal_impulse = normal;
  after.friction_impulse = tangential;
  after.slip = kSlip + tn * normal + tt * tangential;
  after.lift = answer.a[0];
  after.spin = rod.spin + 3.0 * (elementary::sin(rod.angle) * tangential -
                                 elementary::cos(rod.angle) * normal);
  return after;
}

}  // namespace tumble::chapters
