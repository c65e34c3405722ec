/// \file
/// \brief The small numbers of the chapters, in the form of those of the layers; include
///        `tumble/base/tolerance.hpp`, which has both.
#pragma once

namespace tumble::tolerance {

// --- analytic_lcp -------------------------------------------------------------------------

/// [-] The inverse of a basis is made anew once a correction exceeds this share of the sum of its
/// terms' sizes. Reason: a correction squares the relative error, so that half of the digits are
/// enough to get all. (3.3.1)
inline constexpr double lost_digits = 1e-8;

/// [-] A residual above this, with A alone, makes the factors of A be used. Reason: a tenth of what
/// solvers are compared at; problems of some thirty contacts leave 1e-11. (3.3.1)
inline constexpr double lost_in_A = 1e-10;

/// [m/s²] Contacts that sink no faster are left alone, in the form of the method that the thesis
/// describes. Reason: the thesis's own number; it fits boxes of a metre under gravity. (3.3.1)
inline constexpr double sinking = 1e-5;

/// [-] Residual at which Gauss-Seidel sweeps stop. Reason: 1e-8 m/s² under gravity moves 2 cm in half
/// an hour; each digit more costs as many sweeps as the one before. (3.3.1)
inline constexpr double gauss_seidel_residual = 1e-9;

/// [-] Constraints contradict each other if the nearest point of their cone is closer than this to
/// the target, which is 1 away from its tip. Reason: contradiction leaves rounding, and this far,
/// accelerations would be a million times those that any constraint asks for alone: a thousand times
/// more than a box of a ton on one of a gram. (2.6.2)
inline constexpr double contradiction = 1e-6;

/// [-] Residual at which the method of multipliers stops. Reason: a hundredth of what is asked for of an
/// exact solver, and a hundred times the rounding of a pile of a thousand contacts. (3.3.1)
inline constexpr double multiplier_residual = 1e-12;

/// [-] Softness of the springs that stand for contacts, for rows scaled to A_ii = 1. Reason: a round
/// of the method takes the error to this share over the smallest eigenvalue of the contacts that
/// push, to about 1e-3 for a stack of thirty, and leaves as many digits for rounding. (3.3.1)
inline constexpr double contact_softness = 1e-6;

/// [-] Springs get no harder. Reason: rounding of 2e-16 in sums of a few hundred rows stays well below
/// it, so that the matrix stays positive definite. (3.3.1)
inline constexpr double least_softness = 1e-12;

/// [-] A round that leaves more than this share of the error is slow, and the springs' softness gets
/// the next factor. Reason: two factorisations cost about as much as ten rounds without one. (3.3.1)
inline constexpr double slow_round = 0.1;

/// [-] What a slow round does to the softness. Reason: three steps lead to the hardest springs. (3.3.1)
inline constexpr double hardening = 0.01;

/// [-] Springs and masses are in balance if what is left is below this share of the accelerations
/// that are wrong. Reason: what is left is mended by the next round, and rounds without a change of
/// the set gain three digits anyhow. (3.3.1)
inline constexpr double balance = 1e-4;

/// [-] Residual above which no answer counts as solved, even if rounding allows no smaller one. Reason: a
/// micrometre per second for an impact at 1 m/s; it takes forces a thousand million times those
/// that one contact asks for. (3.3.1)
inline constexpr double usable_residual = 1e-6;

/// [-] How far surfaces may be apart and still have a contact force between them, as a share of the
/// shortest edge of the smaller body. Reason: rounding and the step's error part resting bodies by a
/// tenth of it; nobody sees a ten-thousandth. (3.3.1)
inline constexpr double contact_margin = 1e-4;

/// [-] A contact point rests if it approaches or parts slower than this share of sqrt(g L): 3 mm/s
/// for a box of 1 m. Reason: gravity ends such a hop in 0.6 ms and half a micrometre up, and the error
/// of a step is a tenth of it; a rebound has to be faster, 1/50 of the sticky speed. (3.3.1)
inline constexpr double resting_speed = 1e-3;

/// [-] The same where there is no gravity, as a share of L / dt. Reason: a tenth of the sticky speed
/// there. (3.3.1)
inline constexpr double resting_speed_weightless = 1e-5;

/// [-] Below this share of the resting speed a point with friction does not slide: friction may stop
/// it. Reason: the error of a step leaves a hundredth of the resting speed where a point should
/// stick. (2.6.3)
inline constexpr double sliding_share = 0.1;

/// [-] A point that would accelerate across its normal by less than this share of what the contacts
/// resist needs no friction to stick. Reason: it keeps speeds across below 2e-8 m/s, and saves nearly
/// every solution with friction of a stack at rest. (2.6.3)
inline constexpr double creep = 1e-7;

/// [-] Residual up to which contact forces are used. Reason: the form of the method that the thesis
/// describes leaves 1e-5 m/s², a tenth of it; in 1/60 s it makes 2 micrometres per second. (3.3.1)
inline constexpr double force_residual = 1e-5;

/// [-] How fast a gap between resting surfaces is closed: at the margin with this share of the resting
/// speed. Reason: half of it keeps the point at rest, and a gap is a third of itself after 0.07 s for a
/// box of 1 m. (3.3.1)
inline constexpr double closing = 0.5;

/// [-] Bodies whose points move by less than this share of an edge in a step stay where they are as
/// far as forces are concerned. Reason: forces change by as much, and are solved to 1e-11. (3.3.1)
inline constexpr double motionless = 1e-9;

/// [-] How far unknowns of a contact problem with friction may fall below 0 on the way, as a share of
/// max |b|. Reason: boxes that have turned by 1e-9 have rows that depend on each other to as much, and
/// a hundredth of what is accepted as an error is left to a hundred pivots. (2.6.3)
inline constexpr double slack = 1e-10;

/// [-] Error of the velocities at the end of a time step, as a share of the fastest point of the island,
/// up to which they are accepted. Reason: rows that nearly depend on each other leave 1e-8; this
/// much is 2 nm in 1/60 s at 1 m/s. (2.6.3)
inline constexpr double step_residual = 1e-7;

/// [-] What slides more slowly at the end of a time step, as a share of the fastest point of the island,
/// needs no friction. Reason: rounding in a heap at rest is 1e-13; at 0.16 m/s, gravity's share of
/// 1/60 s, this is 5 mm in a year. (2.6.3)
inline constexpr double step_sliding = 1e-9;

/// [-] By which part a contact point yields too much to its own push while rows that nearly depend on
/// each other are kept apart. Reason: far above rounding, and two rounds of the remedy leave its square
/// as the error. (2.6.3)
inline constexpr double compliance = 1e-6;

// --- impulse_damped -----------------------------------------------------------------------

/// [-] ε1: a push out of another body, as a share of L. Reason: 1 mm for a box of 1 m is not seen,
/// and the deepest overlap of a fall through one step, 3 mm, takes three. (4.4)
inline constexpr double damped_push = 1e-3;

/// [rad] ε2: a face counts as across gravity. Reason: 2 degrees; what leans on a neighbour leans by
/// more, what lies on three corners by less. (5.3)
inline constexpr double damped_aligned = 0.035;

/// [-] ε3: vertical momentum that an aligned box loses, as a share of m sqrt(gL). Reason: 6 cm/s
/// for 1 m, which contacts in a heap leave of the 16 cm/s that gravity gives in a step; far enough
/// below that nothing hangs on a wall, with twice as much too. (5.3)
inline constexpr double damped_settled = 0.02;

/// [rad] ε4: by how much an aligned box is turned upright in a step. Reason: turning about the
/// centre lifts a corner of a cube by 0.7 of it, which must stay below the millimetre of a push.
/// (5.3)
inline constexpr double damped_tilt = 1e-3;

/// [-] ε5: a slow component of momentum, as a share of m sqrt(gL). Reason: 30 cm/s for 1 m, what
/// two steps of gravity give; boxes of an unsettled heap jump at this speed. (5.3)
inline constexpr double damped_slow = 0.1;

/// [-] ε6: one that is none. Reason: as for ε3. (5.3)
inline constexpr double damped_still = 0.02;

/// [-] ε7: a slow component of angular momentum, as a share of m L sqrt(gL). Reason: corners of a
/// cube then move at a quarter of sqrt(gL), and of an unsettled heap about as fast. (5.3)
inline constexpr double damped_slow_spin = 0.05;

/// [-] ε8: one that is none. Reason: gravity gives a cube as much in a step if its centre is 4 % of
/// L beyond the edge that it stands on: below that it balances. (5.3)
inline constexpr double damped_still_spin = 2e-3;

/// [-] ε9: upward momentum that is none, as a share of m sqrt(gL). Reason: as for ε3; a hop of that
/// speed ends within half a step. (5.3)
inline constexpr double damped_rising = 0.02;

/// [-] ε10: a move in a step that is undone, as a share of L. Reason: 3 cm/s for 1 m; a box let go
/// falls five times as far in its first step. (5.3)
inline constexpr double damped_frozen = 5e-4;

/// [rad] ε11: a turn in a step that is undone with it. Reason: moves a corner as far as ε10. (5.3)
inline constexpr double damped_frozen_angle = 5e-4;

/// [-] k1: what a step in contact leaves of momentum. Reason: slows 1 m/s by 4.8 m/s², as a
/// coefficient of friction of 0.5 would. (5.3)
inline constexpr double damped_momentum_factor = 0.92;

/// [-] k2: ditto of angular momentum. Reason: equal to k1, so that a box that turns about an edge
/// keeps it. (5.3)
inline constexpr double damped_spin_factor = 0.92;

/// [-] k3: ditto of angular momentum of an aligned box that has settled. Reason: a tenth is left
/// after 0.06 s, before a viewer sees it rock twice. (5.3)
inline constexpr double damped_settled_spin_factor = 0.5;

/// [-] k5: ditto of slow components of momentum. Reason: the more is left in each step, the longer a heap
/// shakes; less than half ends what is not slow any more within a step or two. (5.3)
inline constexpr double damped_slow_factor = 0.5;

/// [-] k7: ditto of slow components of angular momentum. Reason: as for k5. (5.3)
inline constexpr double damped_slow_spin_factor = 0.5;

/// [-] Collisions faster than this share of sqrt(gL) are varied at random. Reason: 1.6 m/s for a
/// box of 1 m, the fall from an eighth of its height; a box that rocks to rest is slower. (4.2)
inline constexpr double noisy_speed = 0.5;

/// [rad] Standard deviation of the angle by which the normal of a fast collision is turned. Reason:
/// 3 degrees, the roughness of real dice and tables; a bounce straight up ends a tenth of its
/// height to the side. (4.2)
inline constexpr double noisy_normal = 0.05;

/// [-] Half the range by which the restitution of a fast collision is varied. Reason: measured
/// bounces of one die vary by about a tenth. (4.2)
inline constexpr double noisy_restitution = 0.1;

/// [-] An approach slower than this share of a pair's shortest edge in a step is none. Reason: rounding
/// of velocities of metres per second is 1e-16, and at 1 m and 1/60 s a body goes on at 6e-13 m/s, two
/// centimetres in a thousand years. (2.5.2)
inline constexpr double impulse_approach = 1e-16;

/// [-] What each point of a contact area weighs in its centre besides its depth, as a share of the
/// pair's shortest edge. Reason: an area that just touches has the plain centre, whatever rounding makes
/// of its depths; against a depth that is seen it counts for nothing. (2.5.2)
inline constexpr double impulse_even = 1e-9;

/// [-] Overlap and gap of bodies at rest, as a share of the shortest edge of the two. Reason: 10
/// micrometres for a metre is seen by nobody and far above rounding, so that a contact stays one. (6.3.1)
inline constexpr double contact_damped_slop = 1e-5;

/// [-] Bodies that are as near as this share of the shortest edge touch, whatever their speed. Reason: a
/// corner that hangs a millimetre over its support belongs to the area that carries the box. (6.3.1)
inline constexpr double kept_margin = 1e-3;

/// [-] A contact area is kept while neither body has moved by more than this share of an edge, or
/// turned by as many radians. Reason: lever arms are wrong by as much, and gaps by its square. (6.3.1)
inline constexpr double kept_motion = 1e-6;

/// [-] A heap is left as it is if the impulses of the step before leave no velocity wrong by more than this
/// share of g dt. Reason: 1.6e-6 m/s at 60 Hz is a tenth of a millimetre in a minute, if it always went
/// the same way. (6.3.1)
inline constexpr double contact_settled = 1e-5;

/// [-] A heap with a point faster than this share of sqrt(g L) moves too fast to be solved as a whole. Reason:
/// at 1.6 m/s and 1 m a step is 3 cm, and nobody sees micrometres; boxes of a wall that lands from
/// a millimetre are slower. (6.3.1)
inline constexpr double calm_speed = 0.5;

/// [-] sqrt(g L) where there is no gravity, as a share of L / dt. Reason: at 60 Hz and 1 m the same. (6.3.1)
inline constexpr double weightless_unit = 0.05;

/// [-] A heap slower than this share of sqrt(g L) hardly moves. Reason: a wall that lands at 0.3 m/s
/// needs all rounds; at a tenth of it few hold it. (6.3.1)
inline constexpr double quiet_speed = 0.01;

/// [-] The same where there is no gravity: the speed scale as a share of L / dt. Reason: gravity moves a
/// metre's box at 60 Hz by about as much, 0.3 % of it in a step. (6.3.1)
inline constexpr double weightless_speed = 3e-3;

/// [-] Springs of the direct solver, as a multiple of the mass that a point resists with. Reason: of 10,
/// 30, 100, 300 and 1000 the one with the fewest rounds for stacks, pyramids and walls that land. (6.3.1)
inline constexpr double island_stiffness = 100.0;

/// [-] Springs of the direct solver at their hardest, as a multiple of the mass that a point resists with.
/// Reason: half of the digits are left for what they solve. (6.3.1)
inline constexpr double island_hardness = 1e6;

/// [-] Springs that Newton's steps of the direct solver keep in balance, ditto. Reason: of 1e3, 1e4 and 1e5 the
/// one with which scenes turned about the vertical stay closest. Harder ones enlarge the rounding of
/// velocities in impulses that nothing else determines, softer ones take too many steps. (6.3.1)
inline constexpr double island_polish = 1e4;

/// [-] Steps that friction of a body's own weight would need to stop what counts as sliding. Reason: at four
/// the direction of the slide hardly changes within a step. (6.3.1)
inline constexpr double island_slides = 4.0;

/// [rad] Turn in a step beyond which the way of a point by rotation is taken along its arc. Reason: up to
/// here the tangent is off by less than an eighth of the way. (6.3.1)
inline constexpr double fast_turn = 0.5;

/// [-] Growth of a pair's reach at which a kept area is looked for again. Reason: at rest it does not
/// change; a push changes it by more. (3.2)
inline constexpr double kept_reach = 2.0;

/// [-] How much further than its spring a point goes in a round. Reason: 1.5 to 1.8 save a third of the
/// rounds; 2 would never end. (6.3.1)
inline constexpr double island_relaxation = 1.6;

/// [-] Multiplications for each body up to which a heap's matrix is factored. Reason: a pyramid of 204
/// boxes in space needs a quarter of it; a pile of a thousand more, and sweeps have to do. (6.3.1)
inline constexpr double island_work = 2e5;

/// [-] Overlap that repair leaves, as a share of the shortest edge. Reason: below the slop, so that a
/// repaired area is not looked at again for a rounding. (4.4)
inline constexpr double repair_rest = 0.9e-5;

/// [-] Share of the overlap that goes in a step. Reason: a millimetre is gone in half a second without
/// being seen to go. (4.4)
inline constexpr double repair_share = 0.2;

}  // namespace tumble::tolerance
