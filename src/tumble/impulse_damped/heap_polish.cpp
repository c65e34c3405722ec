/// \file
/// \brief All contact areas of a heap together: the last digits.
#include "tumble/base/tolerance.hpp"
#include "tumble/impulse_damped/heap_parts.hpp"
#include "tumble/impulse_damped/heap_solver.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

using heap::add_push, heap::motion_at, heap::wrench_of;

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

// The rounds have found out which points push and which of those stick: with that known what is left are
// equations, and springs that are hard, and have pushed already, solve them. Returns whether the answer
// fits what was assumed; if not, nothing is changed.
bool HeapSolver::polish(std::span<const ContactBlock> blocks, double enough, HeapResult& result) {
  before_ = points_;
  for (int attempt = 0; attempt < 3; ++attempt) {
    for (Point& p : points_) {
      const double bound = p.friction * p.pushed[2];
      const double rub = std::sqrt(p.pushed[0] * p.pushed[0] + p.pushed[1] * p.pushed[1]);
      p.pushes = p.pushed[2] > 0.0;
      p.sticks = p.pushes && rub < bound && !p.slides;
    }
    factor(blocks, false);
    ++result.factorings;
    stamps_.clear();
    double wrong = 0.0;
    for (int round = 0; round < 3; ++round) {
      for (std::size_t m = 0; m < members_.size(); ++m) {
        x_[m].head<3>() = members_[m].mass * members_[m].free.head<3>();
        x_[m].tail<3>() = members_[m].inertia_w * members_[m].free.tail<3>();
      }
      for (const Area& area : areas_) {
        const ContactBlock& block = blocks[at(area.block)];
        Six push{};
        for (int i = area.begin; i < area.end; ++i) {
          const Point& p = points_[at(i)];
          Vec3 asked = p.pushed;
          if (p.pushes) asked[2] += tolerance::heap_hardness / p.yield * p.target;
          add_push(p.along, p.across, asked, push);
        }
        if (area.first >= 0)
          x_[at(area.first)] -= wrench_of(block.frame_w, block.first_arm_w, push);
        if (area.second >= 0)
          x_[at(area.second)] += wrench_of(block.frame_w, block.second_arm_w, push);
      }
      for (Vec6& x : x_) x *= unit_mass_;
      matrix_.solve(x_);
      for (std::size_t m = 0; m < members_.size(); ++m) members_[m].now = x_[m];
      wrong = 0.0;
      for (const Area& area : areas_) {
        const Six motion = motion_now(area, blocks[at(area.block)]);
        for (int i = area.begin; i < area.end; ++i) {
          Point& p = points_[at(i)];
          Vec3 u = motion_at(p.along, p.across, motion);
          u[2] -= p.target;
          const double k = tolerance::heap_hardness / p.yield;
          if (p.sticks) p.pushed.head<2>() -= k * u.head<2>();
          if (p.pushes) p.pushed[2] -= k * u[2];
          if (p.sticks) wrong = std::max(wrong, std::max(std::abs(u[0]), std::abs(u[1])));
          if (p.pushes) wrong = std::max(wrong, std::abs(u[2]));
          if (!p.pushes) wrong = std::max(wrong, -u[2]);
        }
      }
    }
    // Pulls and friction beyond its bound, as the velocities that they stand for.
    for (Point& p : points_) {
      const Vec3 allowed = p.pushed[2] > 0.0 ? p.pushed : Vec3::Zero();
      Vec3 a = allowed;
      const double bound = p.friction * a[2];
      const double rub = std::sqrt(a[0] * a[0] + a[1] * a[1]);
      if (rub > bound) a.head<2>() *= bound / rub;
      wrong = std::max(wrong, p.yield * (a - p.pushed).cwiseAbs().maxCoeff());
      p.pushed = a;
    }
    result.wrong = wrong;
    if (wrong < enough) return true;
  }
  points_ = before_;
  return false;
}

}  // namespace tumble
