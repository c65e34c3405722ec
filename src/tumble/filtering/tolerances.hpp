/// \file
/// \brief The small numbers of `filtering`.
#pragma once

namespace tumble::tolerance {

// --- filtering ----------------------------------------------------------------------------

/// [-] By how much of a display frame a step may end before the frame and still show it. Reason: times
/// are sums of steps and carry rounding; a millionth of a frame is 17 ns. (3.3.2)
inline constexpr double frame_slack = 1e-6;

/// [-] By what share of it the time between two frames may differ from the first one. Reason: times
/// are sums of steps, and carry 1e-9 of a step after a million of them; a step that a user cut is
/// shorter by more. (5.5)
inline constexpr double equal_spacing = 1e-6;

/// [-] How far two near bodies may move against each other in an adaptive sub-step, as a share of the
/// thinner one's shortest edge. Reason: overlap is pushed out on the side where it is shallower, and
/// half of the thickness is the last place where this is the right one; two fifths of it leave room
/// for what is not yet known of the step. (6.3.1)
inline constexpr double adaptive_movement = 0.2;

/// [rad] How far a near body may turn in such a sub-step. Reason: the end of an arc is half a percent
/// longer than its tangent at 0.1 rad. (6.3.1)
inline constexpr double adaptive_turn = 0.1;

/// [-] Overlap that asks for smaller steps, over the shortest edge. Reason: a tenth of the movement that
/// is allowed, and well above gravity's share of a step of 1/60 s at 1 m, 0.003. (6.3.1)
inline constexpr double adaptive_overlap = 0.02;

/// [-] Way there and back of a corner that asks for smaller steps, over the shortest edge. Reason: half
/// of the amplitude of a thousandth from which on a body counts as chattering. (6.3.1)
inline constexpr double adaptive_shake = 5e-4;

/// [-] By what share of the interval a recorded frame may be off the times of a grid and still be one
/// of its frames. Reason: a quarter of tolerance::equal_spacing, since the time between two frames that
/// are off, against that between the first two, is off by three times as much. (5.5)
inline constexpr double on_the_grid = 2.5e-7;

/// [-] How far a body's corners may get from their first places within a detector's window for it to
/// rest, over the shortest edge. Reason: a tenth of the amplitude from which on chatter counts as
/// seen; at 1 m a creep of 0.25 mm/s. (6.3.1)
inline constexpr double rest_excursion = 1e-4;

/// [-] Least swing of a body that is classified as chattering, over the shortest edge. Reason: the same
/// length; what shakes by less is classified as resting if it does not go anywhere. (6.3.1)
inline constexpr double chatter_swing = 1e-4;

/// [-] Largest drift of a body that is classified as chattering, as a speed over sqrt(g L). Reason: 16 mm/s
/// at 1 m; at 20 mm/s a body gets a hundredth of its edge in half a second, and does not rest. (6.3.1)
inline constexpr double chatter_drift = 0.005;

/// [-] Largest mean speed along its path of a body that is classified as chattering, over sqrt(g L). Reason:
/// 0.3 m/s at 1 m, twice the speed that gravity gives in 1/60 s. (6.3.1)
inline constexpr double chatter_speed = 0.1;

/// [-] Least swing of a body that is classified as chattering, in ways that it drifts within the window.
/// Reason: chosen by the runs with seeds 1 to 4 of claim 6.3.1c: above it chatter is missed, and below it
/// nothing is gained. (6.3.1)
inline constexpr double chatter_share = 0.15;

/// [-] Least share of the frames in which a chattering body is in contact. Reason: it hops, and
/// what hops is in the air every other frame at most. (6.3.1)
inline constexpr double chatter_contact = 0.5;

}  // namespace tumble::tolerance
