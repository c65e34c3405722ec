/// \file
/// \brief The small numbers of `filtering`.
#pragma once

namespace tumble::tolerance {

// --- filtering ----------------------------------------------------------------------------

/// [-] Share of a display frame by which a step may end before the frame and still show it. Reason:
/// times are sums of steps and carry rounding; a millionth of a frame is 17 ns. (3.3.2)
inline constexpr double frame_slack = 1e-6;

/// [-] Relative difference allowed between the interval of two frames and the first interval. Reason:
/// times are sums of steps, and carry 1e-9 of a step after a million of them; a last step cut at a
/// run's duration is shorter by more. (5.5)
inline constexpr double equal_spacing = 1e-6;

/// [-] Largest relative displacement of two near bodies in an adaptive sub-step, as a share of the
/// thinner one's shortest edge. Reason: overlap is repaired on its shallower side, which is the correct
/// one up to half of the thickness; two fifths of that leave a margin for the uncertainty of the
/// prediction. (6.3.1)
inline constexpr double adaptive_movement = 0.2;

/// [rad] Largest rotation of a near body in such a sub-step. Reason: the end of an arc is half a percent
/// longer than its tangent at 0.1 rad. (6.3.1)
inline constexpr double adaptive_turn = 0.1;

/// [-] Overlap that requests smaller steps, over the shortest edge. Reason: a tenth of the movement that
/// is allowed, and well above gravity's share of a step of 1/60 s at 1 m, 0.003. (6.3.1)
inline constexpr double adaptive_overlap = 0.02;

/// [-] Reversal of a corner that requests smaller steps, over the shortest edge. Reason: half of the
/// amplitude from which on a body counts as chattering, a thousandth. (6.3.1)
inline constexpr double adaptive_shake = 5e-4;

/// [-] Largest displacement of a resting body's corners from their first places in a detector's window,
/// over the shortest edge. Reason: a tenth of the amplitude at which chatter becomes visible; at 1 m a
/// creep of 0.25 mm/s. (6.3.1)
inline constexpr double rest_excursion = 1e-4;

/// [-] Least swing of a body that is classified as chattering, over the shortest edge. Reason: the same
/// length; a smaller motion is classified as resting if the body does not drift. (6.3.1)
inline constexpr double chatter_swing = 1e-4;

/// [-] Largest drift of a body that is classified as chattering, as a speed over sqrt(g L). Reason: 16 mm/s
/// at 1 m; at 20 mm/s a body moves by a hundredth of its edge in half a second, and does not rest. (6.3.1)
inline constexpr double chatter_drift = 0.005;

/// [-] Largest mean speed along its path of a body that is classified as chattering, over sqrt(g L). Reason:
/// 0.3 m/s at 1 m, twice the speed that gravity gives in 1/60 s. (6.3.1)
inline constexpr double chatter_speed = 0.1;

/// [-] Least ratio of swing to drift of a body that is classified as chattering. Reason: chosen by the runs
/// with seeds 1 to 4 of claim 6.3.1c: higher values miss chatter, lower ones bring no gain. (6.3.1)
inline constexpr double chatter_share = 0.15;

/// [-] Least share of the frames in which a chattering body is in contact. Reason: a hopping body is in
/// the air in every other frame at most. (6.3.1)
inline constexpr double chatter_contact = 0.5;

}  // namespace tumble::tolerance
