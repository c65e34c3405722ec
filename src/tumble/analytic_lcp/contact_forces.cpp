/// \file
/// \brief The forces between bodies that rest on each other, at one instant.
#include "tumble/analytic_lcp/contact_forces.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
std::vector<Word<std::string>> contact_solver_words() {
  std::vector<Word<std::string>> words;
  for (const LcpRecipe& recipe : lcp_solvers())
    if (recipe.name != "enumeration") words.push_back({recipe.name, std::string(recipe.name)});
  return words;
}

ContactForces::ContactForces(const ContactForceOptions& options)
    : options_(options), solver_(make_lcp_solver(options.solver)), held_(options.stable_boxes) {
  require::that(options.directions == 4 || options.directions == 8,
                "directions = " + std::to_string(options.directions) + ": give 4 or 8");
  require::that(
      !options.friction || options.stable_boxes == StableRule::off,
      "stable_boxes: with Coulomb's friction a box that moves can drag a stable one along; "
      "use friction=none or friction=damping, or stable_boxes=off");
}

ForceReport ContactForces::solve(const World& world, std::span<const MovingBody> bodies,
                                 std::span<Contact> contacts, const ForceAim& aim) {
  const Task task{&world, held_.find(world, bodies, contacts), aim};
  ForceReport report;
  free_accelerations(world, task.bodies, free_);
  wrenches_.assign(bodies.size(), Wrench{});
  held_.hold(world, aim.relaxation, free_, wrenches_);
  for (Contact& contact : contacts) {
    if (!held_.both(contact)) continue;
    for (ContactPoint& p : contact.points) {
      p.normal_impulse = 0.0;
      p.friction_impulse_w.setZero();
    }
  }
  total_.assign(free_.begin(), free_.end());
  for (int b = 0; b < world.count(); ++b) report.stable += held_.holds(world, b) ? 1 : 0;
  islands_.build(world.bodies(), contacts, held_.held());
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> which = islands_.contacts(i);
    if (which.empty()) continue;
    load(task, contacts, which);
    report.unknowns += problem_.lcp().size();
    // [S5.3:without_friction]
    // The symmetric problem first. Its answer is right with friction
    // too if no point that is pushed slides, or would begin to.
    if (!solve_normals(report)) break;
    apply_pushes(task, islands_.bodies(i));
    if (options_.friction && needs_friction(task)) {
      if (!solve_friction(task, report)) break;
      apply_pushes(task, islands_.bodies(i));
    }
    // [S5.3:without_friction]
    find_end_of_slip(task, report);
    store(task, contacts, which);
  }
  return report;
}

// An island on its own: its contacts, its rows, and what they ask for.
void ContactForces::load(const Task& task, std::span<const Contact> contacts,
                         std::span<const int> which) {
  island_.clear();
  for (const int c : which) island_.push_back(contacts[idx(c)]);
  problem_.assemble(*task.world, task.bodies, free_, island_,
                    std::numeric_limits<double>::infinity());
  points_.clear();
  terms_.clear();
  start_.clear();
  for (const ContactRow& row : problem_.rows()) {
    const Contact& contact = island_[idx(row.contact)];
    const ContactPoint& p = contact.points[idx(row.point)];
    const TouchScale scale = touch_scale(*task.world, contact.first, contact.second, task.aim.dt);
    if (p.normal_impulse > 0.0) start_.push_back(static_cast<int>(points_.size()));

    Point& point = points_.emplace_back();
    point.velocity_w = relative_velocity(task.bodies[idx(contact.first)],
                                         task.bodies[idx(contact.second)], p.position_w);
    // What stuck so far has got a speed by the error of a flight, and goes on sticking.
    const bool stuck = state_of(contact, row.point) == ContactState::stick;
    const double slow =
        stuck ? scale.resting_speed : tolerance::sliding_share * scale.resting_speed;
    point.slides =
        !(stuck && task.aim.midway) && across(point.velocity_w, contact.normal_w).norm() > slow;

    // [S3.3.1:rest]
    // What the last flight left: a speed along the normal that should
    // be 0, and a gap that should be closed. The acceleration asked
    // for makes good the one, and slowly the other, if the point is
    // pressed on; nothing pulls.
    const double T = task.aim.relaxation;
    const double gap = std::max(p.distance, 0.0);
    const double share = gap / (tolerance::contact_margin * scale.size);
    const double closing = std::min(tolerance::closing * scale.resting_speed * share, gap / T);
    terms_.push_back((p.approach_speed + closing) / T);
    // [S3.3.1:rest]
  }
  problem_.add_to_b(terms_);
}

bool ContactForces::solve_normals(ForceReport& report) {
  solver_->solve(problem_.lcp(), result_, start_);
  report.pivots += result_.pivots;
  report.multiplications += result_.multiplications;
  // Once more, without what was known: that problem can be solved again elsewhere.
  if (!result_.solved_within(tolerance::force_residual)) {
    solver_->solve(problem_.lcp(), result_);
    report.pivots += result_.pivots;
    report.multiplications += result_.multiplications;
  }
  if (!result_.solved_within(tolerance::force_residual)) {
    report.status = result_.status == LcpStatus::solved ? LcpStatus::singular : result_.status;
    unsolved_ = problem_.lcp();
    return false;
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
    points_[i].push_w = result_.f[i] * island_[idx(problem_.rows()[i].contact)].normal_w;
  return true;
}

// What a row's point does across its normal: how it accelerates, and how fast it moves if it should
// not, to be undone within the relaxation.
Vec3 ContactForces::drift_w(const Task& task, int row, std::span<const Acceleration> of) const {
  const ContactRow& place = problem_.rows()[idx(row)];
  const Contact& contact = island_[idx(place.contact)];
  const Vec3& p = contact.points[idx(place.point)].position_w;
  const auto acceleration_of = [&](int body) {
    return acceleration_at(task.bodies[idx(body)], of[idx(body)], p);
  };
  Vec3 drift = acceleration_of(contact.second) - acceleration_of(contact.first);
  const Point& point = points_[idx(row)];
  if (!point.slides) drift += point.velocity_w / task.aim.relaxation;
  return across(drift, contact.normal_w);
}

bool ContactForces::needs_friction(const Task& task) const {
  double resisted = 0.0;
  for (int i = 0; i < problem_.lcp().size(); ++i)
    resisted = std::max(resisted, std::abs(problem_.lcp().b[i]));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!(island_[idx(problem_.rows()[i].contact)].friction > 0.0)) continue;
    if (!(result_.f[i] > 0.0)) continue;
    if (points_[i].slides) return true;
    const Vec3 drift = drift_w(task, static_cast<int>(i), total_);
    if (drift.norm() > tolerance::creep * resisted) return true;
  }
  return false;
}

// [-] The direction in which a point slides, along which friction acts during the flight. Where gravity,
// say, adds more to its speed than it has, the direction of the end counts, without friction: with that of
// the start, a small speed across would be turned round, and larger, in each flight.
Vec3 ContactForces::slip_direction_w(const Task& task, int row) const {
  const Vec3& n = island_[idx(problem_.rows()[idx(row)].contact)].normal_w;
  const Vec3 slip_w = across(points_[idx(row)].velocity_w, n);
  const double ahead = (task.aim.midway ? 0.5 : 1.0) * task.aim.duration;
  const Vec3 gain_w = ahead * drift_w(task, row, total_);
  const bool speeds_up = gain_w.dot(slip_w) > 0.0 && gain_w.norm() > slip_w.norm();
  return (speeds_up ? Vec3(slip_w + gain_w) : slip_w).normalized();
}

// [S2.6.3:friction]
bool ContactForces::solve_friction(const Task& task, ForceReport& report) {
  friction_points_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    FrictionPoint& out = friction_points_.emplace_back();
    out.contact = problem_.rows()[i].contact;
    out.point = problem_.rows()[i].point;
    out.normal_constant = problem_.lcp().b[static_cast<int>(i)];
    out.tangential_constant_w = drift_w(task, static_cast<int>(i), free_);
    if (points_[i].slides) out.sliding_w = slip_direction_w(task, static_cast<int>(i));
  }
  if (FrictionPyramid::unknowns(island_, friction_points_, options_.directions) >
      FrictionLemkeSolver::kMostUnknowns) {
    report.too_large = true;
    return false;
  }
  pyramid_.assemble(task.bodies, island_, friction_points_, options_.directions);
  friction_solver_.solve(pyramid_.lcp(), result_);
  report.pivots += result_.pivots;
  report.multiplications += result_.multiplications;
  if (!result_.solved_within(tolerance::force_residual)) {
    ++report.without_solution;
    return take_velocity_step(task, report);
  }
  pyramid_.pushes(result_.f, pushes_);
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i].push_w = pushes_[i];
  return true;
}
// [S2.6.3:friction]

// Painlevé: no finite force will do, but an impulse does. There always is one, and it is spread over
// the time that the forces act.
bool ContactForces::take_velocity_step(const Task& task, ForceReport& report) {
  for (Contact& contact : island_) contact.restitution = 0.0;
  trial_.assign(task.bodies.begin(), task.bodies.end());
  const VelocityStepResult step = velocity_step_.solve(
      *task.world, free_, island_, task.aim.duration, {.directions = options_.directions}, trial_);
  report.pivots += step.pivots;
  if (!step.solved) {
    report.status = LcpStatus::infeasible;
    unsolved_ = *velocity_step_.problem();
    return false;
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ContactRow& row = problem_.rows()[i];
    const Contact& contact = island_[idx(row.contact)];
    const ContactPoint& p = contact.points[idx(row.point)];
    points_[i].push_w =
        (p.normal_impulse * contact.normal_w + p.friction_impulse_w) / task.aim.duration;
  }
  return true;
}

// Wrenches and accelerations of the island's bodies, from nothing.
void ContactForces::apply_pushes(const Task& task, std::span<const int> members) {
  for (const int b : members) wrenches_[idx(b)] = Wrench{};
  const auto add = [&](int body, const Vec3& point_w, const Vec3& push_w) {
    if (!task.world->bodies()[idx(body)].movable() || held_.holds(*task.world, body)) return;
    wrenches_[idx(body)].force_w += push_w;
    wrenches_[idx(body)].torque_w += (point_w - task.bodies[idx(body)].position_w).cross(push_w);
  };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ContactRow& row = problem_.rows()[i];
    const Contact& contact = island_[idx(row.contact)];
    const Vec3& p = contact.points[idx(row.point)].position_w;
    add(contact.first, p, -points_[i].push_w);
    add(contact.second, p, points_[i].push_w);
  }
  for (const int b : members) {
    const MovingBody& body = task.bodies[idx(b)];
    total_[idx(b)].linear_w =
        free_[idx(b)].linear_w + body.inverse_mass.cwiseProduct(wrenches_[idx(b)].force_w);
    total_[idx(b)].angular_w =
        free_[idx(b)].angular_w + body.inverse_inertia_w * wrenches_[idx(b)].torque_w;
  }
}

// When the first point that friction slows down comes to rest.
void ContactForces::find_end_of_slip(const Task& task, ForceReport& report) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& point = points_[i];
    const Vec3& n = island_[idx(problem_.rows()[i].contact)].normal_w;
    const Vec3 slip_w = across(point.velocity_w, n);
    const Vec3 friction_w = across(point.push_w, n);
    if (!point.slides || friction_w.isZero(0.0)) continue;
    const double braking = -slip_w.dot(drift_w(task, static_cast<int>(i), total_));
    if (braking > 0.0)
      report.slip_ends = std::min(report.slip_ends, slip_w.squaredNorm() / braking);
  }
}

void ContactForces::store(const Task& task, std::span<Contact> contacts,
                          std::span<const int> which) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ContactRow& row = problem_.rows()[i];
    Contact& contact = contacts[idx(which[idx(row.contact)])];
    const Vec3 impulse_w = task.aim.duration * points_[i].push_w;
    const Vec3 friction_w = across(impulse_w, contact.normal_w);
    contact.points[idx(row.point)].normal_impulse = impulse_w.dot(contact.normal_w);
    contact.points[idx(row.point)].friction_impulse_w = friction_w;
  }
}

}  // namespace tumble
