/// \file
/// \brief A velocity step where its problem is not the answer: restitution that the energy does not allow, and islands
/// that are too large for one problem or that Lemke's method does not solve.
#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/collision_law.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

// --- energy --------------------------------------------------------------------------------------

// What a push does to the energy, for each unit of it: the mean velocity of the point, less what gravity does not do
// because the body moves with the velocity of the end, which the push has changed. Between two bodies that can
// be moved gravity's shares cancel.
Vec3 VelocityStep::gain_of(const Task& task, const Contact& contact, const Vec3& mean_w) {
  const auto movable = [&](int body) {
    return task.world->bodies()[idx(body)].movable() ? 1.0 : 0.0;
  };
  return mean_w -
         0.5 * task.dt * (movable(contact.second) - movable(contact.first)) * task.world->gravity_w;
}

// The work of the impulses, p·(u- + u+)/2, with what they change of gravity's work.
VelocityStep::Work VelocityStep::work(const Task& task) const {
  Work all;
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = task.contacts[idx(candidate.contact)];
    const Vec3& place_w = contact.points[idx(candidate.point)].position_w;
    const Vec3 before_w = motion(task.start, contact, place_w);
    const Vec3 after_w = motion(ended_, contact, place_w);
    all.of_pushes += candidate.push_w.dot(gain_of(task, contact, 0.5 * (before_w + after_w)));
    all.rounding +=
        0.5 * tolerance::rounding *
        (std::abs(candidate.push_w.dot(before_w)) + std::abs(candidate.push_w.dot(after_w)));
  }
  return all;
}

// [J] What gravity does to the energy of the bodies that are pushed, without their pushes: they fall by g h² and gain
// the speed g h, which is m g² h²/2 less than free fall. The others lose as much, or fly their parabola.
double VelocityStep::work_of_gravity(const Task& task, int island) {
  pushed_.resize(free_.size());
  for (const int body : islands_.bodies(island)) pushed_[idx(body)] = 0;
  for (const Candidate& candidate : candidates()) {
    if (candidate.push_w.isZero(0.0) && candidate.bounce_w.isZero(0.0)) continue;
    const Contact& contact = task.contacts[idx(candidate.contact)];
    pushed_[idx(contact.first)] = pushed_[idx(contact.second)] = 1;
  }
  double mass = 0.0;
  for (const int body : islands_.bodies(island))
    if (pushed_[idx(body)] != 0) mass += task.world->bodies()[idx(body)].mass;
  return -0.5 * mass * task.world->gravity_w.squaredNorm() * task.dt * task.dt;
}

// On the way from the answer without restitution, the present one, to that with it the energy is a
// parabola E0 + b t + a t², with b = dp·(u+ + (u- - u_free)/2) and gravity's share at its start, and E1 at its end.
void VelocityStep::go_towards_bounce(const Task& task, int island, const Work& bounce) {
  const Work start = work(task);
  double slope = 0.0;
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = task.contacts[idx(candidate.contact)];
    const Vec3& place_w = contact.points[idx(candidate.point)].position_w;
    const Vec3 u = motion(ended_, contact, place_w) +
                   0.5 * (motion(task.start, contact, place_w) - motion(free_, contact, place_w));
    slope += (candidate.bounce_w - candidate.push_w).dot(gain_of(task, contact, u));
  }
  const double curvature = std::max(bounce.of_pushes - start.of_pushes - slope, 0.0);
  const double share = largest_share(std::min(start.of_pushes + work_of_gravity(task, island), 0.0),
                                     slope, curvature);
  for (Candidate& candidate : candidates())
    candidate.push_w += share * (candidate.bounce_w - candidate.push_w);
}

// --- sweeps --------------------------------------------------------------------------------------

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

// Pushes without restitution only take energy. Sweeps that have not settled may break this: then the part of them that
// does not is used. The energy is E(s) = s p·(u- + u_free)/2 + s² p·A p/2 for the share s of the pushes, with gravity's
// work on what they lift; what is at rest gains as much as falling would take, and is left alone up to twice of it.
void VelocityStep::take_no_energy(const Task& task, int island) {
  double slope = 0.0;
  double curvature = 0.0;
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = task.contacts[idx(candidate.contact)];
    const Vec3& place_w = contact.points[idx(candidate.point)].position_w;
    const Vec3 u = motion(free_, contact, place_w);
    const Vec3 mean_w = 0.5 * (motion(task.start, contact, place_w) + u);
    slope += candidate.push_w.dot(gain_of(task, contact, mean_w));
    curvature += 0.5 * candidate.push_w.dot(motion(ended_, contact, place_w) - u);
  }
  const double allowed = -2.0 * work_of_gravity(task, island);
  if (slope + curvature <= allowed) return;
  const double share = largest_share(-allowed, slope, curvature);
  for (Candidate& candidate : candidates()) candidate.push_w *= share;
  apply_pushes(task, island);
}

}  // namespace tumble
