/// \file
/// \brief The direct solver: Newton steps where ADMM does not converge.
#include "tumble/base/index.hpp"
#include "tumble/contact_damped/island_math.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

using island_math::raise;

namespace {

// [-] Evaluations of a line search, at most. Reason: secants halve the interval or better. (6.3.1)
constexpr int kLineSearchEvaluations = 12;
// [-] Share of the slope at the start of a Newton step at which its line search ends. Reason: the next step matters more than the
// end of this one. (6.3.1)
constexpr double kLineSearchSlope = 0.3;
// [-] Share of the interval that a line search cuts off each time, at least. Reason: secants may stall. (6.3.1)
constexpr double kLineSearchCut = 0.1;

// Derivative of into_cone(a, mu) with respect to a. Symmetric, between 0 and 1.
Mat3 slope_of_cone(const Vec3& a, double mu) {
  const double size = std::sqrt(a[0] * a[0] + a[1] * a[1]);
  if (mu * size <= -a[2]) return Mat3::Zero();
  if (size <= mu * a[2]) return Mat3::Identity();
  // Onto the surface: along its straight line, and around the cone.
  const Vec3 slip(a[0] / size, a[1] / size, 0.0);
  const Vec3 line = mu * slip + Vec3::UnitZ();
  const Vec3 around(-slip[1], slip[0], 0.0);
  const double radius = mu * (a[2] + mu * size) / (1.0 + mu * mu);
  return line * line.transpose() / (1.0 + mu * mu) + radius / size * around * around.transpose();
}

}  // namespace

// Impulses of the stiff springs at the present velocities, and their derivatives.
void IslandSolver::evaluate_springs(std::span<const ContactPatch> patches) {
  for (const Constraint& constraint : constraints_) {
    const Six motion = motion_now(constraint, patches[idx(constraint.patch)]);
    for (int i = constraint.begin; i < constraint.end; ++i) {
      Point& p = points_[idx(i)];
      const double rho = tolerance::newton_stiffness / p.inverse_mass;
      p.motion = velocity_at(p.along, p.across, motion);
      p.motion[2] += p.shift - p.target;
      const Vec3 asked = p.impulse - rho * p.motion;
      p.spring_impulse = into_cone(asked, p.friction);
      p.spring_slope = rho * slope_of_cone(asked, p.friction);
    }
  }
}

// One Newton step towards the balance of springs and bodies. Returns the largest change of a point's motion [m/s].
double IslandSolver::newton_step(std::span<const ContactPatch> patches) {
  factor(patches, true);
  begin_right_side();
  for (const Constraint& constraint : constraints_) {
    Six push{};
    for (int i = constraint.begin; i < constraint.end; ++i) {
      const Point& p = points_[idx(i)];
      Vec3 u = p.motion;
      u[2] -= p.shift - p.target;
      add_push(p.along, p.across, p.spring_impulse + p.spring_slope * u, push);
    }
    add_to_right_side(constraint, patches[idx(constraint.patch)], push);
  }
  solve_with_factors();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    newton_start_[m] = members_[m].now;
    x_[m] -= newton_start_[m];
  }
  const double share = line_search(patches);
  double moved = 0.0;
  for (const Point& p : points_) raise(share * p.motion_change.norm(), moved);
  return moved;
}

// Goes along a Newton step as far as the convex function decreases, to where its slope is small, by secants.
// Returns the share of the step.
double IslandSolver::line_search(std::span<const ContactPatch> patches) {
  for (Point& p : points_) {
    p.motion_change = p.motion;
    p.start_impulse = p.spring_impulse;
  }
  double high = 1.0;
  move_along(high, patches);
  for (Point& p : points_) p.motion_change = p.motion - p.motion_change;
  const double start = slope(0.0);
  double at_high = slope(high);
  const double small = kLineSearchSlope * std::abs(start);
  if (!(start < 0.0 && at_high > small)) return high;
  double low = 0.0, at_low = start;
  double share = high;
  for (int k = 0; k < kLineSearchEvaluations; ++k) {
    const double secant =
        std::clamp(at_low / (at_low - at_high), kLineSearchCut, 1.0 - kLineSearchCut);
    share = low + (high - low) * secant;
    move_along(share, patches);
    const double now = slope(share);
    if (std::abs(now) <= small) break;
    (now > 0.0 ? high : low) = share;
    (now > 0.0 ? at_high : at_low) = now;
  }
  return share;
}

void IslandSolver::move_along(double share, std::span<const ContactPatch> patches) {
  for (std::size_t m = 0; m < members_.size(); ++m)
    members_[m].now = newton_start_[m] + share * x_[m];
  evaluate_springs(patches);
}

// Derivative of the convex function along a Newton step, at a share of it where springs are evaluated [J].
double IslandSolver::slope(double share) const {
  double sum = 0.0;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Member& member = members_[m];
    const Vec6 d = newton_start_[m] + share * x_[m] - member.free;
    sum += member.mass * d.head<3>().dot(x_[m].head<3>()) +
           x_[m].tail<3>().dot(member.inertia_w * d.tail<3>());
  }
  for (const Point& p : points_)
    sum -= (share == 0.0 ? p.start_impulse : p.spring_impulse).dot(p.motion_change);
  return sum;
}

// The shifts of the present sliding. ADMM does without those of points that slide fast.
void IslandSolver::start_shifts(std::span<const ContactPatch> patches) {
  for (const Constraint& constraint : constraints_) {
    const Six motion = motion_now(constraint, patches[idx(constraint.patch)]);
    for (int i = constraint.begin; i < constraint.end; ++i) {
      Point& p = points_[idx(i)];
      p.shift = p.friction * velocity_at(p.along, p.across, motion).head<2>().norm();
    }
  }
}

// Impulses become those of the springs, and shifts follow the sliding. Returns the larger one of a residual and the
// largest change by that [m/s].
double IslandSolver::update_impulses(double shift_tolerance, double residual) {
  for (Point& p : points_) {
    raise(p.inverse_mass / tolerance::newton_stiffness * (p.spring_impulse - p.impulse).norm(),
          residual);
    p.impulse = p.spring_impulse;
    const double shift = p.friction * p.motion.head<2>().norm();
    const double change = std::abs(shift - p.shift);
    if (p.impulse[2] > 0.0 && !(change <= shift_tolerance)) raise(change, residual);
    p.shift = shift;
  }
  return residual;
}

// Newton steps to the balance of springs and bodies, a handful at most. Returns the last one's change [m/s].
double IslandSolver::balance(std::span<const ContactPatch> patches, double balanced, int most,
                             int& steps) {
  evaluate_springs(patches);
  double change = std::numeric_limits<double>::infinity();
  for (int k = 0; k < tolerance::newton_steps_in_a_row && steps < most; ++k) {
    ++steps;
    change = newton_step(patches);
    if (change <= balanced) break;
  }
  return change;
}

// The springs of ADMM, but stiffer, and all kept in balance with the bodies by Newton steps: a handful where ADMM
// would need thousands of iterations. Then impulses and shifts are updated, and so on until neither changes. If that
// does not converge, the best result in balance is taken if IslandLimits allow that and it is much better than that of ADMM.
void IslandSolver::newton(std::span<const ContactPatch> patches, const IslandLimits& limits,
                          IslandResult& result) {
  const auto steep = [](const Point& p) {
    return p.friction > tolerance::newton_steepest_friction;
  };
  if (std::any_of(points_.begin(), points_.end(), steep)) return;
  saved_points_ = points_;
  saved_members_ = members_;
  start_shifts(patches);
  int steps = 0;
  double residual = result.residual;
  double best = tolerance::newton_improved * residual;
  const double balanced = tolerance::newton_balanced * limits.residual;
  // [S6.3.1:newton]
  for (int update = 0; update < limits.max_shift_updates; ++update) {
    if (steps >= limits.max_newton_steps || residual < limits.residual) break;
    const double change = balance(patches, balanced, limits.max_newton_steps, steps);
    if (!(change < limits.residual)) break;
    residual = update_impulses(limits.shift_tolerance, change);
    if (!(limits.shift_tolerance > 0.0 && residual < best)) continue;
    best = residual;
    result.improved = true;
    saved_points_ = points_;
    saved_members_ = members_;
    if (residual < limits.good_residual) break;
  }
  // [S6.3.1:newton]
  result.factorizations += steps;
  result.converged = residual < limits.residual;
  if (result.converged) {
    result.improved = false;
    result.residual = residual;
  } else {
    if (result.improved) result.residual = best;
    points_ = saved_points_;
    members_ = saved_members_;
  }
}

IslandResult IslandSolver::solve_normal(const Island& island, const IslandLimits& limits,
                                        std::span<const MovingBody> held) {
  IslandResult result;
  load(island, held, FrictionLaw::held);
  if (costs_too_much(limits.max_work)) return result;
  result.accepted = true;
  const double balanced = tolerance::newton_balanced * limits.residual;
  while (!result.converged && result.factorizations < limits.max_newton_steps) {
    const double change =
        balance(island.all_patches, balanced, limits.max_newton_steps, result.factorizations);
    result.residual = update_impulses(0.0, change);
    result.converged = result.residual < limits.residual && change <= balanced;
  }
  store(island, held, FrictionLaw::held);
  return result;
}

}  // namespace tumble
