/// \file
/// \brief The direct solver: ADMM iterations.
#include "tumble/contact_damped/island_solver.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact_damped/island_math.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

using island_math::raise;

// First half of an ADMM iteration: the velocities of all bodies, with all springs on.
void IslandSolver::solve_velocities(std::span<const ContactPatch> patches) {
  // [S6.3.1:velocities]
  begin_right_side();
  for (const Constraint& constraint : constraints_) {
    Six push{};
    for (int i = constraint.begin; i < constraint.end; ++i) {
      const Point& p = points_[idx(i)];
      Vec3 target = p.auxiliary;  // of a point that slides: along the normal only
      target[2] += p.target - p.shift;
      add_push(p.along, p.across, p.impulse + stiffness_ / p.inverse_mass * target, push);
    }
    add_to_right_side(constraint, patches[idx(constraint.patch)], push);
  }
  solve_with_factors();
  for (std::size_t m = 0; m < members_.size(); ++m) members_[m].now = x_[m];
  // [S6.3.1:velocities]
}

// Second half: each point gets the impulse in its cone that is nearest to that of its spring.
void IslandSolver::project_impulses(std::span<const ContactPatch> patches, FrictionLaw law,
                                    double& primal, double& dual) {
  primal = dual = 0.0;
  for (Constraint& constraint : constraints_) {
    const Six motion = motion_now(constraint, patches[idx(constraint.patch)]);
    for (int i = constraint.begin; i < constraint.end; ++i) {
      Point& p = points_[idx(i)];
      const double rho = stiffness_ / p.inverse_mass;
      Vec3 u = velocity_at(p.along, p.across, motion);
      if (p.slides) {
        u[2] -= p.target;
        const double further =
            tolerance::admm_relaxation * u[2] + (1.0 - tolerance::admm_relaxation) * p.auxiliary[2];
        const double impulse = std::max(0.0, p.impulse[2] - rho * further);
        const double auxiliary = further + (impulse - p.impulse[2]) / rho;
        raise(std::abs(u[2] - auxiliary), primal);
        raise(std::abs(auxiliary - p.auxiliary[2]), dual);
        p.auxiliary[2] = auxiliary;
        // Friction of the pressure of the iteration before: beyond a coefficient of 1 it comes nearer in small steps, else it
        // swings.
        const Vec3 friction = -p.friction * impulse * p.slip_direction;
        p.impulse = p.friction > tolerance::newton_steepest_friction
                        ? p.impulse + tolerance::steep_friction_share * (friction - p.impulse)
                        : friction;
        p.impulse[2] = impulse;
        continue;
      }
      // [S6.3.1:project]
      const double slide = std::sqrt(u[0] * u[0] + u[1] * u[1]);
      u[2] += p.shift - p.target;
      // Over-relaxation saves a third of the iterations.
      const Vec3 further =
          tolerance::admm_relaxation * u + (1.0 - tolerance::admm_relaxation) * p.auxiliary;
      const Vec3 impulse = into_cone(p.impulse - rho * further, p.friction);
      const Vec3 auxiliary = further + (impulse - p.impulse) / rho;
      raise((u - auxiliary).norm(), primal);
      raise((auxiliary - p.auxiliary).norm(), dual);
      p.auxiliary = auxiliary;
      p.impulse = impulse;
      p.shift = law == FrictionLaw::coulomb ? p.friction * slide : 0.0;
      // [S6.3.1:project]
    }
  }
}

// z of a point that does not slide, from its motion against the target.
void IslandSolver::start_auxiliary(const Vec3& motion, Point& point) const {
  const double rho = stiffness_ / point.inverse_mass;
  point.auxiliary =
      motion + (into_cone(point.impulse - rho * motion, point.friction) - point.impulse) / rho;
}

// Friction may stop a point that was taken for sliding on: a heavy body pushes a light one. Where it would turn the slide around
// the point gets tangential springs like others. Returns whether there are any.
bool IslandSolver::hold_reversed(std::span<const ContactPatch> patches) {
  bool any = false;
  for (const Constraint& constraint : constraints_) {
    const Six motion = motion_now(constraint, patches[idx(constraint.patch)]);
    for (int i = constraint.begin; i < constraint.end; ++i) {
      Point& p = points_[idx(i)];
      if (!p.slides) continue;
      Vec3 u = velocity_at(p.along, p.across, motion);
      if (!(p.friction * p.impulse[2] > 0.0 && u.dot(p.slip_direction) < 0.0)) continue;
      u[2] -= p.target;
      p.slides = false;
      start_auxiliary(u, p);
      any = true;
    }
  }
  return any;
}

// Springs too soft: the primal residual is large, points are far from where they should be. Too stiff: the dual
// one is large, and nothing moves.
void IslandSolver::adjust_stiffness(double primal, double dual, double most) {
  const double ratio = std::sqrt(primal / dual);
  const double unbalanced = tolerance::residuals_unbalanced;
  if (!(ratio > unbalanced || ratio < 1.0 / unbalanced)) return;
  const double change =
      std::clamp(ratio, 1.0 / tolerance::stiffness_change, tolerance::stiffness_change);
  stiffness_ = std::clamp(stiffness_ * change, tolerance::admm_min_stiffness, most);
}

// Writes impulses back, and the velocities that follow from them. Friction that is held stays as it is.
void IslandSolver::store(const Island& island, std::span<const MovingBody> free,
                         FrictionLaw law) const {
  const std::span<MovingBody> now = island.now;
  const bool friction = law != FrictionLaw::held;
  for (const int k : island.bodies) {
    now[idx(k)].velocity_w = free[idx(k)].velocity_w;
    now[idx(k)].angular_velocity_w = free[idx(k)].angular_velocity_w;
    now[idx(k)].changed = true;
  }
  for (const Constraint& constraint : constraints_) {
    ContactPatch& patch = island.all_patches[idx(constraint.patch)];
    Six sum{};
    for (int i = constraint.begin; i < constraint.end; ++i) {
      const Point& p = points_[idx(i)];
      ContactPatchPoint& point = patch.points[p.place];
      point.impulse = p.impulse[2];
      if (friction) point.solver_impulse = p.impulse;
      add_push(p.along, p.across, p.impulse, sum);
    }
    if (friction) {
      patch.along_impulse = sum[0];
      patch.across_impulse = sum[1];
      patch.twist_impulse = sum[5];
    }
    apply(sum, patch, now[idx(patch.first)], now[idx(patch.second)]);
  }
}

// ADMM iterations until the residual is small, or too many, after begin_iterations() or from where they were. Returns false if
// they have diverged.
bool IslandSolver::iterate(std::span<const ContactPatch> patches, const IslandLimits& limits,
                           FrictionLaw law, IslandResult& result) {
  double factored = 0.0;  // stiffness in the factors
  for (int k = 1; k <= limits.max_iterations; ++k) {
    if (factored != stiffness_) {
      factored = stiffness_;
      ++result.factorizations;
      factor(patches, false);
    }
    solve_velocities(patches);
    double primal = 0.0;
    double dual = 0.0;
    project_impulses(patches, law, primal, dual);
    ++result.iterations;
    // With the impulses alone, velocities are wrong by what the springs still contribute.
    result.residual = std::max(stiffness_ * primal, dual);
    result.converged = result.residual < limits.residual;
    if (first_residual_ == 0.0) first_residual_ = result.residual;
    const bool ends = result.converged || std::max(primal, dual) < limits.early_stop_residual ||
                      std::isnan(result.residual);
    const bool looks = k == tolerance::stiffness_interval || k == limits.max_iterations / 2;
    if ((ends || looks) && hold_reversed(patches)) {
      result.converged = false;
      factored = 0.0;
      continue;
    }
    if (ends) break;
    if (k % tolerance::stiffness_interval == 0 &&
        k + tolerance::stiffness_last <= limits.max_iterations)
      adjust_stiffness(primal, dual, limits.max_stiffness);
  }
  return result.residual <= tolerance::admm_diverged * first_residual_ + limits.unit_speed;
}

IslandResult IslandSolver::solve(const Island& island, const IslandLimits& limits) {
  const std::span<const ContactPatch> patches = island.all_patches;
  IslandResult result;
  load(island, island.free, FrictionLaw::coulomb);
  if (costs_too_much(limits.max_work)) return result;
  result.accepted = true;
  begin_iterations(patches, limits.unit_speed, FrictionLaw::coulomb);
  if (limits.near > 0.0) {
    result.residual = limits.near;
    newton(patches, limits, result);
    if (result.converged || result.improved) {
      store(island, island.free, FrictionLaw::coulomb);
      return result;
    }
  }
  bool stable = iterate(patches, limits, FrictionLaw::coulomb, result);
  if (stable && !result.converged && limits.max_newton_steps > 0) newton(patches, limits, result);
  if (stable && !result.converged && !result.improved && limits.more_iterations > 0) {
    IslandLimits more = limits;
    more.max_iterations = limits.more_iterations;
    stable = iterate(patches, more, FrictionLaw::coulomb, result);
  }
  if (stable) {
    store(island, island.free, FrictionLaw::coulomb);
    return result;
  }
  load(island, island.free, FrictionLaw::convex);
  begin_iterations(patches, limits.unit_speed, FrictionLaw::convex);
  result.accepted = iterate(patches, limits, FrictionLaw::convex, result);
  if (result.accepted) store(island, island.free, FrictionLaw::convex);
  return result;
}

}  // namespace tumble
