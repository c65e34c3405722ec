/// \file
/// \brief All contact areas of a heap together: the last digits.
#include "tumble/base/tolerance.hpp"
#include "tumble/impulse_damped/heap_parts.hpp"
#include "tumble/impulse_damped/heap_solver.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

using heap::add_push, heap::into_cone, heap::motion_at, heap::raise, heap::wrench_of;

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

constexpr int kMostHalvings = 12;  // of a step that leads too far
constexpr int kStepsInARow = 10;   // before impulses and shifts follow
constexpr double kSteepest = 1.0;  // friction: beyond, shifts that follow slides run away from them
constexpr double kBalanced = 0.01;  // of what is enough: springs and bodies are in balance

// How the nearest point of Coulomb's cone follows the point a. Symmetric, between 0 and 1.
Mat3 slope_of_cone(const Vec3& a, double mu) {
  const double size = std::sqrt(a[0] * a[0] + a[1] * a[1]);
  if (mu * size <= -a[2]) return Mat3::Zero();
  if (size <= mu * a[2]) return Mat3::Identity();
  // On the surface: along its straight line, and around the cone.
  const Vec3 slip(a[0] / size, a[1] / size, 0.0);
  const Vec3 line = mu * slip + Vec3::UnitZ();
  const Vec3 around(-slip[1], slip[0], 0.0);
  const double radius = mu * (a[2] + mu * size) / (1.0 + mu * mu);
  return line * line.transpose() / (1.0 + mu * mu) + radius / size * around * around.transpose();
}

}  // namespace

// What the hard springs push at the present velocities, and how that follows them. Returns the function of
// the velocities that is least where bodies and springs are in balance [J].
double HeapSolver::press(std::span<const ContactBlock> blocks, double& moved) {
  double sum = 0.0;
  for (const Member& member : members_) {
    const Vec6 d = member.now - member.free;
    sum += 0.5 * (member.mass * d.head<3>().squaredNorm() +
                  d.tail<3>().dot(member.inertia_w * d.tail<3>()));
  }
  moved = 0.0;
  for (const Area& area : areas_) {
    const Six motion = motion_now(area, blocks[at(area.block)]);
    for (int i = area.begin; i < area.end; ++i) {
      Point& p = points_[at(i)];
      const double rho = tolerance::heap_polish / p.yield;
      Vec3 u = motion_at(p.along, p.across, motion);
      u[2] += p.shift - p.target;
      raise((u - p.motion).norm(), moved);
      p.motion = u;
      const Vec3 asked = p.pushed - rho * u;
      p.presses = into_cone(asked, p.friction);
      p.follows = rho * slope_of_cone(asked, p.friction);
      sum += 0.5 / rho * p.presses.squaredNorm();
    }
  }
  return sum;
}

// One step of Newton's towards the balance, halved while it leads up. Returns how far the motion of a point
// changed at most [m/s].
double HeapSolver::balance(std::span<const ContactBlock> blocks, double& sum) {
  factor(blocks, false);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    x_[m].head<3>() = members_[m].mass * members_[m].free.head<3>();
    x_[m].tail<3>() = members_[m].inertia_w * members_[m].free.tail<3>();
  }
  for (const Area& area : areas_) {
    const ContactBlock& block = blocks[at(area.block)];
    Six push{};
    for (int i = area.begin; i < area.end; ++i) {
      const Point& p = points_[at(i)];
      Vec3 u = p.motion;
      u[2] -= p.shift - p.target;
      add_push(p.along, p.across, p.presses + p.follows * u, push);
    }
    if (area.first >= 0) x_[at(area.first)] -= wrench_of(block.frame_w, block.first_arm_w, push);
    if (area.second >= 0) x_[at(area.second)] += wrench_of(block.frame_w, block.second_arm_w, push);
  }
  for (Vec6& x : x_) x *= unit_mass_;
  matrix_.solve(x_);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    from_[m] = members_[m].now;
    x_[m] -= from_[m];
  }
  const double before = sum;
  double moved = 0.0;
  double share = 1.0;
  for (int halving = 0; halving <= kMostHalvings; ++halving, share *= 0.5) {
    for (std::size_t m = 0; m < members_.size(); ++m) members_[m].now = from_[m] + share * x_[m];
    sum = press(blocks, moved);
    if (sum <= before * (1.0 + tolerance::energy_rounding)) break;
  }
  return moved;
}

// The same springs as in the rounds, but hard, and all of them kept in balance with the bodies by Newton's
// steps: a handful where rounds would need thousands. Then impulses become what springs pushed, shifts what
// slides ask for, and so on until neither changes. If that does not come to an end nothing is changed.
void HeapSolver::polish(std::span<const ContactBlock> blocks, const HeapLimits& limits,
                        HeapResult& result) {
  const auto steep = [](const Point& p) { return p.friction > kSteepest; };
  if (std::any_of(points_.begin(), points_.end(), steep)) return;
  points_before_ = points_;
  members_before_ = members_;
  stamps_.clear();  // factors are no longer those of the rounds
  int steps = 0;
  double moved = 0.0;
  double wrong = result.wrong;
  while (steps < limits.most_steps && !(wrong < limits.enough)) {
    double sum = press(blocks, moved);
    for (int k = 0; k < kStepsInARow && steps < limits.most_steps; ++k) {
      ++steps;
      moved = balance(blocks, sum);
      if (moved < kBalanced * limits.enough) break;
    }
    wrong = moved;
    for (Point& p : points_) {
      raise(p.yield / tolerance::heap_polish * (p.presses - p.pushed).norm(), wrong);
      p.pushed = p.presses;
      const double shift = p.friction * p.motion.head<2>().norm();
      if (p.pushed[2] > 0.0) raise(std::abs(shift - p.shift), wrong);
      p.shift = shift;
    }
  }
  result.factorings += steps;
  result.solved = wrong < limits.enough;
  if (result.solved) {
    result.wrong = wrong;
  } else {
    points_ = points_before_;
    members_ = members_before_;
  }
}

}  // namespace tumble
