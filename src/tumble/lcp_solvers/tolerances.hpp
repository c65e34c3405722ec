/// \file
/// \brief The small numbers of `lcp_solvers`.
#pragma once

namespace tumble::tolerance {

// --- lcp_solvers --------------------------------------------------------------------------

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

/// [-] Residual at which the method of multipliers stops. Reason: a hundredth of the
/// residual asked of an exact solver, and a hundred times the rounding of a pile of a thousand contacts. (3.3.1)
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

/// [-] Springs and masses are in balance if their imbalance is below this share of the accelerations
/// that are wrong. Reason: the next round corrects the rest, and rounds without a change of
/// the set gain three digits anyhow. (3.3.1)
inline constexpr double balance = 1e-4;

/// [-] Residual above which no answer counts as solved, even if rounding allows no smaller one. Reason: a
/// micrometre per second for an impact at 1 m/s; it takes forces a thousand million times those
/// that one contact asks for. (3.3.1)
inline constexpr double usable_residual = 1e-6;

/// [-] Residual of the least violation up to which a problem is called inconsistent and its forces are
/// usable, and above which it is called infeasible. Reason: a millimetre per second for an impact at
/// 1 m/s; measured systems contradict themselves by 1e-10 to 1e-6. (3.3.1)
inline constexpr double inconsistent = 1e-3;

/// [-] Softness of the rounds towards the least violation, for rows scaled to A_ii = 1. Reason: half of the
/// digits; a round takes the error to this share over the smallest eigenvalue of the contacts that
/// push. (3.3.1)
inline constexpr double proximal_softness = 1e-8;

/// [-] Forces A_ii f_i above this share of max |b| may be due to a slight contradiction, and are compared
/// with those of the least violation. Reason: a stack of fifty boxes; more is seldom due to load. (3.3.1)
inline constexpr double large_forces = 100.0;

}  // namespace tumble::tolerance
