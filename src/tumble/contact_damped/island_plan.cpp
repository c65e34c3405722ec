/// \file
/// \brief The plan by which an island is solved.
#include "tumble/contact_damped/island_plan.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace tumble {
namespace {

// [-] Sweeps that follow the direct solver where it has not converged in a large island that moves. Reason: of 4, 6, 10, 24 and
// as many as before it the number with which 125 cubes that fall together overlap least. (6.3.1)
constexpr int kSweepsWhileMoving = 10;

// [-] Multiplications of a factorization, over the budget, up to which Newton steps for normal impulses are within it. Reason:
// with 3 rows of 200 boxes that are hit move on as one; with 8 piles of 125 cubes cost half as much again, with 3 no more. (6.3.1)
constexpr double kCheapFactor = 3.0;

// Friction and pressure in turn within a patch, in each sweep. Of a single patch they are all there is to do; of many, sweeps do
// the rest.
int patch_iterations_of(const Island& island) {
  const auto patches = static_cast<int>(island.patch_indices.size());
  return is_small(island)
             ? std::max(tolerance::patch_iterations, tolerance::first_patch_iterations / patches)
             : tolerance::patch_iterations;
}

// [m/s] Skipped residuals add up from step to step; a small island skips none.
double skipped_residual_of(const Island& island) {
  return is_small(island) ? 0.0 : tolerance::solved_residual * negligible_residual(island);
}

// By how much this step speeds up the fastest point of an island [m/s].
double speed_gained(const Island& island) {
  double most = 0.0;
  for (const int k : island.bodies)
    most = std::max(most, fastest_point_change(island.world.bodies()[idx(k)], island.start[idx(k)],
                                               island.now[idx(k)]));
  return most;
}

// Whether a patch slides so fast, before the step and with the impulses so far, that friction cannot stop it in a
// few steps.
bool has_sliding_patch(const Island& island, double unit) {
  return std::any_of(island.patch_indices.begin(), island.patch_indices.end(), [&](int contact) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    if (!(impulse_of(patch)[six::normal] > 0.0 && patch.friction > 0.0)) return false;
    const double limit = tolerance::slide_steps * patch.friction * unit;
    const auto slides = [&](std::span<const MovingBody> bodies) {
      const Six u = motion_of(patch, bodies[idx(patch.first)], bodies[idx(patch.second)]);
      return u[0] * u[0] + u[1] * u[1] > limit * limit;
    };
    return slides(island.start) && slides(island.now);
  });
}

// The largest stiffness of springs. Where nothing determines impulses, as in wedged boxes, it enlarges rounding; but it is a
// multiple of the mass that a point resists with, and a point may have to carry heavier bodies.
double stiffness_for_masses(const Island& island) {
  double lightest = std::numeric_limits<double>::infinity(), heaviest = 0.0;
  for (const int k : island.bodies) {
    lightest = std::min(lightest, island.world.bodies()[idx(k)].mass);
    heaviest = std::max(heaviest, island.world.bodies()[idx(k)].mass);
  }
  return std::min(tolerance::admm_stiffness * (heaviest / lightest), tolerance::admm_max_stiffness);
}

// A small island, or one of which few bodies move, is solved to convergence.
IslandLimits exact_limits(const Island& island, int iterations) {
  IslandLimits limits;
  limits.residual = tolerance::solved_residual_exact * negligible_residual(island);
  limits.max_iterations = tolerance::small_island_iterations * iterations;
  limits.max_stiffness = stiffness_for_masses(island);
  limits.max_newton_steps = tolerance::small_newton_steps;
  if (limits.max_stiffness >= tolerance::unequal_masses * tolerance::admm_stiffness ||
      is_steep(island))
    limits.more_iterations = tolerance::more_iterations * iterations;
  return limits;
}

// A large island that does not move gets few Newton steps after ADMM: they converge within some steps of time.
IslandLimits quiet_limits(const Island& island, int iterations) {
  IslandLimits limits;
  limits.residual = tolerance::solved_residual_exact * negligible_residual(island);
  limits.max_iterations = iterations;
  limits.max_newton_steps = tolerance::quiet_newton_steps;
  limits.shift_tolerance = tolerance::contact_slop * shortest_edge(island) / island.dt;
  limits.max_shift_updates = tolerance::quiet_shift_updates;
  limits.good_residual = tolerance::good_residual * negligible_residual(island);
  return limits;
}

// A large island that moves gets ADMM only.
IslandLimits moving_limits(const Island& island, int iterations) {
  IslandLimits limits;
  limits.residual = tolerance::solved_residual * negligible_residual(island);
  limits.max_iterations = iterations;
  limits.max_newton_steps = 0;
  limits.early_stop_residual = tolerance::moving_residual * unit_speed(island);
  return limits;
}

// Whether anything in an island moves, so that its contacts change in the next step.
bool moves(const SpeedRange& speed) {
  return speed.moving > 0.0 || speed.lower >= tolerance::fast_speed;
}

// Whether much of an island moves.
bool much_moves(const Island& island, const SpeedRange& speed) {
  return speed.moving > tolerance::loose_share && (is_small(island) || !speed.few);
}

enum class IslandKind {  // each has its limits
  exact,                 // small, or few of its bodies move: solved to convergence
  loose,                 // much of it moves, and it has to be swept
  steady,                // large, and some of it moves
  quiet                  // large, and nothing of it moves, or all as one
};

IslandKind kind_of(const Island& island, const SpeedRange& speed, bool swept,
                   const IslandEffort& effort, IslandSolver& solver) {
  if (swept && much_moves(island, speed)) return IslandKind::loose;
  if (is_small(island)) return IslandKind::exact;
  if (!moves(speed)) return IslandKind::quiet;
  if (speed.few && !normal_exceeds_budget(island, effort, solver)) return IslandKind::exact;
  return speed.as_one ? IslandKind::quiet : IslandKind::steady;
}

// Sweeps within the budget, so many at most.
int swept_within(const Island& island, const IslandEffort& effort, int most) {
  const auto within = effort.budget / static_cast<int>(island.patch_indices.size());
  return std::clamp(within, effort.sweeps, std::max(effort.sweeps, most));
}

// Whether sweeps may replace the direct solver in a quiet island if that costs too much: it has impulses to begin with, and no more
// levels of support than a step has sweeps. Without impulses, or in a higher one, weight does not get through.
bool sweeps_may_do(const Island& island, const IslandEffort& effort) {
  const auto has_carried = [&](int contact) {
    return island.all_patches[idx(contact)].carried_impulse > 0.0;
  };
  return effort.admm_iterations > 0 &&
         std::any_of(island.patch_indices.begin(), island.patch_indices.end(), has_carried) &&
         island.levels <= swept_within(island, effort, tolerance::loose_sweeps);
}

// The plan of a quiet island that costs too much to solve at once: sweeps settle it within some hundred steps. Where they do
// not come near the direct solver still follows.
void sweep_quiet_island(const Island& island, const IslandEffort& effort, IslandPlan& plan) {
  plan.method = IslandMethod::blocks_then_direct;
  plan.max_sweeps = swept_within(island, effort, tolerance::loose_sweeps);
  plan.residual = plan.skipped_residual = tolerance::solved_residual * negligible_residual(island);
  // The direct solver has to find the weight of what begins to rest, but not what a body that leaves changes.
  plan.fair_residual = hardly_moves(island) ? tolerance::fair_quiet_residual * unit_speed(island)
                                            : std::numeric_limits<double>::infinity();
}

}  // namespace

bool exceeds_budget(const Island& island, const IslandEffort& effort) {
  return static_cast<std::int64_t>(island.patch_indices.size()) * effort.admm_iterations >
         effort.budget;
}

bool has_to_be_swept(const Island& island, const SpeedRange& speed, const IslandEffort& effort,
                     IslandSolver& solver) {
  if (is_small(island)) return effort.crowded && much_moves(island, speed);
  if (much_moves(island, speed)) return true;
  // Where few bodies move the others are as quiet as in a quiet island, and all are where they slide as one.
  return moves(speed) && !speed.as_one && exceeds_budget(island, effort) &&
         (!speed.few || solver.costs_more_than(tolerance::quiet_factor_work, island));
}

bool normal_exceeds_budget(const Island& island, const IslandEffort& effort, IslandSolver& solver) {
  const auto patches = static_cast<std::int64_t>(island.patch_indices.size());
  if (patches * tolerance::small_newton_steps * tolerance::newton_step_sweeps <= effort.budget)
    return false;
  return exceeds_budget(island, effort) ||
         solver.costs_more_than(kCheapFactor * effort.budget, island);
}

bool are_too_many(std::int64_t patches, const IslandEffort& effort) {
  return patches * (tolerance::small_island_sweeps +
                    tolerance::small_island_iterations * effort.admm_iterations) >
         effort.budget;
}

FirstSweeps sweep_first(const Island& island, bool direct_last_step, StepReport& report) {
  // A small island may be settled by them, and is to be so to the last digits.
  const int patch_iterations =
      is_small(island) ? tolerance::first_patch_iterations : tolerance::patch_iterations;
  const double negligible = negligible_residual(island);
  // What the direct solver has found within the bounds of single points, sweeps would change: they bound the friction
  // of a patch as a whole.
  const double skipped = direct_last_step && is_small(island)
                             ? tolerance::solved_residual_exact * negligible
                             : skipped_residual_of(island);
  FirstSweeps first;
  // In a large one that is quiet, only what sticks is swept then, as long as the solution is nearly right.
  if (direct_last_step && !is_small(island) && hardly_moves(island)) {
    first.down = sweep(island, SweepOrder::down, 0, skipped, report);
    first.settled =
        first.down < negligible && speed_gained(island) <= tolerance::solved_residual * negligible;
    first.nearly_solved = first.down < tolerance::nearly_solved * negligible;
    if (first.nearly_solved) return first;
  }
  first.down = sweep(island, SweepOrder::down, patch_iterations, skipped, report);
  // The impulses that stopped an island in the step before would go on pushing, and let it swing. So after a
  // solution they may change no velocity.
  first.stale_warm_start = first.down < negligible && direct_last_step && hardly_moves(island) &&
                           speed_gained(island) > tolerance::solved_residual * negligible;
  first.settled = first.down < negligible && !first.stale_warm_start;
  if (!first.settled) first.up = sweep(island, SweepOrder::up, patch_iterations, skipped, report);
  return first;
}

IslandPlan plan_island(const Island& island, const FirstSweeps& first, const IslandEffort& effort,
                       IslandSolver& solver) {
  IslandPlan plan;
  if (first.settled) return plan;
  const double negligible = negligible_residual(island);
  const double unit = unit_speed(island);
  const SpeedRange speed = speed_range(island);
  const bool swept = has_to_be_swept(island, speed, effort, solver);
  const IslandKind kind = kind_of(island, speed, swept, effort, solver);
  const bool converging =
      !first.stale_warm_start && first.up < tolerance::sweeps_converging * first.down;

  // [S6.3.1:plan]
  // Sweeps do well where they converge, and where the island moves fast or slides. The direct solver is for the
  // others. Where much moves, sweeps have to do, unless bodies sink deeply. Where little of a large island does,
  // sweeps go on as long as they converge. A quiet one that costs too much gets blocks instead, below.
  const bool sweeps_first = kind == IslandKind::loose || kind == IslandKind::steady ||
                            speed.lower >= tolerance::fast_speed || converging ||
                            has_sliding_patch(island, unit);
  plan.method = effort.admm_iterations == 0 || (swept && exceeds_budget(island, effort))
                    ? IslandMethod::sweep
                : kind == IslandKind::loose ? IslandMethod::sweep_unless_sinking
                : sweeps_first              ? IslandMethod::sweep_then_direct
                                            : IslandMethod::direct_then_sweep;
  // [S6.3.1:plan]
  if (first.nearly_solved) plan.method = IslandMethod::direct_then_sweep;
  plan.discard_warm_start = !sweeps_first && first.up > tolerance::diverged_residual * negligible;
  plan.patch_iterations = patch_iterations_of(island);
  plan.skipped_residual = skipped_residual_of(island);
  plan.fair_residual = tolerance::fair_residual * negligible;
  plan.slow_approach = tolerance::slow_approach * unit;
  plan.sweeps_if_unconverged = tolerance::small_island_sweeps;
  plan.overlap = tolerance::large_island_overlap;
  switch (kind) {
    case IslandKind::exact:
      plan.max_sweeps = std::max(effort.sweeps, tolerance::small_island_sweeps);
      plan.residual = tolerance::solved_residual_exact * negligible;
      plan.direct = exact_limits(island, effort.admm_iterations);
      plan.overlap = tolerance::small_island_overlap;
      break;
    case IslandKind::loose:
      plan.max_sweeps = swept_within(island, effort, tolerance::loose_sweeps);
      plan.patch_iterations = tolerance::fast_patch_iterations;
      plan.sweeps_if_unconverged = kSweepsWhileMoving;
      plan.residual = tolerance::loose_residual * unit;
      plan.direct = moving_limits(island, effort.admm_iterations);
      break;
    case IslandKind::steady:
      plan.max_sweeps = swept_within(island, effort, tolerance::steady_sweeps);
      plan.while_halving = true;
      plan.sweeps_if_unconverged = kSweepsWhileMoving;
      plan.residual = negligible;
      plan.direct = moving_limits(island, effort.admm_iterations);
      break;
    case IslandKind::quiet:
      plan.max_sweeps = effort.sweeps;
      plan.residual = tolerance::solved_residual * negligible;
      plan.direct = quiet_limits(island, effort.admm_iterations);
      if (sweeps_may_do(island, effort) &&
          solver.costs_more_than(tolerance::quiet_factor_work, island))
        sweep_quiet_island(island, effort, plan);
      break;
  }
  if (first.nearly_solved) plan.direct.near = tolerance::nearly_solved * negligible;
  plan.direct.unit_speed = unit;
  plan.direct.max_work = tolerance::max_factor_work;
  plan.normal = plan.direct;
  plan.normal.residual = tolerance::loose_residual * unit;
  plan.normal.max_newton_steps = tolerance::small_newton_steps;
  plan.block = plan.direct;
  plan.block.residual = tolerance::solved_residual * negligible;
  plan.block.max_newton_steps = tolerance::small_newton_steps;
  plan.block.near = 0.0;
  if (kind == IslandKind::exact) return plan;
  for (int* const count :
       {&plan.max_sweeps, &plan.direct.max_iterations, &plan.direct.max_newton_steps})
    *count = (*count + effort.parts - 1) / effort.parts;
  return plan;
}

}  // namespace tumble
