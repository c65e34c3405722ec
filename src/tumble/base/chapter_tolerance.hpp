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

}  // namespace tumble::tolerance
