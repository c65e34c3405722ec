/// \file
/// \brief One step from velocities to velocities with contact and friction.
#include "tumble/analytic_lcp/velocity_step.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

VelocityStepResult VelocityStep::solve(const World& world, std::span<const Acceleration> free,
                                       std::span<Contact> contacts, double dt,
                                       const VelocityStepOptions& options,
                                       std::span<MovingBody> bodies) {
  require::positive(dt, "dt");
  require::that(options.directions == 4 || options.directions == 8, "directions: expected 4 or 8");
  require::that(bodies.size() == world.bodies().size() && free.size() == bodies.size(),
                "bodies, free: one entry for each body of the world is needed");
  failed_ = false;
  islands_.build(world.bodies(), contacts);
  used_pyramids_ = 0;
  candidates_.clear();

  // What bodies do by themselves.
  free_.assign(bodies.begin(), bodies.end());
  for (std::size_t k = 0; k < free_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    free_[k].velocity_w += dt * free[k].linear_w;
    free_[k].angular_velocity_w += dt * free[k].angular_w;
    free_[k].changed = true;
  }
  ended_ = free_;

  VelocityStepResult result;
  const Task task{&world, bodies, contacts, dt, options};
  for (int island = 0; island < islands_.count(); ++island) {
    if (islands_.contacts(island).empty()) continue;
    if (solve_island(task, island, result)) continue;
    failed_ = true;
    result.solved = false;
    return result;
  }
  store(contacts, bodies, result);
  return result;
}

// [S2.6.3]
// Impacts and resting contact alike: impulses that keep the points apart at the end of the step.
// Restitution is added to the method; where it asks too much, as much of it as the energy allows.
bool VelocityStep::solve_island(const Task& task, int island, VelocityStepResult& result) {
  first_ = candidates_.size();
  const bool bounces = list_candidates(task, islands_.contacts(island));
  bool bounced = false;
  Work bounce;
  if (bounces) {
    bounced = find_pushes(task, island, true, result);
    bounce = work(task);
    if (bounced && bounce.of_pushes + work_of_gravity(task, island) <= bounce.rounding) return true;
    ++result.fallbacks;
    for (Candidate& candidate : candidates()) candidate.bounce_w = candidate.push_w;
  }
  if (!find_pushes(task, island, false, result)) return false;
  if (bounced) {
    go_towards_bounce(task, island, bounce);
    apply_pushes(task, island);
  }
  return true;
}
// [S2.6.3]

// [m] the smallest gap that a contact would have at the end if nothing pushed.
double VelocityStep::least_gap(const Task& task, const Contact& contact) const {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < contact.count; ++k) {
    const ContactPoint& point = contact.points[idx(k)];
    const double u_n = contact.normal_w.dot(motion(free_, contact, point.position_w));
    least = std::min(least, std::max(point.distance, 0.0) + task.dt * u_n);
  }
  return least;
}

// All points of an island, and what each asks for. Returns whether any of them bounces.
bool VelocityStep::list_candidates(const Task& task, std::span<const int> contacts) {
  bool bounces = false;
  speed_ = 0.0;
  for (const int c : contacts) {
    const Contact& contact = task.contacts[idx(c)];
    const double near =
        tolerance::repair_slop * pair_size(*task.world, contact.first, contact.second);
    // Corners of a face arrive together, whatever rounding leaves: at two of four it would turn.
    const double deepest = least_gap(task, contact);
    const double arrival = deepest < 0.0 ? std::max(0.0, deepest + near) : 0.0;
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& point = contact.points[idx(k)];
      const bool touches = point.distance <= near;
      if (!touches && task.options.form == SteppingForm::anitescu_potra) continue;
      const Vec3 u_free = motion(free_, contact, point.position_w);
      const double gap = std::max(point.distance, 0.0);
      const bool arrives = gap + task.dt * contact.normal_w.dot(u_free) < arrival;
      Candidate candidate;
      candidate.contact = c;
      candidate.point = k;
      candidate.taken_up = touches || arrives;
      candidate.floor = task.options.form == SteppingForm::stewart_trinkle ? -gap / task.dt : 0.0;
      candidate.bounce_floor = candidate.floor;
      if (candidate.taken_up && point.approach_speed < 0.0) {
        const StickyScale scale{task.world->gravity_w.norm(),
                                pair_size(*task.world, contact.first, contact.second), task.dt};
        const double e = sticky_restitution(contact.restitution, point.approach_speed, scale,
                                            task.options.sticky);
        // What is lifted in the rest of the step needs its energy: w²/2 + w c = (e u)²/2, c the speed that
        // gravity takes in a step.
        const double bounce = -e * point.approach_speed;
        const double fall = std::max(point.approach_speed - contact.normal_w.dot(u_free), 0.0);
        if (e > 0.0) candidate.bounce_floor = std::sqrt(bounce * bounce + fall * fall) - fall;
      }
      bounces = bounces || candidate.bounce_floor > candidate.floor;
      speed_ = std::max({speed_, u_free.norm(), std::abs(point.approach_speed)});
      candidates_.push_back(candidate);
    }
  }
  return bounces;
}

// Solves for what is taken up, until nothing that was left out matters. Each round takes up at least
// one point, or friction at one.
bool VelocityStep::find_pushes(const Task& task, int island, bool bounce,
                               VelocityStepResult& result) {
  while (true) {
    list_points(task.contacts, bounce);
    const bool large = is_large(task);
    if (large || !solve_points(task, result))
      return (large || !bounce) && sweep(task, island, bounce, result);
    apply_pushes(task, island);
    const bool missed = take_up_missed(task.contacts, bounce);
    const bool slides = take_up_friction(task.contacts);
    if (!missed && !slides) return true;
  }
}

void VelocityStep::list_points(std::span<const Contact> contacts, bool bounce) {
  points_.clear();
  for (const Candidate& candidate : candidates()) {
    if (!candidate.taken_up) continue;
    const Contact& contact = contacts[idx(candidate.contact)];
    const Vec3 u = motion(free_, contact, contact.points[idx(candidate.point)].position_w);
    const double u_n = contact.normal_w.dot(u);
    FrictionPoint& point = points_.emplace_back();
    point.contact = candidate.contact;
    point.point = candidate.point;
    point.normal_constant = u_n - (bounce ? candidate.bounce_floor : candidate.floor);
    point.tangential_constant_w = u - u_n * contact.normal_w;
    point.rough = candidate.rubs;
  }
}

bool VelocityStep::solve_points(const Task& task, VelocityStepResult& result) {
  // Each problem of a step has a place of its own: where the next step has one of the same size it
  // asks for no memory.
  if (used_pyramids_ == pyramids_.size()) pyramids_.emplace_back();
  FrictionPyramid& pyramid = pyramids_[used_pyramids_++];
  pyramid.assemble(free_, task.contacts, points_, task.options.directions);
  const LcpProblem& problem = pyramid.lcp();
  double error = 0.0;
  const auto solves = [&](LcpSolver& solver) {
    solver.solve(problem, answer_);
    result.pivots += answer_.pivots;
    error = error_of(problem);
    return error <= tolerance::step_residual;
  };
  const bool smooth = !pyramid.has_friction();
  const bool hasty = smooth && problem.size() > FrictionLemkeSolver::kMostToTryAll;
  const bool solved =
      hasty ? solves(hasty_solver_) : (smooth && solves(smooth_solver_)) || solves(rough_solver_);
  // An answer that does not quite hold is where sweeps start.
  if (!solved && !(answer_.residual <= tolerance::sweep_start)) return false;
  pyramid.pushes(answer_.f, pushes_);
  take_pushes();
  if (solved) result.residual = std::max(result.residual, error);
  return solved;
}

// The error of the answer as a share of the speeds of the island, and not of the residual's own scale,
// which may be a rounding itself where everything rests. Infinite if there is no answer.
double VelocityStep::error_of(const LcpProblem& problem) const {
  if (answer_.status != LcpStatus::solved) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (int k = 0; k < problem.size(); ++k) largest = std::max(largest, std::abs(problem.b[k]));
  const double error = answer_.residual * (largest > 0.0 ? largest : 1.0);
  return error != 0.0 ? error / std::max(speed_, largest) : 0.0;
}

// The velocities of an island at the end, from those of free bodies.
void VelocityStep::apply_pushes(const Task& task, int island) {
  for (const int body : islands_.bodies(island)) ended_[idx(body)] = free_[idx(body)];
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = task.contacts[idx(candidate.contact)];
    apply_impulse(ended_[idx(contact.first)], ended_[idx(contact.second)],
                  contact.points[idx(candidate.point)].position_w, candidate.push_w);
  }
}

// If a rough point without friction pushes and slides, all such points that push get friction.
bool VelocityStep::take_up_friction(std::span<const Contact> contacts) {
  bool slides = false;
  for (const Candidate& candidate : candidates()) {
    const Contact& contact = contacts[idx(candidate.contact)];
    if (candidate.rubs || !(contact.friction > 0.0) || candidate.push_w.isZero(0.0)) continue;
    const Vec3 u = motion(ended_, contact, contact.points[idx(candidate.point)].position_w);
    const Vec3 slip_w = across(u, contact.normal_w);
    slides = slides || slip_w.norm() > tolerance::step_sliding * speed_;
  }
  if (!slides) return false;
  for (Candidate& candidate : candidates())
    if (!candidate.push_w.isZero(0.0)) candidate.rubs = true;
  return true;
}

// Points that were left out, and are met after all.
bool VelocityStep::take_up_missed(std::span<const Contact> contacts, bool bounce) {
  bool any = false;
  for (Candidate& candidate : candidates()) {
    if (candidate.taken_up) continue;
    const Contact& contact = contacts[idx(candidate.contact)];
    const Vec3 u = motion(ended_, contact, contact.points[idx(candidate.point)].position_w);
    const double floor = bounce ? candidate.bounce_floor : candidate.floor;
    if (contact.normal_w.dot(u) >= floor - tolerance::still * speed_) continue;
    candidate.taken_up = true;
    any = true;
  }
  return any;
}

// Hands out velocities and impulses. The work is booked between the start and the end of the step,
// so that a contact at rest does none against gravity.
void VelocityStep::store(std::span<Contact> contacts, std::span<MovingBody> bodies,
                         VelocityStepResult& result) const {
  for (Contact& contact : contacts)
    for (ContactPoint& point : contact.points) {
      point.normal_impulse = 0.0;
      point.friction_impulse_w.setZero();
    }
  for (const Candidate& candidate : candidates_) {
    if (candidate.taken_up) ++result.points;
    if (candidate.push_w.isZero(0.0)) continue;
    ++result.impulses;
    Contact& contact = contacts[idx(candidate.contact)];
    ContactPoint& point = contact.points[idx(candidate.point)];
    point.normal_impulse = contact.normal_w.dot(candidate.push_w);
    point.friction_impulse_w = candidate.push_w - point.normal_impulse * contact.normal_w;
    const Vec3 u = 0.5 * (motion(bodies, contact, point.position_w) +
                          motion(ended_, contact, point.position_w));
    result.restitution_energy += point.normal_impulse * contact.normal_w.dot(u);
    result.friction_energy += point.friction_impulse_w.dot(u);
  }
  std::copy(ended_.begin(), ended_.end(), bodies.begin());
}

}  // namespace tumble
