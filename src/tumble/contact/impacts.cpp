/// \file
/// \brief Collisions of several bodies at one instant: all together, or one after the other.
#include "tumble/contact/impacts.hpp"

#include "tumble/base/error.hpp"
#include "tumble/contact/collision_law.hpp"
#include "tumble/contact/gather.hpp"

#include <algorithm>

namespace tumble {
namespace {

// A contact of one point: the law of collision, without a system to solve.
SimultaneousResult collide_alone(Contact& contact, std::span<MovingBody> bodies) {
  MovingBody& first = bodies[static_cast<std::size_t>(contact.first)];
  MovingBody& second = bodies[static_cast<std::size_t>(contact.second)];
  ContactPoint& point = contact.points[0];
  const PointImpulse impulse = collide_at_point(first, second, point.position_w, contact.normal_w,
                                                contact.friction, contact.restitution);
  SimultaneousResult result;
  if (impulse.mode == ImpactMode::none) return result;
  const double j_n = contact.normal_w.dot(impulse.impulse_w);
  point.normal_impulse += j_n;
  point.friction_impulse_w += impulse.impulse_w - j_n * contact.normal_w;
  result.status = SimultaneousStatus::solved;
  result.impulses = 1;
  result.restitution_energy = impulse.restitution_energy;
  result.friction_energy = impulse.friction_energy;
  if (contact.restitution > 0.0)
    result.restitution_share = impulse.restitution / contact.restitution;
  return result;
}

void add(const SimultaneousResult& one, ImpactResult& all) {
  if (one.status == SimultaneousStatus::untouched) return;
  if (one.status == SimultaneousStatus::no_solution) all.status = ImpactStatus::no_solution;
  if (one.impulses > 0) ++all.collisions;
  all.impulses += one.impulses;
  all.pivots += one.pivots;
  all.restitution_share = std::min(all.restitution_share, one.restitution_share);
  all.restitution_energy += one.restitution_energy;
  all.friction_energy += one.friction_energy;
}

}  // namespace

double fastest_approach(std::span<const Contact> contacts, std::span<const MovingBody> bodies) {
  double fastest = 0.0;
  for (const Contact& contact : contacts) {
    const MovingBody& first = bodies[static_cast<std::size_t>(contact.first)];
    const MovingBody& second = bodies[static_cast<std::size_t>(contact.second)];
    for (int i = 0; i < contact.count; ++i) {
      const Vec3& point_w = contact.points[static_cast<std::size_t>(i)].position_w;
      const double v_n = contact.normal_w.dot(relative_velocity(first, second, point_w));
      fastest = std::max(fastest, -v_n);
    }
  }
  return fastest;
}

void book(const ImpactResult& impact, StepReport& report) {
  report.impulses += impact.impulses;
  report.iterations += impact.passes;
  report.pivots += impact.pivots;
  report.energy.restitution += impact.restitution_energy;
  report.energy.friction += impact.friction_energy;
}

ImpactResult ImpactSolver::resolve(std::span<Contact> contacts, std::span<MovingBody> bodies,
                                   const ImpactOptions& options) {
  require::within(options.settled, 0.0, 1.0, "options.settled");
  require::that(options.most_passes >= 1, "options.most_passes: at least 1 is needed");
  const int count = static_cast<int>(bodies.size());
  for (Contact& contact : contacts) {
    require::that(contact.first >= 0 && contact.first < count && contact.second >= 0 &&
                      contact.second < count,
                  "contacts: the index of a body of `bodies` is needed");
    for (ContactPoint& point : contact.points) {
      point.normal_impulse = 0.0;
      point.friction_impulse_w.setZero();
    }
  }

  ImpactResult result;
  if (options.order == ImpactOrder::simultaneous) {
    result.passes = 1;
    const SimultaneousResult block = block_.solve(contacts, bodies);
    add(block, result);
    if (block.status == SimultaneousStatus::unsettled) result.status = ImpactStatus::cap_reached;
  } else {
    one_after_the_other(contacts, bodies, options, result);
  }
  result.worst_approach = fastest_approach(contacts, bodies);
  return result;
}

void ImpactSolver::one_after_the_other(std::span<Contact> contacts, std::span<MovingBody> bodies,
                                       const ImpactOptions& options, ImpactResult& result) {
  const double slow = options.settled * fastest_approach(contacts, bodies);
  bool quiet = false;
  while (!quiet && result.status != ImpactStatus::no_solution) {
    if (result.passes == options.most_passes) {
      result.status = ImpactStatus::cap_reached;
      return;
    }
    quiet = true;
    ++result.passes;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      // A collision of its own, with what the others have left: its approach speed is the present
      // one.
      const std::span<Contact> one = contacts.subspan(c, 1);
      if (fastest_approach(one, bodies) <= slow) continue;
      stamp_approach_speeds(bodies, one);
      const SimultaneousResult collision =
          one[0].count == 1 ? collide_alone(one[0], bodies) : block_.solve(one, bodies);
      add(collision, result);
      // One without an impulse (an approach of rounding size) would do so in every pass.
      if (collision.impulses > 0) quiet = false;
    }
  }
}

}  // namespace tumble
