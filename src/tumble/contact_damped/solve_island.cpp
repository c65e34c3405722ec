/// \file
/// \brief The default technique: the impulses of an island.
#include "tumble/base/index.hpp"
#include "tumble/contact_damped/body_motion.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/island_plan.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <vector>

namespace tumble {
namespace {

// [-] Solutions of blocks of a large quiet island in a step, at most. Reason: with one a heap of a thousand cubes takes thirty
// seconds to come to rest, with three fifteen, with six no less. (6.3.1)
constexpr int kBlockRounds = 3;

// The k-th sweep over an island, from 0 on: down and up in turn. Returns the largest change of a velocity.
double sweep_number(int k, const Island& island, const IslandPlan& plan, StepReport& report,
                    std::span<double> changes = {}) {
  return sweep(island, k % 2 == 0 ? SweepOrder::down : SweepOrder::up, plan.patch_iterations,
               plan.skipped_residual, report, changes);
}

// Sweeps over an island until little changes, so many at most. Returns by how much the last one changed a velocity [m/s].
double sweep_at_most(int most, const Island& island, const IslandPlan& plan, StepReport& report) {
  double residual = 0.0;
  for (int k = 0; k < most; ++k) {
    residual = sweep_number(k, island, plan, report);
    if (residual < plan.residual) break;
  }
  return residual;
}

// Whether slow patches of an island are held, and none sinks deeply.
bool holds(const Island& island, const IslandPlan& plan) {
  return approach_of_slow_patches(island) < plan.slow_approach &&
         deepest_sinking(island) < tolerance::deep_sinking;
}

// Goes on sweeping after the first two sweeps. Returns whether that was enough.
bool sweep_on(const Island& island, const IslandPlan& plan, const FirstSweeps& first,
              StepReport& report) {
  double residual = first.up;
  double before = std::max(first.down, first.up);  // some sweeps ago
  for (int k = 2; k < plan.max_sweeps; ++k) {
    residual = sweep_number(k, island, plan, report);
    if (residual < plan.residual) return true;
    if (!plan.while_halving || (k + 1) % tolerance::sweeps_to_halve != 0) continue;
    if (residual > 0.5 * before) break;
    before = residual;
  }
  return residual < plan.fair_residual;
}

// All patches together. Returns `swept` if the direct solver did not accept the island. A result that has not converged is the
// start of sweeps, which put friction back into its cone, and stop approach. With much friction sweeps may not converge: they are
// undone if they end farther from a solution.
IslandOutcome solve_directly(const Island& island, const IslandPlan& plan, IslandSolver& solver,
                             KeptSolution& before, StepReport& report) {
  const IslandResult result = solver.solve(island, plan.direct);
  report.iterations += result.iterations;
  report.pivots += result.factorizations;  // the costliest part of the work, as pivots elsewhere
  if (!result.accepted) return IslandOutcome::swept;
  if (result.converged || result.improved) return IslandOutcome::direct;
  const bool steep = is_steep(island);
  if (steep) before.keep(island);
  const double residual = sweep_at_most(plan.sweeps_if_unconverged, island, plan, report);
  if (steep && residual > result.residual) before.restore(island);
  return IslandOutcome::unconverged;
}

// Solves a block of an island, and goes back if that does not converge.
void solve_block(const Island& block, const IslandPlan& plan, IslandSolver& solver,
                 KeptSolution& before, StepReport& report) {
  if (block.bodies.empty()) return;
  before.keep(block);
  const IslandResult result = solver.solve(block, plan.block);
  report.pivots += result.factorizations;
  if (!result.converged && !result.improved) before.restore(block);
}

// Pairs of sweeps, down and up, and then a few times the block that they leave unsolved, each time with another pair. Returns
// whether that was enough. If only the sweeps were, blocks are undone.
bool sweep_and_solve_blocks(const Island& island, const IslandPlan& plan, IslandBlock& left,
                            IslandSolver& solver, KeptSolution& swept, KeptSolution& before,
                            StepReport& report) {
  const int pairs = std::max(1, (plan.max_sweeps - 2) / 2);
  double residual = 0.0, residual_swept = 0.0;
  for (int k = 0; k < pairs + kBlockRounds; ++k) {
    if (k == pairs) {
      swept.keep(island);
      residual_swept = residual;
    }
    if (k >= pairs) solve_block(left.find(island), plan, solver, before, report);
    residual = sweep_number(0, island, plan, report);
    if (residual < plan.residual) return true;
    residual = sweep_number(1, island, plan, report, left.changes(island));
    if (residual < plan.residual) return true;
  }
  if (residual < plan.fair_residual) return true;
  if (!(residual_swept < plan.fair_residual)) return false;
  swept.restore(island);
  return true;
}

// Of the impulses that sweeps have found, and those of the direct solver, the ones with which bodies sink less into each
// other. Where little sinks the direct solver is not tried.
IslandOutcome solve_if_sinking(const Island& island, const IslandPlan& plan, IslandSolver& solver,
                               KeptSolution& before, KeptSolution& direct, StepReport& report) {
  const double swept = deepest_sinking(island);
  if (swept < tolerance::deep_sinking) return IslandOutcome::swept;
  before.keep(island);
  const IslandOutcome outcome = solve_directly(island, plan, solver, direct, report);
  const bool wrong = outcome == IslandOutcome::unconverged && pushes_apart(island);
  if (outcome != IslandOutcome::swept && !wrong && deepest_sinking(island) < swept) return outcome;
  before.restore(island);
  return IslandOutcome::swept;
}

// Impulses that add energy, swept or of the direct solver, are no solution, but are near one. Each sweep that begins with them
// takes energy; enough are made where they add little, and slow patches are held. Where they do not get there, sweeps begin
// without impulses, and add none whatever their number. Returns the share of the impulses that adds no energy.
double sweep_without_gain(const Island& island, const IslandPlan& plan, StepReport& report) {
  ++report.fallbacks;
  double share = 0.0;
  for (int k = 0; k < tolerance::sweeps_after_gain; ++k) {
    sweep_number(k, island, plan, report);
    if (k % 2 == 0) continue;
    share = share_without_gain(island);
    if (share >= tolerance::least_share && holds(island, plan)) return share;
  }
  if (share >= tolerance::least_share) return share;
  discard_impulses(island);
  sweep_at_most(tolerance::sweeps_after_gain, island, plan, report);
  return share_without_gain(island);
}

// Velocities without contacts, with a share of the impulses of friction, which becomes all of them.
void hold_friction(const Island& island, double share, std::vector<MovingBody>& held) {
  copy_bodies(island, island.free, held);
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    Six friction{};
    friction[six::along] = patch.along_impulse *= share;
    friction[six::across] = patch.across_impulse *= share;
    friction[six::twist] = patch.twist_impulse *= share;
    apply(friction, patch, held[idx(patch.first)], held[idx(patch.second)]);
  }
}

// Where overlap exceeds that of the plan, normal impulses are solved for with friction held as it is. If that adds energy, as
// friction belonged to other pressures, with half of the friction, or none. What makes bodies sink no less is undone.
void stop_sinking(const Island& island, const IslandPlan& plan, const IslandEffort& effort,
                  IslandSolver& solver, KeptSolution& before, std::vector<MovingBody>& held,
                  std::span<char> in_flight, StepReport& report) {
  const double overlap = overlap_of_sinking(island);
  if (!(overlap > plan.overlap) || normal_exceeds_budget(island, effort, solver)) return;
  before.keep(island, in_flight);
  for (const double share : {1.0, 0.5, 0.0}) {
    hold_friction(island, share, held);
    const IslandResult result = solver.solve_normal(island, plan.normal, held);
    report.pivots += result.factorizations;
    if (!result.accepted) break;
    if (overlap_of_sinking(island) < overlap && share_without_gain(island) == 1.0) {
      for (const int body : island.bodies) in_flight[idx(body)] = 1;
      decide_flight(island, in_flight);
      return;
    }
  }
  before.restore(island, in_flight);
}

}  // namespace

IslandEffort ContactDamped::effort() const {
  return {options_.sweeps, options_.admm_iterations, options_.budget, storage_.crowded,
          storage_.parts};
}

void ContactDamped::solve_island(const Island& island, StepReport& report) {
  if (island.patch_indices.empty()) return;
  const std::int64_t before = report.iterations;
  const bool direct_last_step =
      std::any_of(island.patch_indices.begin(), island.patch_indices.end(),
                  [&](int contact) { return island.all_patches[idx(contact)].solved_directly; });
  // [S6.3.1:island]
  // Begin with the impulses of the step before.
  warm_start(island);
  // One sweep from the top down, as weight goes: at rest it finds nothing
  // to do. Another one up, as support goes, shows whether sweeps converge.
  const FirstSweeps first = sweep_first(island, direct_last_step, report);
  const IslandPlan plan = plan_island(island, first, effort(), memory_.island_solver);
  if (plan.discard_warm_start) discard_impulses(island);
  accept(island, plan, run_plan(island, plan, first, report), report);
  // [S6.3.1:island]
  storage_.work += (report.iterations - before) * std::ssize(island.patch_indices);
}

// Solves an island again whose patches or targets are new. In one that is left to sweeps few of them are: sweeps go on from its
// impulses, as they do in a large one once the step has cost its budget. Others begin with what was found.
void ContactDamped::solve_again(const Island& island, StepReport& report) {
  for (const int body : island.bodies) storage_.in_flight[idx(body)] = 1;
  note_approach(island);
  const bool late = !is_small(island) && storage_.work > options_.budget;
  if (!late && !has_to_be_swept(island, speed_range(island), effort(), memory_.island_solver)) {
    for (const int body : island.bodies) velocities_.end[idx(body)] = velocities_.free[idx(body)];
    solve_island(island, report);
    return;
  }
  const IslandPlan plan = plan_island(island, {}, effort(), memory_.island_solver);
  sweep_at_most(options_.sweeps, island, plan, report);
  accept(island, plan, IslandOutcome::swept, report);
}

// Makes what a plan asks for.
IslandOutcome ContactDamped::run_plan(const Island& island, const IslandPlan& plan,
                                      const FirstSweeps& first, StepReport& report) {
  // [S6.3.1:methods]
  const auto directly = [&] {
    return solve_directly(island, plan, memory_.island_solver, storage_.kept_block, report);
  };
  auto outcome = IslandOutcome::swept;
  switch (plan.method) {
    case IslandMethod::settled: break;
    case IslandMethod::sweep:
      // It moves and costs too much, or the direct solver is off.
      sweep_on(island, plan, first, report);
      break;
    case IslandMethod::sweep_unless_sinking:
      // Much of it moves, and there is time for the direct solver.
      if (!sweep_on(island, plan, first, report))
        outcome = solve_if_sinking(island, plan, memory_.island_solver, storage_.kept_swept,
                                   storage_.kept_block, report);
      break;
    case IslandMethod::sweep_then_direct:
      // Little of it moves, or fast, or it slides, or sweeps converge.
      if (!sweep_on(island, plan, first, report)) outcome = directly();
      break;
    case IslandMethod::blocks_then_direct:
      // It is quiet, and too costly to solve at once in each step.
      if (!sweep_and_solve_blocks(island, plan, storage_.block, memory_.island_solver,
                                  storage_.kept_swept, storage_.kept_block, report))
        outcome = directly();
      break;
    case IslandMethod::direct_then_sweep:
      // Weight has to go through all of it at once.
      outcome = directly();
      if (outcome == IslandOutcome::swept) sweep_on(island, plan, first, report);
      break;
  }
  // [S6.3.1:methods]
  return outcome;
}

// Impulses that push bodies apart are discarded, and sweeps begin anew: those of an impact that the direct solver has not found,
// and in and after an impact swept ones where much moves, within the budget. Those that add energy are not taken as they are, nor
// those with which bodies sink deeply, and what nothing holds flies.
void ContactDamped::accept(const Island& island, const IslandPlan& plan, IslandOutcome outcome,
                           StepReport& report) {
  const bool only_swept =
      outcome == IslandOutcome::swept && plan.method == IslandMethod::sweep_unless_sinking;
  const bool impact = has_impact(island);
  const bool unfinished = outcome == IslandOutcome::unconverged && impact;
  if (((only_swept && (impact || is_after_impact(island))) || unfinished) && pushes_apart(island)) {
    discard_impulses(island);
    const int least = unfinished ? tolerance::sweeps_after_gain : 0;
    sweep_at_most(std::max(plan.max_sweeps, least), island, plan, report);
    outcome = IslandOutcome::swept;
  }
  double share = share_without_gain(island);
  if (share < tolerance::least_share) {
    share = sweep_without_gain(island, plan, report);
    outcome = IslandOutcome::swept;
  }
  if (plan.method != IslandMethod::settled)  // which changes nothing
    for (const int contact : island.patch_indices) {
      ContactPatch& patch = island.all_patches[idx(contact)];
      patch.solved_directly = outcome != IslandOutcome::swept;
      if (impact) patch.steps_since_impact = 0;
    }
  decide_flight(island, storage_.in_flight);
  limit_energy(island, share, report);
  if (plan.method != IslandMethod::settled && plan.method != IslandMethod::sweep)
    stop_sinking(island, plan, effort(), memory_.island_solver, storage_.kept_swept, storage_.held,
                 storage_.in_flight, report);
}

}  // namespace tumble
