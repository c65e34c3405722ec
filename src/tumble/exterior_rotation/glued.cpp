/// \file
/// \brief The glued technique: bodies in contact at the start stick together permanently.
#include "tumble/exterior_rotation/glued.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/dynamics/step_mistakes.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"
#include "tumble/math/bracket.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

// The Runge-Kutta table of a scheme, or nullptr.
const ButcherTable* table_of(GluedScheme scheme) {
  switch (scheme) {
    case GluedScheme::rk4: return &classical_table();
    case GluedScheme::dormand_prince: return &dormand_prince_table();
    case GluedScheme::midpoint: return &midpoint_table();
    default: return nullptr;
  }
}

SimpleScheme simple_of(GluedScheme scheme) {
  switch (scheme) {
    case GluedScheme::semi_implicit: return SimpleScheme::semi_implicit;
    case GluedScheme::impulse: return SimpleScheme::impulse;
    case GluedScheme::leapfrog: return SimpleScheme::leapfrog;
    default: return SimpleScheme::forward_euler;
  }
}

void require_finite(double error, double dt) {
  if (!std::isfinite(error))
    refuse_step("dt = " + shortest_text(dt) + ": a body makes a full turn or more in it, " +
                "or its state becomes infinite: expected a shorter dt");
}

constexpr std::size_t kMostChanges = 20;  // of each joint in a step, on average

double kinetic_energy_of(const World& world) {
  double sum = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    sum += kinetic_energy(world.bodies()[k], world.states()[k]);
  return sum;
}

}  // namespace

Glued::Glued(const GluedOptions& options) : options_(options) {
  require::within(options.accuracy, tolerance::least_rotation_accuracy, 1.0, "accuracy");
  require::that(options.pose == PoseUpdate::separate || table_of(options.scheme) == nullptr,
                "pose = exponential: scheme = " + std::string(name_of(options.scheme)) +
                    " moves bodies by its stages; expected forward_euler, semi_implicit, impulse "
                    "or leapfrog");
  if (options.contacts != GluedContacts::collide) return;
  require::that(options.scheme == GluedScheme::rk4 || options.scheme == GluedScheme::midpoint,
                "contacts = collide: expected scheme = rk4 or midpoint, not " +
                    std::string(name_of(options.scheme)));
  require::that(
      options.joints == GluedJoints::bilateral,
      "contacts = collide: expected joints = bilateral, since colliding bodies separate anyway");
}

std::vector<std::string> Glued::ignores(const World&) const {
  if (options_.contacts == GluedContacts::collide) return {};
  return {"collisions", "contacts other than those at the start", "limits of friction"};
}

StepReport Glued::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  const int solves_before = forces_.solves();
  const bool unilateral = options_.joints == GluedJoints::unilateral;
  std::vector<Joint> fresh;
  if (join(world, fresh)) {
    end_relative_motion(fresh, world, report);
    if (unilateral) change_joints(0.0, world, report);
  }
  const auto most_events = static_cast<std::int64_t>(kMostChanges * joints_.size());
  // [S6.2:glued]
  double passed = 0.0;
  while (passed < dt) {
    // One step, or the part of it that the accuracy permits.
    const double left = dt - passed;
    start_.assign(world.states().begin(), world.states().end());
    double taken = options_.contacts == GluedContacts::collide ? meet(left, world, report)
                   : options_.scheme == GluedScheme::dormand_prince
                       ? advance_adaptively(left, world)
                       : advance(left, world);
    // If a joint has changed on the way: only up to that event.
    JointChange change;
    if (unilateral && report.events >= most_events) report.status = StepStatus::event_cap;
    if (unilateral && report.events < most_events && margin(world, change) < 0.0) {
      if (options_.events == GluedEvents::located) taken = find_event(taken, dt, world);
      change_joints(passed + taken, world, report);
    }
    passed = taken < left ? passed + taken : dt;
  }
  // [S6.2:glued]
  close(world);
  if (options_.contacts == GluedContacts::stick) {
    report.iterations = forces_.solves() - solves_before;
    report.deepest_overlap = gap_of(joints_, world.states()).overlap;
  }
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) ++report.integrations;
  world.finish_step(dt);
  record(world);
  report.contacts = static_cast<std::int64_t>(records_.size());
  return report;
}

// One step of the scheme; returns its length, dt.
double Glued::advance(double dt, World& world) {
  if (const ButcherTable* table = table_of(options_.scheme)) {
    require_finite(runge_kutta_.step(*table, dt, joints_, forces_, world), dt);
  } else {
    simple_.step(simple_of(options_.scheme), options_.pose, dt, joints_, forces_, world);
  }
  return dt;
}

// The same for bodies that meet others.
double Glued::meet(double dt, World& world, StepReport& report) {
  require_finite(meeting_.step(*table_of(options_.scheme), dt, joints_, forces_, world, report),
                 dt);
  for (const Contact& contact : meeting_.impacts()) {
    if (report_collision(contact, {.time = world.time()}, observer())) ++report.events;
  }
  return dt;
}

// A step that meets the accuracy, repeated with shorter lengths until it does. The error is proportional to
// the fifth power of the step; 0.9 is a safety factor, and the length changes at most by a factor of five.
double Glued::advance_adaptively(double most, World& world) {
  double dt = try_dt_ > 0.0 ? std::min(try_dt_, most) : most;
  for (;;) {
    const double error = runge_kutta_.step(dormand_prince_table(), dt, joints_, forces_, world);
    const double share = error > 0.0 ? elementary::pow(options_.accuracy / error, 1.0 / 5) : 5.0;
    const double next = dt * std::clamp(0.9 * share, 0.2, 5.0);
    if (error <= options_.accuracy) {
      // A step that was cut short does not determine the length of the next one.
      if (dt < most || next < dt || try_dt_ == 0.0) try_dt_ = next;
      return dt;
    }
    std::copy(start_.begin(), start_.end(), world.states().begin());
    if (dt <= tolerance::joint_moment * most)
      refuse_step("accuracy = " + shortest_text(options_.accuracy) + ": not met by steps of " +
                  shortest_text(dt) + " s: expected slower bodies or a larger number");
    dt = next;
  }
}

// joint_margin() of the present states.
double Glued::margin(const World& world, JointChange& change) {
  load_moving_bodies(world, moving_);
  forces_.hold(world, moving_, joints_, wrenches_);
  return joint_margin(joints_, world, moving_, forces_, change);
}

// Locates the event within the step just made, and leaves the bodies there.
double Glued::find_event(double taken, double dt, World& world) {
  JointChange change;
  const auto margin_after = [&](double time) {
    std::copy(start_.begin(), start_.end(), world.states().begin());
    advance(time, world);
    return margin(world, change);
  };
  const double event =
      bisect(margin_after, Bracket{0.0, taken}, tolerance::joint_moment * dt, 100).bracket.high;
  margin_after(event);
  return event;
}

// Changes joints until all of them are consistent, each at most once at an instant.
void Glued::change_joints(double time, World& world, StepReport& report) {
  changed_.assign(joints_.size(), 0);
  for (;;) {
    JointChange change;
    if (!(margin(world, change) < 0.0) || changed_[idx(change.joint)] != 0) return;
    Joint& joint = joints_[idx(change.joint)];
    changed_[idx(change.joint)] = 1;
    const JointPoint where = held_point(joint, world.states());
    joint.hold = change.hold;
    joint.side = change.side;
    ++report.events;
    if (observer() != nullptr) {
      Event event;
      event.time = world.time() + time;
      event.first = world.ids()[idx(joint.first)];
      event.second = world.ids()[idx(joint.second)];
      event.point_w = 0.5 * (where.first_w + where.second_w);
      event.normal_w = world.states()[idx(joint.first)].orientation_wb * joint.normal_first_b;
      observer()->on_event(event);
    }
    if (joint.hold != JointHold::area) continue;
    end_relative_motion({&joint, 1}, world, report);  // it closes
  }
}

// Removes the relative velocity that joints forbid, as in an impact without restitution. Does nothing
// where the new joints forbid nothing but rounding.
void Glued::end_relative_motion(std::span<const Joint> fresh, World& world, StepReport& report) {
  const auto loss = [&](std::span<const Joint> joints, World& after) {
    const double before = kinetic_energy_of(after);
    load_moving_bodies(after, moving_);
    record_forces_.project(moving_, joints, after.states());
    store_moving_bodies(moving_, after);
    return before - kinetic_energy_of(after);
  };
  World trial = world;
  if (loss(fresh, trial) > tolerance::joining_energy * kinetic_energy_of(world))
    report.energy.restitution -= loss(joints_, world);
}

}  // namespace tumble
