/// \file
/// \brief The plan by which an island is solved: one of five methods, or none, with its limits (thesis 6.3.1).
#pragma once

#include "tumble/contact_damped/island.hpp"
#include "tumble/contact_damped/island_solver.hpp"

namespace tumble {

/// The outcome of the first sweeps over an island, by which its plan is chosen.
struct FirstSweeps {
  double down = 0.0;     ///< [m/s] largest change of a velocity in the sweep down
  double up = 0.0;       ///< [m/s] the same in the sweep up; 0 if it was not needed
  bool settled = false;  ///< the sweep down found nothing to change: the island is solved
  /// Nothing to change, but the impulses that stopped the island in the step before would set it moving.
  bool stale_warm_start = false;
  /// It hardly moves, and the impulses of the direct solver still nearly solve it: only what sticks was swept.
  bool nearly_solved = false;
};

/// How much work an island may cost: the options of the technique of these names.
struct IslandEffort {
  int sweeps = 0;           ///< over a large island, at most
  int admm_iterations = 0;  ///< for a large island, at most; 0: the direct solver is not used
  int budget = 0;           ///< of work on a large island in motion, see ContactDampedOptions
  bool crowded = false;     ///< small islands in motion together exceed it, and count as large
  int parts = 1;            ///< into which the step is divided: each gets its share of the work
};

/// The method that solves an island after its first sweeps.
enum class IslandMethod : std::uint8_t {
  settled,               ///< nothing: it is solved
  sweep,                 ///< more sweeps
  sweep_unless_sinking,  ///< more sweeps; the direct solver where bodies sink deeply, if that leaves less
  sweep_then_direct,   ///< more sweeps, then the direct solver if they were not enough
  blocks_then_direct,  ///< ditto, the blocks that sweeps leave being solved by themselves
  direct_then_sweep    ///< the direct solver, or more sweeps if it does not accept the island
};

/// The method for an island, with its limits.
struct IslandPlan {
  IslandMethod method = IslandMethod::settled;  ///< after the first sweeps
  bool discard_warm_start = false;  ///< begin without impulses, as the first sweeps have diverged
  int max_sweeps = 0;               ///< sweeps, the first two included
  int patch_iterations = 1;         ///< of friction and pressure in turn, in each patch and sweep
  double skipped_residual = 0.0;    ///< [m/s] sweeps skip a patch below it
  double residual = 0.0;            ///< [m/s] sweeps end below it
  double fair_residual = 0.0;       ///< [m/s] below it sweeps were enough
  bool while_halving = false;       ///< sweeps end if four of them do not halve the residual
  double slow_approach = 0.0;       ///< [m/s] limit of approach_of_slow_patches()
  int sweeps_if_unconverged = 0;    ///< sweeps that follow if the direct solver does not converge
  IslandLimits direct;              ///< of the direct solver
  IslandLimits block;               ///< of the same for a block of the island
  IslandLimits normal;              ///< of its normal impulses alone
  double overlap = 0.0;             ///< [-] share of the shortest edge beyond which these are found
};

/// The first sweeps over an island: one down, which changes nothing at rest; if it does, one up. In a large and quiet one that
/// the direct solver has solved, only what sticks is swept if that is still nearly a solution: sweeps bound the friction of a
/// patch as a whole, not of its points, and would lead away from it.
/// \param island              after warm_start()
/// \param direct_last_step    whether the direct solver was used for it in the step before
FirstSweeps sweep_first(const Island& island, bool direct_last_step, StepReport& report);

/// Whether the direct solver costs more than the budget of an island in motion: with the default, above a hundred patches.
[[nodiscard]] bool exceeds_budget(const Island& island, const IslandEffort& effort);

/// Whether sweeps have to do: much of a large island moves, so that contacts change before weight gets through all of it; or some
/// of it moves, and the direct solver exceeds the budget, unless few bodies move and it costs as little as for a quiet wall; or
/// much of a small one moves, and there are many such.
/// \param island  with the impulses so far
/// \param solver  as for plan_island()
[[nodiscard]] bool has_to_be_swept(const Island& island, const SpeedRange& speed,
                                   const IslandEffort& effort, IslandSolver& solver);

/// How the impulses of an island were found.
enum class IslandOutcome : std::uint8_t {
  swept,        ///< by sweeps
  unconverged,  ///< by the direct solver, which did not converge, and sweeps after it
  direct        ///< by the direct solver
};

/// Whether Newton steps for the normal impulses of an island exceed the budget: it has many patches, and its matrix costs much,
/// which that of a row of up to 200 bodies does not.
[[nodiscard]] bool normal_exceeds_budget(const Island& island, const IslandEffort& effort,
                                         IslandSolver& solver);

/// Whether small islands in motion, each solved as well as one by itself, exceed the budget of a large one together.
/// \param patches  in these islands that move before the step
[[nodiscard]] bool are_too_many(std::int64_t patches, const IslandEffort& effort);

/// Chooses how an island is solved.
/// \param island  after sweep_first()
/// \param solver  says what a factorization costs
IslandPlan plan_island(const Island& island, const FirstSweeps& first, const IslandEffort& effort,
                       IslandSolver& solver);

}  // namespace tumble
