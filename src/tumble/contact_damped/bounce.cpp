/// \file
/// \brief The default technique: restitution.
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/bounce_order.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/patch_pressure.hpp"
#include "tumble/contact_patches/patch_solver.hpp"
#include "tumble/contact_patches/point_friction.hpp"
#include "tumble/contact_patches/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace tumble {
namespace {

// [-] Sweeps over an island after restitution, at most. Reason: most bounces are over then; others are solved at once. (4.3)
constexpr int kBounceSweeps = 10;
// [-] The same over a small island. Reason: a row of twenty bodies parts by Newton's law at all points at once. (4.3)
constexpr int kSmallBounceSweeps = 100;
// [-] Friction and pressure in turn within a patch, in these sweeps. Reason: patches that bounce do not stick. (4.3)
constexpr int kBouncePatchIterations = 20;

// Points that are apart when their bodies have moved ask for nothing: a bounce may send one body towards the other.
void release_open_points(const Island& island, ContactPatch& patch) {
  const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  for (ContactPatchPoint& p : patch.used()) {
    const double gap = p.gap + island.dt * velocity_at(p.along, p.across, u).z();
    if (p.impulse == 0.0 && is_apart(gap, tolerance::contact_slop * patch.size))
      p.target = -std::numeric_limits<double>::infinity();
  }
}

// Sweeps over an island that bounces. Returns whether they have settled.
bool sweep_bounce(const Island& island, StepReport& report) {
  const int most_sweeps = is_small(island) ? kSmallBounceSweeps : kBounceSweeps;
  for (int k = 0; k < most_sweeps; ++k) {
    double most = 0.0;
    for (const int contact : island.patch_indices) {
      ContactPatch& patch = island.all_patches[idx(contact)];
      most = std::max(most, solve_patch(patch, island.now[idx(patch.first)],
                                        island.now[idx(patch.second)], kBouncePatchIterations));
    }
    ++report.iterations;
    report.impulses += static_cast<std::int64_t>(island.patch_indices.size());
    if (most < negligible_residual(island)) return true;
  }
  return false;
}

// Normal impulses of all points at once, friction held: a light body between heavy ones would need thousands of sweeps.
void solve_bounce(const Island& island, IslandSolver& solver, std::vector<MovingBody>& held,
                  StepReport& report) {
  copy_bodies(island, island.now, held);
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    Six normal{};
    for (const ContactPatchPoint& p : patch.used())
      add_push(p.along, p.across, {0.0, 0.0, -p.impulse}, normal);
    apply(normal, patch, held[idx(patch.first)], held[idx(patch.second)]);
  }
  IslandLimits limits;
  limits.residual = negligible_residual(island);
  limits.max_work = tolerance::max_factor_work;
  limits.max_newton_steps = tolerance::small_newton_steps;
  report.pivots += solver.solve_normal(island, limits, held).factorizations;
}

// Points that were hit separate with the speed that restitution gives them, all at once.
void ask_for_separation(const Island& island, double step) {
  const double g = island.world.gravity_w.norm();
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    release_open_points(island, patch);
    require_separation(slowest_bounce(g, patch.size, step), patch);
  }
}

}  // namespace

// Newton's restitution for impacts faster than the sticky speed (thesis 4.3), after the bodies have come
// together, island by island.
void ContactDamped::bounce(World& world, double dt, StepReport& report) {
  const std::vector<ContactPatch>& patches = memory_.manifolds.patches();
  const double g = world.gravity_w.norm();
  bool any_bounced = false;
  storage_.hit.assign(patches.size(), 0);
  storage_.bounced.assign(patches.size(), 0);
  for (int k = 0; k < memory_.order.islands().count(); ++k) {
    bool bounces = false;
    for (const int contact : memory_.order.islands().contacts(k)) {
      const ContactPatch& patch = patches[idx(contact)];
      if (!was_hit(patch, slowest_bounce(g, patch.size, storage_.step))) continue;
      storage_.hit[idx(contact)] = 1;
      ++report.events;
      bounces = bounces || patch.restitution > 0.0;
    }
    if (!bounces) continue;
    const Island island = view_of_island(world, k, dt);
    if (!any_bounced) {
      velocities_.before_bounce = velocities_.end;
      storage_.impulses_before_bounce.resize(patches.size());
    }
    any_bounced = true;
    for (const int contact : island.patch_indices) {
      storage_.bounced[idx(contact)] = 1;
      storage_.impulses_before_bounce[idx(contact)] = impulses_in(patches[idx(contact)]);
    }
    ask_for_separation(island, storage_.step);
    if (!sweep_bounce(island, report) &&
        !memory_.island_solver.costs_more_than(tolerance::quiet_factor_work, island))
      solve_bounce(island, memory_.island_solver, storage_.held, report);
    limit_bounce(island, velocities_.before_bounce, storage_.impulses_before_bounce, report);
  }
  if (any_bounced) store_bounced_velocities(world);
  if (observer() == nullptr) return;
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (storage_.hit[k] != 0) notify_observer(patches[k], dt);
}

// A bounce is over with its step, and its impulses would push bodies apart in the next one: no patch of an island that bounced
// begins that with more than it began this one with. What bodies weigh on each other grows back within a few steps.
void ContactDamped::forget_bounces() {
  const std::span<ContactPatch> patches = memory_.manifolds.patches();
  for (std::size_t k = 0; k < storage_.bounced.size(); ++k) {
    if (storage_.bounced[k] == 0) continue;
    const double normal = impulse_of(patches[k])[six::normal];
    if (normal > patches[k].carried_impulse)
      scale_impulses(patches[k].carried_impulse / normal, patches[k]);
  }
  storage_.bounced.clear();
}

// Bodies have turned since their impulses were found, and take their angular momentum with them: in its own frame a
// body has the velocity that the impulses give it, and so the energy.
void ContactDamped::store_bounced_velocities(World& world) {
  for (std::size_t i = 0; i < velocities_.end.size(); ++i) {
    const MovingBody& now = velocities_.end[i];
    const Vec3 turn_w = now.angular_velocity_w - velocities_.before_bounce[i].angular_velocity_w;
    const Vec3 push_w = now.velocity_w - velocities_.before_bounce[i].velocity_w;
    if (now.inverse_mass.x() == 0.0 || (turn_w.isZero(0.0) && push_w.isZero(0.0))) continue;
    storage_.in_flight[i] = 0;
    world.states()[i].linear_momentum_w += world.bodies()[i].mass * push_w;
    const Quat turned = world.states()[i].orientation_wb * storage_.start_wb[i].conjugate();
    world.states()[i].angular_momentum_w =
        turned * Vec3(now.inverse_inertia_w.inverse() * now.angular_velocity_w);
  }
}

// The bodies meet when the first of the points that were hit has closed its gap, at their centre of pressure: halfway, and beside
// that where the lighter one has come.
void ContactDamped::notify_observer(const ContactPatch& patch, double dt) const {
  double until = dt;
  for (const ContactPatchPoint& p : patch.used())
    if (p.impulse > 0.0 && p.approach < 0.0)
      until = std::min(until, std::max(0.0, p.gap) / -p.approach);
  const MovingBody& first = velocities_.start[idx(patch.first)];
  const MovingBody& second = velocities_.start[idx(patch.second)];
  Event event;
  event.time = contact_time_ + until;
  event.first = patch.first_id;
  event.second = patch.second_id;
  event.normal_w = patch.frame_w.col(2);
  const PatchPressure pressure = pressure_of(patch);
  const Vec3 middle_w =
      position_of(patch, first, {.along = pressure.along, .across = pressure.across});
  const Vec3 first_w = velocity_at(first, middle_w), second_w = velocity_at(second, middle_w);
  const double share = first.inverse_mass.x() / (first.inverse_mass.x() + second.inverse_mass.x());
  const Vec3 lighter_w = share * first_w + (1.0 - share) * second_w;
  const double halfway = event.normal_w.dot(0.5 * (first_w + second_w) - lighter_w);
  event.point_w = middle_w + until * (lighter_w + halfway * event.normal_w);
  const Six impulse = impulse_of(patch);
  event.impulse_w = patch.frame_w * Vec3(impulse[0], impulse[1], impulse[2]);
  observer()->on_event(event);
}

}  // namespace tumble
