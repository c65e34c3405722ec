/// \file
/// \brief The small numbers of `contact_damped`.
#pragma once

namespace tumble::tolerance {

// --- contact_damped -----------------------------------------------------------------------

/// [-] An island is left as it is if the impulses of the step before leave no velocity wrong by more than this share of g dt.
/// Reason: 1.6e-6 m/s at 60 Hz is a tenth of a millimetre in a minute. (6.3.1)
inline constexpr double contact_settled = 1e-5;

/// [-] An island with a point faster than this share of sqrt(g L) moves fast, and is swept before the direct solver is tried.
/// Reason: a step is 3 cm for 1 m; boxes of a wall that lands from a millimetre are slower. (6.3.1)
inline constexpr double fast_speed = 0.5;

/// [-] Two bodies move if a point of their patch moves by more than this share of sqrt(g L). Reason: a block that is pulled out of
/// a tower does; cubes of a heap that has come to rest do not, nor those that ADMM has left jittering. (6.3.1)
inline constexpr double moving_speed = 0.05;

/// [-] Share of moving patches above which a large island is left to sweeps. Reason: of 0.1, 0.2, 0.3 and 0.5 the one with which
/// 125 cubes that fall together come to rest earliest; in a tower out of which a block is pulled it is below. (6.3.1)
inline constexpr double loose_share = 0.1;

/// [-] sqrt(g L) where there is no gravity, as a share of L / dt. Reason: at 60 Hz and 1 m the same. (6.3.1)
inline constexpr double weightless_unit = 0.05;

/// [-] Stands for g dt where there is no gravity, as a share of L / dt. Reason: gravity moves a metre's box at 60 Hz by about as
/// much, 0.3 % of it in a step. (6.3.1)
inline constexpr double weightless_speed = 3e-3;

/// [-] Springs of the direct solver, as a multiple of the mass that a point resists with. Reason: of 10, 30, 100, 300 and 1000 the
/// one with the fewest iterations for stacks, pyramids and walls that land. (6.3.1)
inline constexpr double admm_stiffness = 100.0;

/// [-] The mass that a point resists with counts as at least that of the heaviest body that it may carry, over this. Reason: of 1,
/// 10, 100 and 1000 the one with which random worlds with mass ratios of a million overlap least. (6.3.1)
inline constexpr double lightest_spring = 100.0;

/// [-] Springs of the direct solver at their hardest, as a multiple of the mass that a point resists with. Reason: half of the
/// digits are left for what they solve. (6.3.1)
inline constexpr double admm_max_stiffness = 1e6;

/// [-] Springs that Newton's steps of the direct solver keep in balance, ditto. Reason: of 1e3, 1e4 and 1e5 the one with which
/// scenes turned about the vertical stay closest; harder ones enlarge rounding. (6.3.1)
inline constexpr double newton_stiffness = 1e4;

/// [-] Steps that friction of a body's own weight would need to stop what counts as sliding. Reason: at four the direction of the
/// slide hardly changes within a step. (6.3.1)
inline constexpr double slide_steps = 4.0;

/// [rad] Turn in a step below which bodies that push each other are moved each by itself. Reason: the points where they meet part
/// by its square. (6.2)
inline constexpr double least_turn = 1e-5;

/// [rad] Turn in a step from which on it is looked where bodies that touch come to. Reason: below it an edge is lost by less than a
/// thousandth of what slides along it. (3.2)
inline constexpr double turn_that_shows = 0.02;

/// [-] Overlap that bodies may gain in a step by turning, as a share of the shortest edge. Reason: of 0.003, 0.005 and 0.01 the one
/// with which 125 cubes that fall together overlap least; it costs a tenth more time. (3.2)
inline constexpr double sunk_by_turning = 0.003;

/// [-] Solutions of an island to that end, at most. Reason: each loses a small share of what the one before lost. (3.2)
inline constexpr int solutions_for_turning = 3;

/// [rad] A body that turns further in a step is moved in parts of the step. Reason: the energy of a tumbling body swings by up to 2
/// % for half a radian, by a quarter of that for half as much, and by most of it for two. (3.1)
inline constexpr double turn_at_once = 0.25;

/// [rad] Turn in a step to which an island may be brought where it is solved again. Reason: light boxes between heavy ones would
/// give way by spinning. (3.2)
inline constexpr double turn_given_way = 0.5;

/// [-] Way of a point of a contact in a step, as a share of the shortest edge, beyond which a step may be divided. Reason: of 0.04
/// and 0.08 the one with which 125 cubes that fall together overlap less in four parts. (6.3.1)
inline constexpr double way_at_once = 0.04;

/// [-] Two boxes that move against each other by more than this share of their shortest edge in a step are stopped where they meet.
/// Reason: half an edge further on the shortest way out of an overlap leads to the far side. (3.2)
inline constexpr double fast_way = 0.5;

/// [-] A body that would gain more than this share of its kinetic energy by turning about a fixed axis is moved by itself. Reason:
/// cubes gain nothing; a rod a hundred times as long as thick gains thirty times what it has. (6.2)
inline constexpr double carried_gain = 0.01;

/// [-] How much further than its spring a point goes in an iteration. Reason: 1.5 to 1.8 save a third of the iterations; 2 would
/// never end. (6.3.1)
inline constexpr double admm_relaxation = 1.6;

/// [-] Multiplications for each body up to which an island's matrix is factored. Reason: a pyramid of 204 boxes in space needs a
/// quarter of it; a pile of a thousand more, and sweeps have to do. (6.3.1)
inline constexpr double max_factor_work = 2e5;

/// [-] Multiplications of a factorization above which a quiet island is swept, as long as that holds it up. Reason: a pyramid of
/// 204 boxes in space needs 4e6, a wall of 400 bricks less; a heap of a thousand cubes needs 2e7, and 0.2 s for a step. (6.3.1)
inline constexpr double quiet_factor_work = 1e7;

/// [-] Change of velocities in the last sweep, as a share of g dt, up to which sweeps hold such an island. Reason: in heaps of a
/// thousand cubes that become quiet it is at most 0.34; in walls that start without impulses it is 0.7 to 1.6. (6.3.1)
inline constexpr double fair_quiet_residual = 0.5;

/// [-] Overlap that is repaired, as a share of the shortest edge. Reason: bodies that sink as slowly as counts as settled stay
/// within the slop so, which is 1e-5. (4.4)
inline constexpr double repair_start = 0.98e-5;

/// [-] Share of the overlap that goes in a step. Reason: a millimetre is gone in half a second without being seen to go. (4.4)
inline constexpr double repair_share = 0.2;

// --- sweeps over an island -----------------------------------------------------------------------

/// [-] Bodies of a small island, at most. Reason: up to here it costs little to solve one well, whatever moves in it. (6.3.1)
inline constexpr int small_island = 20;

/// [-] Sweeps over a small island, at least. Reason: as for small_island. (6.3.1)
inline constexpr int small_island_sweeps = 50;

/// [-] Friction and pressure in turn in a patch of a small island in the first two sweeps, at most; later in all its patches
/// together. Reason: a sweep that settles the island is the last one, and a single box takes half of the time. (6.3.1)
inline constexpr int first_patch_iterations = 20;

/// [-] Friction and pressure in turn within a patch. Reason: the next sweep goes on. With twenty in each sweep over a small island
/// random worlds take half as long again, and end no better. (6.3.1)
inline constexpr int patch_iterations = 2;

/// [-] The same in a large island that moves fast. Reason: it changes before the last digits matter. (6.3.1)
inline constexpr int fast_patch_iterations = 1;

/// [-] Approach that sweeps may leave in slow patches of an island that moves, as a share of g dt. Reason: of 1, 0.3, 0.1 and 0.03
/// the largest with which a tower keeps its height while a block is pulled out of it. (6.3.1)
inline constexpr double slow_approach = 0.03;

/// [-] Impulses that add energy are scaled back, to this share at least; others are swept on, and dropped if that fails.
/// Reason: of 0.99, 0.9 and 0.7 the largest with which no tower sinks while a block is pulled out. (6.3.1)
inline constexpr double least_share = 0.9;

/// [-] Swept impulses are discarded if the work of those that push bodies apart exceeds this share of the energy of the island's
/// change of velocity. Reason: rows of 20 to 60 boxes that are hit move at one speed to 5 %; with 1 to 28 %, with 0.1 piles
/// overlap by a quarter more. (6.3.1)
inline constexpr double work_apart = 0.3;

/// [-] Each body counts in that energy as if it had changed by this share of g dt besides. Reason: at rest both are rounding.
/// (6.3.1)
inline constexpr double work_apart_floor = 0.1;

/// [-] Steps after an impact in which that may be done. Reason: of 1, 4, 20 and 100 the one with which rows that are hit move as
/// with no limit. Cards that slide on each other would lose their friction in each step. (6.3.1)
inline constexpr int steps_after_impact = 100;

/// [-] Times that a step looks for pairs that its impulses push together, at most. Reason: an impact goes on through a row of
/// twenty bodies, as many as a small island has. (6.3.1)
inline constexpr int rounds_of_missed = 20;

/// [-] Sweeps that follow where impulses have added energy, at most. Reason: of 12 and 50 the one with which fewer pairs of
/// 125 cubes that fall together go into each other; it is rarely needed. (6.3.1)
inline constexpr int sweeps_after_gain = 50;

/// [-] Sweeps over a large island much of which moves, at most. Reason: of 6, 12, 24 and 50 the one after which 125 cubes that fall
/// together overlap no less with more. (6.3.1)
inline constexpr int loose_sweeps = 24;

/// [-] Sweeps over a large island little of which moves, at most. Reason: a floor of 400 tiles that carries a slider needs 22 on
/// average and 46 at most, a third of the cost of the direct solver. (6.3.1)
inline constexpr int steady_sweeps = 100;

/// [-] Sweeps after which it is seen whether they converge. Reason: down and up, twice. (6.3.1)
inline constexpr int sweeps_to_halve = 4;

/// [-] Way by which bodies of an island may sink into each other in a step, as a share of the shortest edge, before the direct
/// solver is tried. Reason: of 0.003, 0.01 and 0.03 the one that 125 falling cubes never reach. (6.3.1)
inline constexpr double deep_sinking = 0.03;

/// [-] Overlap at the end of the step, as a share of the shortest edge, beyond which the normal impulses of a small island are
/// solved for by themselves. Reason: no small island that is solved well comes to it. (6.3.1)
inline constexpr double small_island_overlap = 0.003;

/// [-] The same for a large island. Reason: equal cubes that fall together hardly come to it. Half of the random worlds of 2 to 30
/// boxes that ended with an overlap above 1 % were such islands, with masses that differ by thousands. (6.3.1)
inline constexpr double large_island_overlap = 0.007;

/// [-] Sweeps that a Newton step counts as, where the work on a large island in motion is bounded. Reason: it takes as long, for
/// thirty bodies. (6.3.1)
inline constexpr int newton_step_sweeps = 10;

/// [-] Way by which bodies sink into each other in a step, as a share of the shortest edge, from which on that counts. Reason:
/// overlap from before is there although nothing sinks. (6.3.1)
inline constexpr double sinking_that_counts = 1e-3;

/// [-] Sweeps over an island much of which moves end below this share of g dt. Reason: it changes before the last digits matter.
/// (6.3.1)
inline constexpr double loose_residual = 0.01;

/// [-] Sweeps are converging if the second one corrects less than this share of the first. Reason: one or two more are enough then.
/// (6.3.1)
inline constexpr double sweeps_converging = 0.05;

/// [-] Solving stops at this share of the negligible residual (contact_settled). Reason: a margin, so that the impulses are good
/// enough for the next step too. (6.3.1)
inline constexpr double solved_residual = 0.1;

/// [-] The same in a small island, and for the direct solver in a quiet one. Reason: rounding must not decide. (6.3.1)
inline constexpr double solved_residual_exact = 1e-3;

/// [-] Multiple of the negligible residual at which sweeps may end without the direct solver. Reason: as far as sweeps get where
/// patches slide. (6.3.1)
inline constexpr double fair_residual = 100.0;

/// [-] Multiple of the negligible residual beyond which sweeps have diverged. Reason: light boxes under a heavy one are thrown
/// about, and their impulses are a bad start for the direct solver. (6.3.1)
inline constexpr double diverged_residual = 1e6;

// --- direct solver -------------------------------------------------------------------------------

/// [-] Multiple of the option's ADMM iterations for a small island. Reason: they are cheap there. (6.3.1)
inline constexpr int small_island_iterations = 3;

/// [-] Multiple of the option's ADMM iterations that follow Newton steps that have failed, where masses are unequal or friction is
/// above newton_steepest_friction. Reason: with 3 planks carry a load of 200 times their mass, with 7 one of 500 times. (6.3.1)
inline constexpr int more_iterations = 7;

/// [-] Ratio of masses from which they follow. Reason: equal boxes are solved no better by them, and piles cost a tenth more. (6.3.1)
inline constexpr double unequal_masses = 10.0;

/// [-] Error of velocities at which ADMM ends in a large island in which anything moves, as a share of g dt. Reason: of 0.01 and
/// 0.003 the larger one with which a tower on a sled keeps its height to 1 mm. (6.3.1)
inline constexpr double moving_residual = 0.003;

/// [-] Newton steps in a small island, at most. Reason: it must be solved in this step. (6.3.1)
inline constexpr int small_newton_steps = 50;

/// [-] Newton steps in a quiet island, at most. Reason: each factors a large matrix; the next step goes on. (6.3.1)
inline constexpr int quiet_newton_steps = 20;

/// [-] Multiple of the negligible residual up to which a quiet island counts as nearly solved, and Newton steps are tried before
/// ADMM. Reason: up to here a heap of 1000 needs no more of them than after ADMM, or twice as many. (6.3.1)
inline constexpr double nearly_solved = 1000.0;

/// [-] Multiple of the negligible residual at which Newton steps in balance end in a quiet island. Reason: a second update rarely
/// halves it, and the next step goes on. (6.3.1)
inline constexpr double good_residual = 10.0;

/// [-] Updates of impulses and shifts in a quiet island, at most. Reason: the next step goes on. (6.3.1)
inline constexpr int quiet_shift_updates = 3;

/// [-] ADMM iterations between two adjustments of the stiffness. Reason: each costs a factorization. (6.3.1)
inline constexpr int stiffness_interval = 8;

/// [-] ADMM iterations that must be left for an adjustment of the stiffness. Reason: as above. (6.3.1)
inline constexpr int stiffness_last = 4;

/// [-] Square root of the ratio of primal and dual residual at which the stiffness is adjusted. Reason: Boyd et al. 2011, section
/// 3.4.1, take ten for the ratio itself. (6.3.1)
inline constexpr double residuals_unbalanced = 3.0;

/// [-] Change of the stiffness in one adjustment, at most. Reason: residuals far from the solution mislead. (6.3.1)
inline constexpr double stiffness_change = 10.0;

/// [-] Lowest stiffness of the springs, as a multiple of the mass that a point resists with. Reason: softer ones hardly act.
/// (6.3.1)
inline constexpr double admm_min_stiffness = 0.1;

/// [-] Multiple of the residual after the first ADMM iteration beyond which the iterations have diverged. Reason: the shift of
/// sliding points is found by substitution, which diverges for large friction or mass ratios. (6.3.1)
inline constexpr double admm_diverged = 10.0;

/// [-] Share of the way to its bound that friction above newton_steepest_friction of a sliding point goes in an iteration of ADMM.
/// Reason: at 1 the iterations swing for a fifth of edges that hit the ground at a friction of 2, at 0.3 for a few, at 0.2 and 0.1
/// for none. (6.3.1)
inline constexpr double steep_friction_share = 0.2;

/// [-] Friction beyond which Newton steps are not tried. Reason: shifts that follow the sliding diverge. (6.3.1)
inline constexpr double newton_steepest_friction = 1.0;

/// [-] Newton steps before impulses and shifts are updated; without balance by then they end. Reason: 64 cubes that begin
/// to slide as one need 19 for the first balance. (6.3.1)
inline constexpr int newton_steps_in_a_row = 20;

/// [-] Share of the allowed residual at which springs and bodies are in balance. Reason: the remainder must not count against the
/// updates. (6.3.1)
inline constexpr double newton_balanced = 0.01;

/// [-] A result of Newton steps that have not converged is taken if its residual is below this share of the one before them.
/// Reason: a clear gain, not chance. (6.3.1)
inline constexpr double newton_improved = 0.1;

// --- restitution and overlap ---------------------------------------------------------------------

/// [-] Sweeps of the overlap correction over a large island that moves fast, at most. Reason: it makes new overlap in each step.
/// (4.4)
inline constexpr int fast_correction_sweeps = 10;

/// [-] The overlap correction ends at a displacement below this share of its largest one. Reason: a step corrects a fifth of the
/// overlap anyway. (4.4)
inline constexpr double correction_converged = 0.05;

}  // namespace tumble::tolerance
