/// \file
/// \brief All contact areas of a island together: the rounds.
#include "tumble/contact_damped/island_solver.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact_damped/island_parts.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

using island::add_push, island::into_cone, island::motion_at, island::raise, island::wrench_of;

namespace {

constexpr double kRanAway = 10.0;  // times what was wrong after a round

}  // namespace

// All bodies give way to all springs.
void IslandSolver::give_way(std::span<const ContactPatch> blocks) {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    x_[m].head<3>() = members_[m].mass * members_[m].free.head<3>();
    x_[m].tail<3>() = members_[m].inertia_w * members_[m].free.tail<3>();
  }
  for (const Area& area : areas_) {
    const ContactPatch& block = blocks[at(area.block)];
    Six push{};
    for (int i = area.begin; i < area.end; ++i) {
      const Point& p = points_[at(i)];
      Vec3 goal = p.reached;  // of a point that slides: along the normal only
      goal[2] += p.target - p.shift;
      add_push(p.along, p.across, p.pushed + stiffness_ / p.yield * goal, push);
    }
    if (area.first >= 0) x_[at(area.first)] -= wrench_of(block.frame_w, block.first_arm_w, push);
    if (area.second >= 0) x_[at(area.second)] += wrench_of(block.frame_w, block.second_arm_w, push);
  }
  for (Vec6& x : x_) x *= unit_mass_;
  matrix_.solve(x_);
  for (std::size_t m = 0; m < members_.size(); ++m) members_[m].now = x_[m];
}

// Each point gets the impulse of its cone that is nearest to what its spring asks for.
void IslandSolver::put_right(std::span<const ContactPatch> blocks, double& primal, double& dual) {
  primal = dual = 0.0;
  for (Area& area : areas_) {
    const Six motion = motion_now(area, blocks[at(area.block)]);
    for (int i = area.begin; i < area.end; ++i) {
      Point& p = points_[at(i)];
      const double rho = stiffness_ / p.yield;
      Vec3 u = motion_at(p.along, p.across, motion);
      if (p.slides) {
        u[2] -= p.target;
        const double further = tolerance::island_relaxation * u[2] +
                               (1.0 - tolerance::island_relaxation) * p.reached[2];
        const double pushed = std::max(0.0, p.pushed[2] - rho * further);
        const double reached = further + (pushed - p.pushed[2]) / rho;
        raise(std::abs(u[2] - reached), primal);
        raise(std::abs(reached - p.reached[2]), dual);
        p.reached[2] = reached;
        p.pushed = -p.friction * pushed * p.slip;
        p.pushed[2] = pushed;
        continue;
      }
      const double slide = std::sqrt(u[0] * u[0] + u[1] * u[1]);
      u[2] += p.shift - p.target;
      // Going a little further than the spring did saves a third of the rounds.
      const Vec3 further =
          tolerance::island_relaxation * u + (1.0 - tolerance::island_relaxation) * p.reached;
      const Vec3 pushed = into_cone(p.pushed - rho * further, p.friction);
      const Vec3 reached = further + (pushed - p.pushed) / rho;
      raise((u - reached).norm(), primal);
      raise((reached - p.reached).norm(), dual);
      p.reached = reached;
      p.pushed = pushed;
      p.shift = p.friction * slide;
    }
  }
}

// Writes impulses back, and velocities: those that belong to the impulses if they are right or nearly so,
// else those of the springs, which keep the conditions better.
void IslandSolver::store(std::span<const int> members, bool solved,
                         std::span<const MovingBody> free, std::span<ContactPatch> blocks,
                         std::span<MovingBody> bodies) const {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    MovingBody& body = bodies[at(members[m])];
    body.velocity_w = solved ? free[at(members[m])].velocity_w : members_[m].now.head<3>();
    body.angular_velocity_w =
        solved ? free[at(members[m])].angular_velocity_w : members_[m].now.tail<3>();
    body.changed = true;
  }
  for (const Area& area : areas_) {
    ContactPatch& block = blocks[at(area.block)];
    Six sum{};
    for (int i = area.begin; i < area.end; ++i) {
      const Point& p = points_[at(i)];
      block.points[at(i - area.begin)].impulse = p.pushed[2];
      block.points[at(i - area.begin)].given = p.pushed;
      add_push(p.along, p.across, p.pushed, sum);
    }
    block.along_impulse = sum[0];
    block.across_impulse = sum[1];
    block.twist_impulse = sum[5];
    if (solved) apply(sum, block, bodies[at(block.first)], bodies[at(block.second)]);
  }
}

IslandResult IslandSolver::solve(std::span<const int> members, std::span<const int> contacts,
                                 const IslandLimits& limits, std::span<const MovingBody> free,
                                 std::span<ContactPatch> blocks, std::span<MovingBody> bodies) {
  IslandResult result;
  load(members, contacts, free, blocks, bodies);
  if (matrix_.analyse(static_cast<int>(members_.size()), joined_)) stamps_.clear();
  if (static_cast<double>(matrix_.multiplications_of_factor()) >
      limits.most_work * static_cast<double>(members.size()))
    return result;
  result.tried = true;
  stiffness_ = tolerance::island_stiffness;
  start_from(blocks, limits.unit);
  double first = 0.0;  // [m/s] wrong after one round
  for (int round = 1; round <= limits.most_rounds; ++round) {
    factor_if_changed(blocks, result);
    give_way(blocks);
    double primal = 0.0;
    double dual = 0.0;
    put_right(blocks, primal, dual);
    ++result.rounds;
    // The impulses alone leave velocities that are wrong by what springs still pull.
    result.wrong = std::max(stiffness_ * primal, dual);
    result.solved = result.wrong < limits.enough;
    if (round == 1) first = result.wrong;
    if (result.solved || std::isnan(result.wrong)) break;
    // Springs too soft: points are far from where they should be; too hard: nothing moves.
    if (round % 8 != 0 || round + 4 > limits.most_rounds) continue;
    const double ratio = std::sqrt(primal / dual);
    if (!(ratio > 3.0 || ratio < 1.0 / 3.0)) continue;
    stiffness_ = std::clamp(stiffness_ * std::clamp(ratio, 0.1, 10.0), 0.1, limits.hardest);
  }
  // The shift s is found by putting it in, which runs away where friction is very large.
  if (!(result.wrong <= kRanAway * first + limits.unit)) {
    result.tried = false;
    return result;
  }
  if (!result.solved && limits.most_steps > 0) polish(blocks, limits, result);
  store(members, result.solved || result.close, free, blocks, bodies);
  return result;
}

}  // namespace tumble
