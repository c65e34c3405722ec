/// \file
/// \brief All contact areas of a island together: the last digits.
#include "tumble/base/index.hpp"
#include "tumble/contact_damped/island_parts.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble {

using island::add_push, island::into_cone, island::motion_at, island::raise, island::wrench_of;

namespace {

constexpr int kMostLooks = 12;     // for where a step leads too far
constexpr double kLevel = 0.3;     // of the slope at its start: so far is gone along a step
constexpr double kLeastCut = 0.1;  // of the way that is left, by a look
constexpr int kStepsInARow = 10;   // before impulses and shifts follow
constexpr double kSteepest = 1.0;  // friction: beyond, shifts that follow slides run away from them
constexpr double kBalanced = 0.01;  // of what is enough: springs and bodies are in balance
constexpr double kMuchLess = 0.1;   // of what was wrong: so much less that it is taken as it is

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

// What the hard springs push at the present velocities, and how that follows them.
void IslandSolver::press(std::span<const ContactPatch> blocks) {
  for (const Area& area : areas_) {
    const Six motion = motion_now(area, blocks[at(area.block)]);
    for (int i = area.begin; i < area.end; ++i) {
      Point& p = points_[at(i)];
      const double rho = tolerance::island_polish / p.yield;
      p.motion = motion_at(p.along, p.across, motion);
      p.motion[2] += p.shift - p.target;
      const Vec3 asked = p.pushed - rho * p.motion;
      p.presses = into_cone(asked, p.friction);
      p.follows = rho * slope_of_cone(asked, p.friction);
    }
  }
}

// One step of Newton's towards the balance. Returns how far the motion of a point changed at most [m/s].
double IslandSolver::balance(std::span<const ContactPatch> blocks) {
  factor(blocks, false);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    x_[m].head<3>() = members_[m].mass * members_[m].free.head<3>();
    x_[m].tail<3>() = members_[m].inertia_w * members_[m].free.tail<3>();
  }
  for (const Area& area : areas_) {
    const ContactPatch& block = blocks[at(area.block)];
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
  const double share = go(blocks);
  double moved = 0.0;
  for (const Point& p : points_) raise(share * p.way.norm(), moved);
  return moved;
}

// Goes along the step as far as the function falls, which is convex. Its slope is sought to be small by
// secants. Returns the share of the step that was gone.
double IslandSolver::go(std::span<const ContactPatch> blocks) {
  for (Point& p : points_) {
    p.way = p.motion;
    p.pressed = p.presses;
  }
  double high = 1.0;
  go_to(high, blocks);
  for (Point& p : points_) {
    p.way = p.motion - p.way;
    std::swap(p.presses, p.pressed);
  }
  const double start = slope(0.0);
  for (Point& p : points_) std::swap(p.presses, p.pressed);
  double at_high = slope(high);
  const double enough = kLevel * std::abs(start);
  if (!(start < 0.0 && at_high > enough)) return high;
  double low = 0.0, at_low = start;
  double share = high;
  for (int look = 0; look < kMostLooks; ++look) {
    const double secant = std::clamp(at_low / (at_low - at_high), kLeastCut, 1.0 - kLeastCut);
    share = low + (high - low) * secant;
    go_to(share, blocks);
    const double now = slope(share);
    if (std::abs(now) <= enough) break;
    (now > 0.0 ? high : low) = share;
    (now > 0.0 ? at_high : at_low) = now;
  }
  return share;
}

void IslandSolver::go_to(double share, std::span<const ContactPatch> blocks) {
  for (std::size_t m = 0; m < members_.size(); ++m) members_[m].now = from_[m] + share * x_[m];
  press(blocks);
}

// How the function changes along the step, at a share of it, with what springs push there [J].
double IslandSolver::slope(double share) const {
  double sum = 0.0;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Member& member = members_[m];
    const Vec6 d = from_[m] + share * x_[m] - member.free;
    sum += member.mass * d.head<3>().dot(x_[m].head<3>()) +
           x_[m].tail<3>().dot(member.inertia_w * d.tail<3>());
  }
  for (const Point& p : points_) sum -= p.presses.dot(p.way);
  return sum;
}

// The same springs as in the rounds, but hard, and all of them kept in balance with the bodies by Newton's
// steps: a handful where rounds would need thousands. Then impulses become what springs pushed, shifts what
// slides ask for, and so on until neither changes. If that does not come to an end nothing is changed, or if it
// need not, what is much better than before is taken.
void IslandSolver::polish(std::span<const ContactPatch> blocks, const IslandLimits& limits,
                          IslandResult& result) {
  const auto steep = [](const Point& p) { return p.friction > kSteepest; };
  if (std::any_of(points_.begin(), points_.end(), steep)) return;
  points_before_ = points_;
  members_before_ = members_;
  stamps_.clear();  // factors are no longer those of the rounds
  int steps = 0;
  double moved = 0.0;
  double wrong = result.wrong;
  for (int turn = 0; turn < limits.most_turns; ++turn) {
    if (steps >= limits.most_steps || wrong < limits.enough) break;
    press(blocks);
    for (int k = 0; k < kStepsInARow && steps < limits.most_steps; ++k) {
      ++steps;
      moved = balance(blocks);
      if (moved < kBalanced * limits.enough) break;
    }
    wrong = moved;
    for (Point& p : points_) {
      raise(p.yield / tolerance::island_polish * (p.presses - p.pushed).norm(), wrong);
      p.pushed = p.presses;
      const double shift = p.friction * p.motion.head<2>().norm();
      const double off = std::abs(shift - p.shift);
      if (p.pushed[2] > 0.0 && !(off <= limits.loose)) raise(off, wrong);
      p.shift = shift;
    }
  }
  result.factorings += steps;
  result.solved = wrong < limits.enough;
  result.close = !result.solved && limits.loose > 0.0 && moved < limits.enough &&
                 wrong < kMuchLess * result.wrong;
  if (result.solved || result.close) {
    result.wrong = wrong;
  } else {
    points_ = points_before_;
    members_ = members_before_;
  }
}

}  // namespace tumble
