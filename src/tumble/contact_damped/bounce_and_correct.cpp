/// \file
/// \brief The default technique: restitution, overlap correction and the energy account.
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/bounce_order.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/patch_solver.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// Points that are apart when their bodies have moved ask for nothing: a bounce may send one body towards the other.
void release_open_points(const Island& island, ContactPatch& patch) {
  const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  for (ContactPatchPoint& p : patch.used()) {
    const double gap = p.gap + island.dt * velocity_at(p.along, p.across, u).z();
    if (p.impulse == 0.0 && is_apart(gap, tolerance::contact_slop * patch.size))
      p.target = -std::numeric_limits<double>::infinity();
  }
}

// Points that were hit separate with the speed that restitution gives them, all at once.
void bounce_island(const Island& island, double step, StepReport& report) {
  const double g = island.world.gravity_w.norm();
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    release_open_points(island, patch);
    require_separation(slowest_bounce(g, patch.size, step), patch);
  }
  const int most_sweeps =
      is_small(island) ? tolerance::small_bounce_sweeps : tolerance::bounce_sweeps;
  for (int k = 0; k < most_sweeps; ++k) {
    double most = 0.0;
    for (const int contact : island.patch_indices) {
      ContactPatch& patch = island.all_patches[idx(contact)];
      most = std::max(
          most, solve_patch(patch, island.now[idx(patch.first)], island.now[idx(patch.second)],
                            tolerance::bounce_patch_iterations));
    }
    ++report.iterations;
    report.impulses += static_cast<std::int64_t>(island.patch_indices.size());
    if (most < negligible_residual(island)) break;
  }
}

// Whether a point overlaps by more than a share of the shortest edge.
bool overlaps_by(const ContactPatch& patch, double share) {
  return std::any_of(patch.used().begin(), patch.used().end(),
                     [&](const ContactPatchPoint& p) { return -p.gap > share * patch.size; });
}

bool overlaps(const ContactPatch& patch) { return overlaps_by(patch, tolerance::contact_slop); }

// Sweeps of the overlap correction, from the ground up.
void correct_island(const Island& island, int sweeps, std::vector<MovingBody>& displacements) {
  for (const int contact : island.upward) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    begin_correction(displacements[idx(patch.first)], displacements[idx(patch.second)], patch);
  }
  double first = 0.0;
  for (int k = 0; k < sweeps; ++k) {
    double most = 0.0;  // [-] as a share of the size
    for (const int contact : island.upward) {
      ContactPatch& patch = island.all_patches[idx(contact)];
      MovingBody& first_body = displacements[idx(patch.first)];
      MovingBody& second_body = displacements[idx(patch.second)];
      // Most patches neither overlap nor have a neighbour that does.
      if (!first_body.changed && !second_body.changed &&
          !overlaps_by(patch, tolerance::repair_rest))
        continue;
      const double change = correct_overlap(patch, tolerance::repair_rest * patch.size,
                                            tolerance::repair_share, first_body, second_body);
      most = std::max(most, change / patch.size);
    }
    if (k == 0) first = most;
    if (most < tolerance::correction_converged * std::max(first, tolerance::contact_slop)) break;
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
    if (!any_bounced) {
      velocities_.before_bounce = velocities_.end;
      storage_.impulses_before_bounce.resize(patches.size());
    }
    any_bounced = true;
    const Island island = view_of_island(world, k, dt);
    for (const int contact : island.patch_indices)
      storage_.impulses_before_bounce[idx(contact)] = impulses_in(patches[idx(contact)]);
    bounce_island(island, storage_.step, report);
    limit_bounce(island, velocities_.before_bounce, storage_.impulses_before_bounce, report);
  }
  if (any_bounced) store_bounced_velocities(world);
  if (observer() == nullptr) return;
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (storage_.hit[k] != 0) notify_observer(patches[k], dt);
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

// Overlap beyond the slop is corrected in all islands that have some.
void ContactDamped::correct_overlaps(World& world, double dt, StepReport& report) {
  const std::vector<ContactPatch>& patches = memory_.manifolds.patches();
  if (std::none_of(patches.begin(), patches.end(), overlaps)) return;
  // Displacements have no momentum to conserve, so all bodies get the same mass: a light box below a heavy one
  // needs no more sweeps than any other.
  std::vector<MovingBody>& displacements = storage_.displacements;
  displacements = velocities_.end;
  for (MovingBody& body : displacements) {
    body.velocity_w.setZero();
    body.angular_velocity_w.setZero();
    body.changed = false;
    if (body.inverse_mass.x() == 0.0) continue;
    body.inverse_inertia_w /= body.inverse_mass.x();
    body.inverse_mass.setOnes();
  }
  for (int k = 0; k < memory_.order.islands().count(); ++k) {
    const Island current = view_of_island(world, k, dt);
    if (std::none_of(current.patch_indices.begin(), current.patch_indices.end(),
                     [&](int contact) { return overlaps(patches[idx(contact)]); }))
      continue;
    correct_island(current,
                   is_large_and_fast(current)
                       ? std::min(options_.correction_sweeps, tolerance::fast_correction_sweeps)
                       : options_.correction_sweeps,
                   displacements);
  }
  for (std::size_t k = 0; k < displacements.size(); ++k) {
    if (!displacements[k].changed || displacements[k].inverse_mass.x() == 0.0) continue;
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    // [S6.3.1:turn]
    const Vec3 moved_w = displacements[k].velocity_w;
    report.energy.repair -= body.mass * world.gravity_w.dot(moved_w);
    state.position_w += moved_w;
    // Angular momentum turns with the body. Its angular velocity in its own frame stays, and with it the kinetic
    // energy, which of a thin rod would otherwise grow by up to the ratio of its moments of inertia.
    const Quat turn = rotation_from_vector(displacements[k].angular_velocity_w);
    state.orientation_wb = (turn * state.orientation_wb).normalized();
    state.angular_momentum_w = turn * state.angular_momentum_w;
    // [S6.3.1:turn]
  }
}

// Energy that the impulses of the step have added: what bodies have now less what they had. The part that is not the
// work of friction, nor that of pivot updates, is booked as restitution. Called before overlap is corrected.
void ContactDamped::account(const World& world, StepReport& report) const {
  const std::vector<MovingBody>& start = velocities_.start;
  const std::vector<MovingBody>& end = velocities_.end;
  double all = -report.energy.repair;  // pivot updates have booked their part already
  for (std::size_t k = 0; k < end.size(); ++k) {
    if (end[k].inverse_mass.x() == 0.0) continue;
    if (storage_.in_flight[k] != 0 && !end[k].changed) continue;
    const BodyProperties& body = world.bodies()[k];
    const Vec3& spin_w = start[k].angular_velocity_w;
    all += kinetic_energy(body, world.states()[k]) -
           0.5 * body.mass * start[k].velocity_w.squaredNorm() -
           0.5 * spin_w.dot(start[k].inverse_inertia_w.inverse() * spin_w) -
           body.mass * world.gravity_w.dot(world.states()[k].position_w - start[k].position_w);
  }
  for (const ContactPatch& patch : memory_.manifolds.patches()) {
    const Six u = motion_of(patch, start[idx(patch.first)], start[idx(patch.second)]);
    const Six v = motion_of(patch, end[idx(patch.first)], end[idx(patch.second)]);
    report.energy.friction +=
        0.5 * (patch.along_impulse * (u[0] + v[0]) + patch.across_impulse * (u[1] + v[1]) +
               patch.twist_impulse * (u[5] + v[5]));
  }
  report.energy.restitution = all - report.energy.friction;
  for (const ContactPatch& patch : memory_.manifolds.patches())
    report.contacts += std::count_if(patch.used().begin(), patch.used().end(),
                                     [](const ContactPatchPoint& p) { return p.impulse > 0.0; });
  const auto finite = [](const MovingBody& body) {
    return body.velocity_w.allFinite() && body.angular_velocity_w.allFinite();
  };
  if (!std::all_of(end.begin(), end.end(), finite)) report.status = StepStatus::not_finite;
}

// The bodies meet when the first of the points that were hit has closed its gap: halfway, and beside that where the
// lighter one has come.
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
  const Vec3 middle_w = first.position_w + patch.first_arm_w;
  const Vec3 first_w = velocity_at(first, middle_w), second_w = velocity_at(second, middle_w);
  const double share = first.inverse_mass.x() / (first.inverse_mass.x() + second.inverse_mass.x());
  const Vec3 lighter_w = share * first_w + (1.0 - share) * second_w;
  const double halfway = event.normal_w.dot(0.5 * (first_w + second_w) - lighter_w);
  event.point_w = middle_w + until * (lighter_w + halfway * event.normal_w);
  const Six impulse = impulse_of(patch);
  event.impulse_w = patch.frame_w * Vec3(impulse[0], impulse[1], impulse[2]);
  observer()->on_event(event);
}

// Made on demand. A point's friction is that of the patch, in proportion to its pressure.
std::span<const ContactRecord> ContactDamped::contacts() const {
  if (recorded_) return records_;
  records_.clear();
  for (const ContactPatch& patch : memory_.manifolds.patches()) {
    const Six all = impulse_of(patch);
    const bool slips = is_at_friction_bound(patch);
    for (const ContactPatchPoint& p : patch.used()) {
      const double share = all[2] > 0.0 ? p.impulse / all[2] : 0.0;
      ContactRecord record;
      record.time = contact_time_;
      record.first = patch.first_id;
      record.second = patch.second_id;
      record.point_w = position_of(patch, velocities_.start[idx(patch.first)], p);
      record.normal_w = patch.frame_w.col(2);
      record.push_w = patch.frame_w * Vec3(share * all[0], share * all[1], p.impulse);
      record.state = !(p.impulse > 0.0) ? ContactState::open
                     : slips            ? ContactState::slip
                                        : ContactState::stick;
      records_.push_back(record);
    }
  }
  recorded_ = true;
  return records_;
}

}  // namespace tumble
