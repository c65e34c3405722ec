/// \file
/// \brief Impacts and steps of the analytic technique that its events do not finish.
#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/time_stepping.hpp"
#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/base/index.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/step_report.hpp"

#include <algorithm>

namespace tumble {
namespace {

// Impulses and friction of an impact are found in turn, up to some hundred dense problems of all its points.
constexpr int kMostImpactPoints = 150;

// Of a rest of a step that repair would lift: a 64th of it turns a body by so little that its overlap is a 4000th.
constexpr double kMostPartsOfRest = 64.0;

// [J] With which gains of energy are compared.
double energy_scale(const World& world) { return energy_of(world).kinetic + lifting_energy(world); }

}  // namespace

// Whether an impact with friction has so many points that the rest of the step is better one step of velocities.
bool Analytic::is_too_large(std::span<const Contact> impact) const {
  if (options_.friction != AnalyticFriction::coulomb) return false;
  int points = 0;
  for (const Contact& contact : impact)
    if (contact.friction > 0.0) points += contact.count;
  return points > kMostImpactPoints;
}

// The impact of an island whose friction does not settle, anew as a step of velocities in which nothing accelerates.
// Returns whether that has a solution; if not, what there was stays.
bool Analytic::resolve_by_velocities(const World& world, const Progress& progress,
                                     StepReport& report) {
  std::vector<MovingBody> trial;
  load_moving_bodies(world, trial);  // those of this island have not been stored since the impact
  const std::vector<Acceleration> none(trial.size());
  VelocityStepOptions how{.directions = options_.directions};
  how.sticky.rule = StickyRule::off;  // restitution has been decided
  const VelocityStepResult found =
      unsettled_.solve(world, none, island_, progress.left(), how, trial);
  ++report.fallbacks;
  report.pivots += found.pivots;
  if (!found.solved) return false;
  for (const Contact& contact : island_)
    for (const int b : {contact.first, contact.second}) moving_[idx(b)] = trial[idx(b)];
  report.events += static_cast<std::int64_t>(island_.size());
  report.impulses += found.impulses;
  report.energy.restitution += found.restitution_energy;
  report.energy.friction += found.friction_energy;
  return true;
}

// Uses the forces of the flight's middle for all of it, unless friction would give bodies energy by that: such forces belong to a slip
// that has turned round by the middle, as that of a light body between heavy ones does in microseconds.
bool Analytic::take_midway(World& world, const Plan& plan, StepReport& report) {
  flight_.set_wrenches(forces_.wrenches());
  flight_.accelerate(forces_.accelerations());
  resting_.swap(midway_);
  if (options_.friction != AnalyticFriction::coulomb) return true;
  StepReport flight;
  flight_.put(world, plan.time, options_.rotation);
  recorded_for_ = plan.time;
  book_work(world, plan.time, flight);
  flight_.put(world, 0.0, options_.rotation);
  if (flight.energy.friction <= tolerance::driving_friction * energy_scale(world)) return true;
  resting_.swap(midway_);
  flight_.set_wrenches(first_wrenches_);
  flight_.accelerate(first_accelerations_);
  ++report.fallbacks;
  return false;
}

// The rest of a step with all contacts and impacts in it: at once, or in parts as long as bodies would turn so far into others
// that their repair lifts them by more than nothing.
void Analytic::finish_by_velocities(World& world, Progress& progress, StepReport& report) {
  TimeSteppingOptions how;
  how.velocities.directions = options_.directions;
  how.velocities.sticky = options_.sticky;
  how.rotation = options_.rotation;
  how.pose = options_.pose;
  TimeStepping rest(how);
  const double allowed = tolerance::lifting_repair * energy_scale(world);  // [J]
  const double least = progress.left() / kMostPartsOfRest;
  double part = progress.left();
  while (progress.left() > 0.0) {
    World copy = world;  // its clock goes on, which is ours to do
    const bool last = part >= progress.left();
    const StepReport done = rest.step(copy, last ? progress.left() : part);
    if (done.energy.repair > allowed && part > least) {
      part *= 0.5;
      continue;
    }
    add_report(done, report);
    std::copy(copy.states().begin(), copy.states().end(), world.states().begin());
    records_.insert(records_.end(), rest.contacts().begin(), rest.contacts().end());
    const bool ends = last || done.status >= StepStatus::unsolved;
    progress.passed = ends ? progress.dt : progress.passed + part;
  }
  ++report.fallbacks;
  resting_.clear();
}

}  // namespace tumble
