/// \file
/// \brief One island in a step: the energy guards of its impulses.
#include "tumble/base/index.hpp"
#include "tumble/contact/energy_on_the_way.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/island.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <algorithm>

namespace tumble {
namespace {

// Velocity in the world's frame and angular velocity in a body's own one at the start of the step.
Vec6 motion_in(const Island& island, int k, const MovingBody& moving) {
  Vec6 u;
  u << moving.velocity_w, island.start_wb[idx(k)].conjugate() * moving.angular_velocity_w;
  return u;
}

// What the kinetic energy of a body is in these coordinates: the sum of each squared times its weight.
Vec6 energy_weights(const BodyProperties& body) {
  Vec6 weights;
  weights << Vec3::Constant(0.5 * body.mass), 0.5 * body.inertia_b;
  return weights;
}

// The kinetic energy on the way from earlier velocities to the present ones, over that of the start of the step.
EnergyOnTheWay kinetic_energy_from(const Island& island, std::span<const MovingBody> from) {
  EnergyOnTheWay way;
  for (const int k : island.bodies) {
    if (island.now[idx(k)].inverse_mass.x() == 0.0) continue;
    const Vec6 weights = energy_weights(island.world.bodies()[idx(k)]);
    const Vec6 had = motion_in(island, k, island.start[idx(k)]);
    const Vec6 u = motion_in(island, k, from[idx(k)]);
    const Vec6 more = motion_in(island, k, island.now[idx(k)]) - u;
    way.start += weights.dot(u.cwiseAbs2() - had.cwiseAbs2());
    way.slope += 2.0 * weights.dot(u.cwiseProduct(more));
    way.curvature += weights.dot(more.cwiseAbs2());
    way.error += tolerance::energy_rounding * weights.dot(u.cwiseAbs2() + had.cwiseAbs2());
  }
  return way;
}

}  // namespace

double share_without_gain(const Island& island) {
  EnergyOnTheWay way = kinetic_energy_from(island, island.free);
  way.start = 0.0;  // compared with `free`
  return way.allowed();
}

bool pushes_apart(const Island& island) {
  double work = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
    for (const ContactPatchPoint& p : patch.used())
      if (p.impulse > 0.0)
        work += p.impulse * std::max(0.0, velocity_at(p.along, p.across, u).z() - p.target);
  }
  const double least =
      tolerance::work_apart_floor *
      gravity_in_step(island.world.gravity_w.norm(), shortest_edge(island), island.dt);
  double energy = 0.0;
  for (const int k : island.bodies) {
    const BodyProperties& body = island.world.bodies()[idx(k)];
    const Vec6 change =
        motion_in(island, k, island.now[idx(k)]) - motion_in(island, k, island.start[idx(k)]);
    energy += energy_weights(body).dot(change.cwiseAbs2()) + 0.5 * body.mass * least * least;
  }
  return work > tolerance::work_apart * energy;
}

void limit_energy(const Island& island, double share, StepReport& report) {
  // [S6.3.1:guard]
  if (share == 1.0) return;
  for (const int k : island.bodies) interpolate(island.free[idx(k)], share, island.now[idx(k)]);
  for (const int contact : island.patch_indices)
    scale_impulses(share, island.all_patches[idx(contact)]);
  // [S6.3.1:guard]
  ++report.fallbacks;
}

void limit_bounce(const Island& island, std::span<const MovingBody> before,
                  std::span<const PatchImpulses> impulses, StepReport& report) {
  EnergyOnTheWay way = kinetic_energy_from(island, before);
  for (const int k : island.bodies) {
    if (island.now[idx(k)].inverse_mass.x() == 0.0) continue;
    const Vec3 moved_w = island.world.states()[idx(k)].position_w - island.start[idx(k)].position_w;
    way.start -= island.world.bodies()[idx(k)].mass * island.world.gravity_w.dot(moved_w);
  }
  const double share = way.allowed();
  if (share == 1.0) return;
  for (const int k : island.bodies) interpolate(before[idx(k)], share, island.now[idx(k)]);
  for (const int contact : island.patch_indices)
    go_back(impulses[idx(contact)], share, island.all_patches[idx(contact)]);
  ++report.fallbacks;
}

}  // namespace tumble
