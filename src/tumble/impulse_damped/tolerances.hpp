/// \file
/// \brief The small numbers of `impulse_damped`.
#pragma once

namespace tumble::tolerance {

// --- impulse_damped -----------------------------------------------------------------------

/// [-] A body that is carried is predicted anew if what carries it has moved it by more than this share of
/// its shortest edge. Reason: rounding of a few metres is 1e-15; what rests is not looked at again. (6.2)
inline constexpr double carried_again = 1e-14;

/// [-] ε1: a push out of another body, as a share of L. Reason: 1 mm for a box of 1 m is not seen,
/// and the deepest overlap of a fall through one step, 3 mm, takes three. (4.4)
inline constexpr double damped_push = 1e-3;

/// [rad] ε2: a face counts as across gravity. Reason: 2 degrees; what leans on a neighbour leans by
/// more, what lies on three corners by less. (5.3)
inline constexpr double damped_aligned = 0.035;

/// [-] ε3: vertical momentum that an aligned box loses, as a share of m sqrt(gL). Reason: 6 cm/s
/// for 1 m, which contacts in a pile leave of the 16 cm/s that gravity gives in a step; far enough
/// below that nothing hangs on a wall, with twice as much too. (5.3)
inline constexpr double damped_settled = 0.02;

/// [rad] ε4: by how much an aligned box is turned upright in a step. Reason: turning about the
/// centre lifts a corner of a cube by 0.7 of it, which must stay below the millimetre of a push.
/// (5.3)
inline constexpr double damped_tilt = 1e-3;

/// [-] ε5: a slow component of momentum, as a share of m sqrt(gL). Reason: 30 cm/s for 1 m, what
/// two steps of gravity give; boxes of an unsettled pile jump at this speed. (5.3)
inline constexpr double damped_slow = 0.1;

/// [-] ε6: one that is none. Reason: as for ε3. (5.3)
inline constexpr double damped_still = 0.02;

/// [-] ε7: a slow component of angular momentum, as a share of m L sqrt(gL). Reason: corners of a
/// cube then move at a quarter of sqrt(gL), and of an unsettled pile about as fast. (5.3)
inline constexpr double damped_slow_spin = 0.05;

/// [-] ε8: one that is none. Reason: gravity gives a cube as much in a step if its centre is 4 % of
/// L beyond the edge that it stands on: below that it balances. (5.3)
inline constexpr double damped_still_spin = 2e-3;

/// [-] ε9: upward momentum that is none, as a share of m sqrt(gL). Reason: as for ε3; a hop of that
/// speed ends within half a step. (5.3)
inline constexpr double damped_rising = 0.02;

/// [-] ε10: a move in a step that is undone, as a share of L. Reason: 3 cm/s for 1 m; a released box
/// falls five times as far in its first step. (5.3)
inline constexpr double damped_frozen = 5e-4;

/// [rad] ε11: a turn in a step that is undone with it. Reason: moves a corner as far as ε10. (5.3)
inline constexpr double damped_frozen_angle = 5e-4;

/// [-] ε3, ε6 and ε8 are shares of at most this many times the momentum that gravity gives in a step. Reason: ε3 is then nine
/// tenths of that, so that nothing hangs on a wall or balances beyond its edge, however large; boxes below 5 m are far from it. (5.3)
inline constexpr double damped_stop = 45.0;

/// [-] ε10 is a share of at most this many times the fall of a first step. Reason: nineteen twentieths of that; boxes of 1 m
/// at 1/60 s are far from it, larger ones and shorter steps would hang in the air. (5.3)
inline constexpr double damped_halt = 1900.0;

/// [-] k1: what a step in contact leaves of momentum. Reason: slows 1 m/s by 4.8 m/s², as a
/// coefficient of friction of 0.5 would. (5.3)
inline constexpr double damped_momentum_factor = 0.92;

/// [-] k2: ditto of angular momentum. Reason: equal to k1, so that a box that turns about an edge
/// keeps it. (5.3)
inline constexpr double damped_spin_factor = 0.92;

/// [-] k3: ditto of angular momentum of an aligned box that has settled. Reason: a tenth is left
/// after 0.06 s, before a viewer sees it rock twice. (5.3)
inline constexpr double damped_settled_spin_factor = 0.5;

/// [-] k5: ditto of slow components of momentum. Reason: the more is left in each step, the longer a pile
/// shakes; less than half ends motion that is not slow any more within a step or two. (5.3)
inline constexpr double damped_slow_factor = 0.5;

/// [-] k7: ditto of slow components of angular momentum. Reason: as for k5. (5.3)
inline constexpr double damped_slow_spin_factor = 0.5;

/// [-] An approach slower than this share of a pair's shortest edge in a step is none. Reason: rounding
/// of velocities of metres per second is 1e-16, and at 1 m and 1/60 s a body goes on at 6e-13 m/s, two
/// centimetres in a thousand years. (2.5.2)
inline constexpr double impulse_approach = 1e-16;

/// [-] What each point of a contact area weighs in its centre besides its depth, and how far apart a point of
/// bodies that overlap may be, as a share of the pair's shortest edge. Reason: an area that just touches has all its
/// points and the plain centre, whatever rounding makes of its depths; against a depth that is seen it counts for
/// nothing. (2.5.2)
inline constexpr double impulse_even = 1e-9;

}  // namespace tumble::tolerance
