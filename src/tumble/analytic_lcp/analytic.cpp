/// \file
/// \brief The loop that joins collisions and contact forces.
#include "tumble/analytic_lcp/analytic.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/analytic_lcp/unsolved.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/flush_edges.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/dynamics/step_mistakes.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace tumble {
namespace {

// In one step: forces and impacts without an answer cost more than all others, and mostly come again.
constexpr int kMostFallbacks = 4;

// Multiplications of the solvers of forces in one step: a third of a second.
constexpr std::int64_t kMostWork = 300'000'000;

std::int64_t movable_bodies(const World& world) {
  return std::count_if(world.bodies().begin(), world.bodies().end(),
                       [](const BodyProperties& body) { return body.movable(); });
}

ContactForceOptions force_options(const AnalyticOptions& options) {
  return {.solver = options.solver,
          .friction = options.friction == AnalyticFriction::coulomb,
          .directions = options.directions,
          .stable_boxes = options.stable_boxes};
}

}  // namespace

Analytic::Analytic(const AnalyticOptions& options)
    : options_(options), forces_(force_options(options)) {
  require::that(options.solver != "enumeration",
                "solver = enumeration: it is for eight contacts at most, choose another one");
  require::positive(options.resolution, "resolution");
  require::that(options.event_cap >= 1,
                "event_cap = " + std::to_string(options.event_cap) + ": expected 1 or more");
  require::not_negative(options.sticky.threshold, "sticky.threshold");
  require::within(options.damping.velocity, 0.0, 1.0, "damping.velocity");
  require::within(options.damping.spin, 0.0, 1.0, "damping.spin");
}

Analytic::Analytic(const Analytic& other)
    : Cloned(other),
      options_(other.options_),
      forces_(force_options(other.options_)),
      resting_(other.resting_),
      records_(other.records_) {}

std::vector<Diagnostic> Analytic::diagnostics() const { return diagnostics_of(unsolved_problem()); }

std::vector<std::string> Analytic::ignores(const World& world) const {
  const bool rough = std::any_of(world.bodies().begin(), world.bodies().end(),
                                 [](const BodyProperties& b) { return b.friction > 0.0; });
  if (!rough || options_.friction == AnalyticFriction::coulomb) return {};
  if (options_.friction == AnalyticFriction::none) return {"friction"};
  return {"friction (bodies in contact are damped instead)"};
}

StepReport Analytic::step(World& world, double dt) {
  require_resolved(dt, options_.resolution);
  records_.clear();
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport Analytic::step_part(World& world, double dt) {
  StepReport report;
  rewound_ = 0;
  unsolved_ = false;
  too_large_ = false;
  work_ = 0;
  Progress progress{dt, 0.0};
  for (int flight = 0; progress.left() > 0.0; ++flight) {
    const bool capped = flight == options_.event_cap;
    if ((capped || report.fallbacks >= kMostFallbacks || work_ > kMostWork) &&
        options_.friction == AnalyticFriction::coulomb) {
      finish_by_velocities(world, progress, report);
      break;
    }
    // [S3.3.1:join]
    // Collisions of this instant first, so that afterwards no point
    // that touches approaches. Then the forces that keep it so.
    find_candidates(world, progress.left(), false);
    find_near(world, report);
    if (!capped && collide(world, progress, report))
      find_candidates(world, progress.left(),
                      false);  // a body that moves otherwise may meet others
    Plan plan;
    if (!too_large_ && !find_forces(world, progress, plan, report)) {
      unsolved_ = true;
      report.status = StepStatus::unsolved;
      break;
    }
    if (too_large_) {
      finish_by_velocities(world, progress, report);
      break;
    }
    // Then a flight: to the next collision, to the end of a slide,
    // or to the end of the step.
    fly(world, plan, capped, progress, report);
    // [S3.3.1:join]
    if (capped) report.status = StepStatus::event_cap;
  }
  finish(world, progress, report);
  return report;
}

// Pairs whose bodies may meet in the time that is left: those whose ways, as wide as half a
// diagonal, overlap. Contact forces mostly keep bodies nearer to where they are than gravity would. What is
// carried goes beside it.
void Analytic::find_candidates(const World& world, double left, bool carried) {
  const auto reach = [&](std::size_t k) {
    const double beside = carried ? flight_.offset_w(static_cast<int>(k), left).norm() : 0.0;
    return (0.5 + tolerance::contact_margin) * world.bodies()[k].size.norm() + beside;
  };
  find_flight_pairs(world, left, reach, broad_phase_, bounds_, candidates_);
}

void Analytic::find_near(const World& world, StepReport& report) {
  load_moving_bodies(world, moving_);
  const GatherReport gathered = gather_near(world, moving_, candidates_, resting_, near_);
  report.pair_tests += gathered.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, gathered.deepest_overlap);
  drop_flush_edges(world, near_);
}

// What only meets edges without height in the flight that begins has no impact.
void Analytic::leave_out_flush_pairs(const World& world) {
  std::size_t next = 0;
  std::erase_if(candidates_, [&](const IndexPair& pair) {
    while (next < near_.size() && IndexPair{near_[next].first, near_[next].second} < pair) ++next;
    const bool near =
        next < near_.size() && IndexPair{near_[next].first, near_[next].second} == pair;
    return !near && meets_flush_edge(world, pair, near_);
  });
}

// The forces of the flight that begins, and how long it may be.
bool Analytic::find_forces(World& world, const Progress& progress, Plan& plan, StepReport& report) {
  resting_.assign(near_.begin(), near_.end());
  keep_points(resting_, [&](const Contact& contact, const ContactPoint& point) {
    const PointMotion motion =
        motion_of(point, touch_scale(world, contact.first, contact.second, progress.dt));
    return motion == PointMotion::rests || motion == PointMotion::collides;
  });
  const ForceAim aim{.dt = progress.dt, .relaxation = progress.dt, .duration = progress.left()};
  const ForceReport found = forces_.solve(world, moving_, resting_, aim);
  report.pivots += found.pivots;
  work_ += found.multiplications;
  too_large_ = found.too_large;
  if (too_large_) return true;
  if (found.status != LcpStatus::solved) return false;
  report.fallbacks += found.without_solution;
  flight_.begin(world);
  flight_.set_wrenches(forces_.wrenches());
  if (options_.pose == PoseUpdate::exponential) carry(world);
  plan.time = std::min(progress.left(), found.slip_ends);
  if (resting_.empty() || found.without_solution > 0 || hardly_moves(world, plan.time)) return true;
  return improve_forces(world, progress, plan, report);
}

// Which bodies carry each other in this flight.
void Analytic::carry(const World& world) {
  pushed_.clear();
  for (const Contact& contact : resting_) {
    std::optional<PushedPair> pair = pushed_pair(contact);
    if (!pair) continue;
    pair->state = PushedState::held;
    for (int k = 0; k < contact.count; ++k)
      if (state_of(contact, k) == ContactState::slip) pair->state = PushedState::slips;
    pushed_.push_back(*pair);
  }
  flight_.carry(world, moving_, pushed_);
  flight_.accelerate(forces_.accelerations());
}

// [S3.3.1:midpoint]
// Where do these forces lead to in half of the time? What holds the
// bodies there is used for all of the flight.
bool Analytic::improve_forces(World& world, const Progress& progress, Plan& plan,
                              StepReport& report) {
  plan.forces_at = 0.5 * plan.time;
  pairs_after(world, moving_, resting_, candidates_, plan.forces_at, resting_pairs_);
  flight_.put(world, plan.forces_at, options_.rotation);
  load_moving_bodies(world, moving_);
  report.pair_tests += gather_near(world, moving_, resting_pairs_, resting_, midway_).pair_tests;
  if (resting_pairs_.size() > resting_.size()) drop_flush_edges(world, midway_);
  keep_points(midway_, [&](const Contact& contact, const ContactPoint& point) {
    if (point.normal_impulse > 0.0) return true;  // it was pushed at the start
    const TouchScale scale = touch_scale(world, contact.first, contact.second, progress.dt);
    return motion_of(point, scale) == PointMotion::rests;
  });
  const ForceAim aim{.dt = progress.dt,
                     .relaxation = progress.dt - plan.forces_at,
                     .duration = plan.time,
                     .midway = true};
  first_wrenches_.assign(forces_.wrenches().begin(), forces_.wrenches().end());
  first_accelerations_.assign(forces_.accelerations().begin(), forces_.accelerations().end());
  ForceReport there;
  try {
    there = forces_.solve(world, moving_, midway_, aim);
  } catch (...) {
    flight_.put(world, 0.0, options_.rotation);
    throw;
  }
  flight_.put(world, 0.0, options_.rotation);
  // [S3.3.1:midpoint]
  report.pivots += there.pivots;
  work_ += there.multiplications;
  if (there.status != LcpStatus::solved) return false;
  report.fallbacks += there.without_solution;
  if (there.without_solution == 0 && !there.too_large && take_midway(world, plan, report))
    return true;
  plan.forces_at = 0.0;  // those of the start are used, of order 1
  load_moving_bodies(world, moving_);
  return true;
}

// Whether no point of a body in contact moves far enough for forces to change.
bool Analytic::hardly_moves(const World& world, double time) const {
  const auto still = [&](int b) {
    const BodyProperties& body = world.bodies()[idx(b)];
    if (!body.movable()) return true;
    const MovingBody& m = moving_[idx(b)];
    const Acceleration& a = forces_.accelerations()[idx(b)];
    const double reach = 0.5 * body.size.norm();
    const double speed = m.velocity_w.norm() + reach * m.angular_velocity_w.norm();
    const double change = a.linear_w.norm() + reach * a.angular_w.norm();
    return time * (speed + 0.5 * time * change) <= tolerance::motionless * body.size.minCoeff();
  };
  return std::all_of(resting_.begin(), resting_.end(), [&](const Contact& contact) {
    return still(contact.first) && still(contact.second);
  });
}

void Analytic::fly(World& world, const Plan& plan, bool to_the_end, Progress& progress,
                   StepReport& report) {
  double time = to_the_end ? progress.left() : plan.time;
  if (!to_the_end) {
    if (options_.pose == PoseUpdate::exponential) find_candidates(world, time, true);
    leave_out_flush_pairs(world);
    const ImpactSearchTask task{.candidates = candidates_,
                                .near = near_,
                                .end = time,
                                .resolution = options_.resolution,
                                .dt = progress.dt,
                                .rule = options_.rotation};
    const FirstImpact impact = search_.find(flight_, task, world);
    report.searches += impact.evaluations;
    report.pair_tests += impact.pair_tests;
    if (impact.found) {
      rewound_ = static_cast<int>(movable_bodies(world));
      report.rewinds += rewound_;
      time = impact.time;
    }
  }
  flight_.put(world, time, options_.rotation);
  report.integrations += movable_bodies(world);
  recorded_at_ = world.time() + progress.passed + plan.forces_at;
  recorded_for_ = plan.forces_at > 0.0 ? plan.time : progress.left();
  progress.passed = time < progress.left() ? progress.passed + time : progress.dt;

  book_work(world, time, report);
}

void Analytic::finish(World& world, const Progress& progress, StepReport& report) {
  if (report.status == StepStatus::unsolved) return world.finish_step(progress.passed);
  record_forces(recorded_at_, recorded_for_, report);
  if (options_.friction == AnalyticFriction::damping)
    report.energy.damping +=
        damping_.run(resting_, forces_.held(), options_.damping, progress.dt, world);
  repair_bounds(world, 0.0, bounds_);
  broad_phase_.find_pairs(bounds_, candidates_);
  hold_.run(world, candidates_, report);
}

}  // namespace tumble
