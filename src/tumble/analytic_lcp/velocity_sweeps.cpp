/// \file
/// \brief Islands of a velocity step that are too large for one problem, or that Lemke's method does not solve.
#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

bool VelocityStep::is_large(const Task& task) const {
  return FrictionPyramid::unknowns(task.contacts, points_, task.options.directions) >
         FrictionLemkeSolver::kMostUnknowns;
}

// The answer, point by point.
void VelocityStep::take_pushes() {
  std::size_t next = 0;
  for (Candidate& candidate : candidates())
    candidate.push_w = candidate.taken_up ? pushes_[next++] : Vec3::Zero();
}

// All points of the island at once, from the pushes found so far. Returns whether they are of use: always without
// restitution.
bool VelocityStep::sweep(const Task& task, int island, bool bounce, VelocityStepResult& result) {
  for (Candidate& candidate : candidates()) {
    candidate.taken_up = true;
    candidate.rubs = true;
  }
  list_points(task.contacts, bounce);
  pushes_.clear();
  for (const Candidate& candidate : candidates()) pushes_.push_back(candidate.push_w);
  const FrictionSweepReport done =
      sweeps_.solve(free_, task.contacts, points_, tolerance::sweeps_settled * speed_, pushes_);
  result.pivots += done.sweeps;
  if (!std::isfinite(done.error)) return false;
  if (bounce && done.error > tolerance::sweep_bounce * speed_) return false;
  take_pushes();
  apply_pushes(task, island);
  if (!bounce) take_no_energy(task, island);
  ++result.fallbacks;
  if (speed_ > 0.0) result.residual = std::max(result.residual, done.error / speed_);
  return true;
}

// Pushes without restitution only take energy, W = p·u + p·A p/2 <= 0 with u the motion without them. Sweeps that
// have not settled may break this by a little: then the part of them that does not is used.
void VelocityStep::take_no_energy(const Task& task, int island) {
  double slope = 0.0;
  double curvature = 0.0;
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = task.contacts[idx(candidate.contact)];
    const Vec3& place_w = contact.points[idx(candidate.point)].position_w;
    const auto motion = [&](const std::vector<MovingBody>& bodies) {
      return relative_velocity(bodies[idx(contact.first)], bodies[idx(contact.second)], place_w);
    };
    const Vec3 u = motion(free_);
    slope += candidate.push_w.dot(u);
    curvature += candidate.push_w.dot(motion(ended_) - u);
  }
  if (slope + 0.5 * curvature <= 0.0) return;
  const double share = slope < 0.0 && curvature > 0.0 ? -2.0 * slope / curvature : 0.0;
  for (Candidate& candidate : candidates()) candidate.push_w *= share;
  apply_pushes(task, island);
}

}  // namespace tumble
