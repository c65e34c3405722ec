/// \file
/// \brief The default technique: overlap correction and the energy account.
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/patch_pressure.hpp"
#include "tumble/contact_patches/patch_solver.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// Whether a point overlaps by more than a share of the shortest edge.
bool overlaps_by(const ContactPatch& patch, double share) {
  return std::any_of(patch.used().begin(), patch.used().end(),
                     [&](const ContactPatchPoint& p) { return -p.gap > share * patch.size; });
}

bool overlaps(const ContactPatch& patch) { return overlaps_by(patch, tolerance::repair_start); }

// Sweeps of the overlap correction, from the ground up. Overlap goes until nothing is left: where a share of the slop was left,
// some bodies of a heap crept past it in each step, and their repair disturbed others.
void correct_island(const Island& island, int sweeps, std::span<OverlapCorrection> corrections,
                    std::vector<MovingBody>& displacements) {
  for (const int contact : island.upward) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    corrections[idx(contact)] = {
        inverse_mass_of(patch, displacements[idx(patch.first)], displacements[idx(patch.second)]),
        {}};
  }
  double first = 0.0;
  for (int k = 0; k < sweeps; ++k) {
    double most = 0.0;  // [-] as a share of the size
    for (const int contact : island.upward) {
      const ContactPatch& patch = island.all_patches[idx(contact)];
      MovingBody& first_body = displacements[idx(patch.first)];
      MovingBody& second_body = displacements[idx(patch.second)];
      // Most patches neither overlap nor have a neighbour that does.
      if (!first_body.changed && !second_body.changed && !overlaps_by(patch, 0.0)) continue;
      const double change = correct_overlap(patch, tolerance::repair_share,
                                            corrections[idx(contact)], first_body, second_body);
      most = std::max(most, change / patch.size);
    }
    if (k == 0) first = most;
    if (most < tolerance::correction_converged * std::max(first, tolerance::contact_slop)) break;
  }
}

}  // namespace

// Overlap near the slop or beyond is corrected in all islands that have some.
void ContactDamped::correct_overlaps(World& world, double dt, StepReport& report) {
  const std::vector<ContactPatch>& patches = memory_.manifolds.patches();
  if (std::none_of(patches.begin(), patches.end(), overlaps)) return;
  // Displacements have no momentum to conserve, so all bodies get the same mass: a light box below a heavy one
  // needs no more sweeps than any other.
  std::vector<MovingBody>& displacements = storage_.displacements;
  displacements = velocities_.end;
  storage_.corrections.resize(patches.size());
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
                   storage_.corrections, displacements);
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
