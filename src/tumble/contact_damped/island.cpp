/// \file
/// \brief One island in a step, and sweeps over it.
#include "tumble/contact_damped/island.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/patch_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// The normal velocity with which a point hits after a free fall through its gap; 0 or above if it does not
// approach before gravity has acted: a resting point does not hit.
double approach_of(const ContactPatchPoint& p, const Six& before, const Six& after, double dt) {
  const double start = before[2] + p.across * before[3] - p.along * before[4];
  const double end = after[2] + p.across * after[3] - p.along * after[4];
  if (start >= 0.0) return start;
  const double gained = -2.0 * (end - start) / dt * std::max(p.gap, 0.0);
  return -std::sqrt(std::max(start * start + gained, 0.0));
}

void note_approach_of(const Island& island, ContactPatch& patch) {
  const Six before =
      motion_of(patch, island.start[idx(patch.first)], island.start[idx(patch.second)]);
  const Six after = motion_of(patch, island.free[idx(patch.first)], island.free[idx(patch.second)]);
  for (ContactPatchPoint& p : patch.used()) p.approach = approach_of(p, before, after, island.dt);
}

// sqrt(g L) [m/s], or what stands for it.
double fall_speed(const Island& island, double size) {
  const double g = island.world.gravity_w.norm();
  return g > 0.0 ? std::sqrt(g * size) : tolerance::weightless_unit * size / island.dt;
}

// Speed of the fastest point of a patch, of its two bodies along each other or apart, as a share of sqrt(g L).
double scaled_speed(const Island& island, const ContactPatch& patch,
                    std::span<const MovingBody> moving) {
  const double unit = fall_speed(island, patch.size);
  const Six u = motion_of(patch, moving[idx(patch.first)], moving[idx(patch.second)]);
  double most = 0.0;
  for (const ContactPatchPoint& p : patch.used())
    most = std::max(most, velocity_at(p.along, p.across, u).norm());
  return most / unit;
}

// Whether bodies are so slow by themselves that no patch moves, and none has to be looked at. Against each other two may be
// twice as fast, and points of their patch lie a little beside them: a margin of two.
bool is_slow(const Island& island, std::span<const MovingBody> moving) {
  double fastest = 0.0;  // [m/s]
  for (const int k : island.bodies)
    fastest = std::max(fastest,
                       fastest_point_speed(island.world.bodies()[idx(k)], moving[idx(k)].velocity_w,
                                           moving[idx(k)].angular_velocity_w));
  return 4.0 * fastest < tolerance::moving_speed * fall_speed(island, shortest_edge(island));
}

// Whether a patch moves before the step, and with the impulses so far.
bool moves_both_times(const Island& island, const ContactPatch& patch) {
  return scaled_speed(island, patch, island.start) > tolerance::moving_speed &&
         scaled_speed(island, patch, island.now) > tolerance::moving_speed;
}

// [-] Bodies that few are, at most. Reason: a slider, and two that it pushes. (6.3.1)
constexpr std::size_t kFewBodies = 3;

bool is_between_movable(const Island& island, const ContactPatch& patch) {
  return island.now[idx(patch.first)].inverse_mass.x() > 0.0 &&
         island.now[idx(patch.second)].inverse_mass.x() > 0.0;
}

// Whether all patches that move are of some bodies, or of few others besides. Those with immovable bodies count in an impact only.
bool only_few_move(const Island& island, bool impact, std::array<int, kFewBodies> bodies,
                   std::size_t count) {
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const std::span known(bodies.data(), count);
    if (std::any_of(known.begin(), known.end(),
                    [&](int k) { return k == patch.first || k == patch.second; }) ||
        !(impact || is_between_movable(island, patch)) || !moves_both_times(island, patch))
      continue;
    if (count == kFewBodies) return false;
    // Then one of its two is one of the few.
    const std::array pair{patch.first, patch.second};
    return std::any_of(pair.begin(), pair.end(), [&](int k) {
      bodies[count] = k;
      return island.now[idx(k)].inverse_mass.x() > 0.0 &&
             only_few_move(island, impact, bodies, count + 1);
    });
  }
  return true;
}

// By how much a point of a patch approaches faster than its target allows [m/s]; below 0 if none does.
double approach_in(const ContactPatch& patch, const Island& island) {
  const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  double most = -std::numeric_limits<double>::infinity();
  for (const ContactPatchPoint& p : patch.used())
    most = std::max(most, p.target - velocity_at(p.along, p.across, u).z());
  return most;
}

}  // namespace

double shortest_edge(const Island& island) {
  double size = std::numeric_limits<double>::infinity();
  for (const int contact : island.patch_indices)
    size = std::min(size, island.all_patches[idx(contact)].size);
  return size;
}

double gravity_in_step(double gravity, double size, double dt) {
  return gravity > 0.0 ? gravity * dt : tolerance::weightless_speed * size / dt;
}

double unit_speed(const Island& island) {
  const double g = island.world.gravity_w.norm();
  return gravity_in_step(g, g > 0.0 ? 0.0 : shortest_edge(island), island.dt);
}

double negligible_residual(const Island& island) {
  return tolerance::contact_settled * unit_speed(island);
}

SpeedRange speed_range(const Island& island) {
  double before = 0.0, now = 0.0;
  int moving = 0;  // patches
  const bool impact = has_impact(island);
  bool as_one = !impact;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const double had = scaled_speed(island, patch, island.start);
    const double has = scaled_speed(island, patch, island.now);
    before = std::max(before, had);
    now = std::max(now, has);
    if (!(had > tolerance::moving_speed && has > tolerance::moving_speed)) continue;
    ++moving;
    as_one = as_one && !is_between_movable(island, patch);
  }
  return {std::min(before, now), std::max(before, now),
          static_cast<double>(moving) / static_cast<double>(island.patch_indices.size()),
          as_one || only_few_move(island, impact, {}, 0), as_one};
}

bool hardly_moves(const Island& island) {
  return (is_slow(island, island.start) && is_slow(island, island.now)) ||
         speed_range(island).higher < tolerance::moving_speed;
}

std::int64_t moving_patches(const Island& island) {
  if (is_slow(island, island.start)) return 0;
  return std::count_if(island.patch_indices.begin(), island.patch_indices.end(), [&](int contact) {
    return scaled_speed(island, island.all_patches[idx(contact)], island.start) >
           tolerance::moving_speed;
  });
}

double approach_of_slow_patches(const Island& island) {
  double most = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    if (scaled_speed(island, patch, island.start) >= tolerance::fast_speed &&
        scaled_speed(island, patch, island.now) >= tolerance::fast_speed)
      continue;
    most = std::max(most, approach_in(patch, island));
  }
  return most;
}

double deepest_sinking(const Island& island) {
  double deepest = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    deepest = std::max(deepest, island.dt * approach_in(patch, island) / patch.size);
  }
  return deepest;
}

double overlap_of_sinking(const Island& island) {
  double deepest = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
    for (const ContactPatchPoint& p : patch.used()) {
      const double way = island.dt * (p.target - velocity_at(p.along, p.across, u).z());
      if (way > tolerance::sinking_that_counts * patch.size)
        deepest = std::max(deepest, (way + std::max(0.0, -p.gap)) / patch.size);
    }
  }
  return deepest;
}

bool is_large_and_fast(const Island& island) {
  return !is_small(island) && speed_range(island).lower >= tolerance::fast_speed;
}

bool is_small(const Island& island) {
  return island.bodies.size() <= static_cast<std::size_t>(tolerance::small_island);
}

bool is_steep(const Island& island) {
  return std::any_of(island.patch_indices.begin(), island.patch_indices.end(), [&](int contact) {
    return island.all_patches[idx(contact)].friction > tolerance::newton_steepest_friction;
  });
}

bool has_impact(const Island& island) {
  return std::any_of(island.patch_indices.begin(), island.patch_indices.end(), [&](int contact) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const double fast = tolerance::fast_speed * fall_speed(island, patch.size);
    const auto points = patch.used();
    return std::any_of(points.begin(), points.end(),
                       [&](const ContactPatchPoint& p) { return p.approach < -fast; });
  });
}

bool is_after_impact(const Island& island) {
  return std::any_of(island.patch_indices.begin(), island.patch_indices.end(), [&](int contact) {
    return island.all_patches[idx(contact)].steps_since_impact <= tolerance::steps_after_impact;
  });
}

void note_approach(const Island& island) {
  for (const int contact : island.patch_indices)
    note_approach_of(island, island.all_patches[idx(contact)]);
}

void warm_start(const Island& island) {
  for (const int contact : island.upward) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    note_approach_of(island, patch);
    apply(impulse_of(patch), patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  }
}

double sweep(const Island& island, SweepOrder order, int patch_iterations, double residual,
             StepReport& report, std::span<double> changes) {
  // [S6.3.1:sweep]
  double most = 0.0;
  const std::size_t count = island.upward.size();
  for (std::size_t k = 0; k < count; ++k) {
    const int contact = island.upward[order == SweepOrder::down ? count - 1 - k : k];
    ContactPatch& patch = island.all_patches[idx(contact)];
    const double change = solve_patch(patch, island.now[idx(patch.first)],
                                      island.now[idx(patch.second)], patch_iterations, residual);
    if (!changes.empty()) changes[idx(contact)] = change;
    most = std::max(most, change);
  }
  // [S6.3.1:sweep]
  ++report.iterations;
  report.impulses += static_cast<std::int64_t>(count);
  return most;
}

void copy_bodies(const Island& island, std::span<const MovingBody> from,
                 std::vector<MovingBody>& to) {
  to.resize(from.size());
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    for (const int k : {patch.first, patch.second}) to[idx(k)] = from[idx(k)];
  }
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

}  // namespace tumble
