/// \file
/// \brief One island in a step, and sweeps over it.
#include "tumble/contact_damped/island.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/patch_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// Kinetic energy of velocities, with the body's own inertia: 1/2 m v² + 1/2 omega·I omega.
double kinetic_energy_of(const BodyProperties& body, const Mat3& inertia_w,
                         const MovingBody& moving) {
  return 0.5 * body.mass * moving.velocity_w.squaredNorm() +
         0.5 * moving.angular_velocity_w.dot(inertia_w * moving.angular_velocity_w);
}

// Velocities at a share of the way from one state of motion to another.
void interpolate(const MovingBody& from, double share, MovingBody& to) {
  to.velocity_w = from.velocity_w + share * (to.velocity_w - from.velocity_w);
  to.angular_velocity_w =
      from.angular_velocity_w + share * (to.angular_velocity_w - from.angular_velocity_w);
}

// The normal velocity with which a point hits after a free fall through its gap; 0 or above if it does not
// approach before gravity has acted: a resting point does not hit.
double approach_of(const ContactPatchPoint& p, const Six& before, const Six& after, double dt) {
  const double start = before[2] + p.across * before[3] - p.along * before[4];
  const double end = after[2] + p.across * after[3] - p.along * after[4];
  if (start >= 0.0) return start;
  const double gained = -2.0 * (end - start) / dt * std::max(p.gap, 0.0);
  return -std::sqrt(std::max(start * start + gained, 0.0));
}

// Speed of a body's fastest point, as a share of sqrt(g L).
double scaled_speed(const Island& island, int k, std::span<const MovingBody> moving) {
  const BodyProperties& body = island.world.bodies()[idx(k)];
  const double g = island.world.gravity_w.norm();
  const double size = body.size.minCoeff();
  const double unit = g > 0.0 ? std::sqrt(g * size) : tolerance::weightless_unit * size / island.dt;
  return fastest_point_speed(body, moving[idx(k)].velocity_w, moving[idx(k)].angular_velocity_w) /
         unit;
}

}  // namespace

double shortest_edge(const Island& island) {
  double size = std::numeric_limits<double>::infinity();
  for (const int contact : island.patch_indices)
    size = std::min(size, island.all_patches[idx(contact)].size);
  return size;
}

double negligible_residual(const Island& island) {
  const double g = island.world.gravity_w.norm();
  const double speed =
      g > 0.0 ? g * island.dt : tolerance::weightless_speed * shortest_edge(island) / island.dt;
  return tolerance::contact_settled * speed;
}

SpeedRange speed_range(const Island& island) {
  double before = 0.0, now = 0.0;
  for (const int k : island.bodies) {
    before = std::max(before, scaled_speed(island, k, island.start));
    now = std::max(now, scaled_speed(island, k, island.now));
  }
  return {std::min(before, now), std::max(before, now)};
}

bool moves_fast(const Island& island, int k) {
  return island.world.bodies()[idx(k)].movable() &&
         scaled_speed(island, k, island.start) >= tolerance::fast_speed &&
         scaled_speed(island, k, island.now) >= tolerance::fast_speed;
}

double approach_of_slow_bodies(const Island& island) {
  double most = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    if (moves_fast(island, patch.first) || moves_fast(island, patch.second)) continue;
    const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
    for (const ContactPatchPoint& p : patch.used())
      most = std::max(most, p.target - (u[2] + p.across * u[3] - p.along * u[4]));
  }
  return most;
}

bool is_large_and_fast(const Island& island) {
  return !is_small(island) && speed_range(island).lower >= tolerance::fast_speed;
}

bool is_small(const Island& island) {
  return island.bodies.size() <= static_cast<std::size_t>(tolerance::small_island);
}

void warm_start(const Island& island) {
  for (const int contact : island.upward) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    const Six before =
        motion_of(patch, island.start[idx(patch.first)], island.start[idx(patch.second)]);
    const Six after =
        motion_of(patch, island.free[idx(patch.first)], island.free[idx(patch.second)]);
    for (ContactPatchPoint& p : patch.used()) p.approach = approach_of(p, before, after, island.dt);
    apply(impulse_of(patch), patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  }
}

double sweep(const Island& island, SweepOrder order, int patch_iterations, double residual,
             StepReport& report) {
  double most = 0.0;
  const std::size_t count = island.upward.size();
  for (std::size_t k = 0; k < count; ++k) {
    const int contact = island.upward[order == SweepOrder::down ? count - 1 - k : k];
    ContactPatch& patch = island.all_patches[idx(contact)];
    most = std::max(most, solve_patch(patch, island.now[idx(patch.first)],
                                      island.now[idx(patch.second)], patch_iterations, residual));
  }
  ++report.iterations;
  report.impulses += static_cast<std::int64_t>(count);
  return most;
}

void discard_impulses(const Island& island) {
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    patch.along_impulse = patch.across_impulse = patch.twist_impulse = 0.0;
    for (ContactPatchPoint& p : patch.points) {
      p.impulse = 0.0;
      p.solver_impulse.setZero();
    }
  }
  for (const int k : island.bodies) island.now[idx(k)] = island.free[idx(k)];
}

void limit_energy(const Island& island, StepReport& report) {
  double before = 0.0, after = 0.0, halfway = 0.0;
  for (const int k : island.bodies) {
    if (island.now[idx(k)].inverse_mass.x() == 0.0) continue;
    const BodyProperties& body = island.world.bodies()[idx(k)];
    const Mat3 axes_w = island.world.states()[idx(k)].orientation_wb.toRotationMatrix();
    const Mat3 inertia_w = axes_w * body.inertia_b.asDiagonal() * axes_w.transpose();
    before += kinetic_energy_of(body, inertia_w, island.free[idx(k)]);
    after += kinetic_energy_of(body, inertia_w, island.now[idx(k)]);
    MovingBody middle = island.now[idx(k)];
    interpolate(island.free[idx(k)], 0.5, middle);
    halfway += kinetic_energy_of(body, inertia_w, middle);
  }
  if (after <= before * (1.0 + tolerance::energy_rounding)) return;
  // E(t) = before + b t + a t², E(1) = after, E(1/2) = halfway.
  const double a = 2.0 * (before + after - 2.0 * halfway);
  const double share = std::clamp(1.0 - (after - before) / a, 0.0, 1.0);
  for (const int k : island.bodies) interpolate(island.free[idx(k)], share, island.now[idx(k)]);
  for (const int contact : island.patch_indices)
    scale_impulses(share, island.all_patches[idx(contact)]);
  ++report.fallbacks;
}

}  // namespace tumble
