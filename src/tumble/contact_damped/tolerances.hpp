/// \file
/// \brief The small numbers of `contact_damped`.
#pragma once

namespace tumble::tolerance {

// --- contact_damped -----------------------------------------------------------------------

/// [-] Overlap and gap of bodies at rest, as a share of the shortest edge of the two. Reason: 10
/// micrometres for a metre is not seen and far above rounding, so that a contact stays one. (6.3.1)
inline constexpr double contact_damped_slop = 1e-5;

/// [-] Bodies that are as near as this share of the shortest edge touch, whatever their speed. Reason: a
/// corner that hangs a millimetre over its support belongs to the patch that carries the box. (6.3.1)
inline constexpr double kept_margin = 1e-3;

/// [-] A contact patch is kept while neither body has moved by more than this share of an edge, or
/// turned by as many radians. Reason: lever arms are wrong by as much, and gaps by its square. (6.3.1)
inline constexpr double kept_motion = 1e-6;

/// [-] An island is left as it is if the impulses of the step before leave no velocity wrong by more than this
/// share of g dt. Reason: 1.6e-6 m/s at 60 Hz is a tenth of a millimetre in a minute, if it always went
/// the same way. (6.3.1)
inline constexpr double contact_settled = 1e-5;

/// [-] An island with a point faster than this share of sqrt(g L) moves too fast to be solved as a whole.
/// Reason: at 1.6 m/s and 1 m a step is 3 cm, and micrometres are not seen; boxes of a wall that lands
/// from a millimetre are slower. (6.3.1)
inline constexpr double calm_speed = 0.5;

/// [-] sqrt(g L) where there is no gravity, as a share of L / dt. Reason: at 60 Hz and 1 m the same. (6.3.1)
inline constexpr double weightless_unit = 0.05;

/// [-] An island slower than this share of sqrt(g L) hardly moves. Reason: a wall that lands at 0.3 m/s
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

/// [-] Growth of a pair's reach at which a kept patch is looked for again. Reason: at rest it does not
/// change; a push changes it by more. (3.2)
inline constexpr double kept_reach = 2.0;

/// [-] How much further than its spring a point goes in a round. Reason: 1.5 to 1.8 save a third of the
/// rounds; 2 would never end. (6.3.1)
inline constexpr double island_relaxation = 1.6;

/// [-] Multiplications for each body up to which an island's matrix is factored. Reason: a pyramid of 204
/// boxes in space needs a quarter of it; a pile of a thousand more, and sweeps have to do. (6.3.1)
inline constexpr double island_work = 2e5;

/// [-] Overlap that repair leaves, as a share of the shortest edge. Reason: below the slop, so that a
/// repaired patch is not looked at again for a rounding. (4.4)
inline constexpr double repair_rest = 0.9e-5;

/// [-] Share of the overlap that goes in a step. Reason: a millimetre is gone in half a second without
/// being seen to go. (4.4)
inline constexpr double repair_share = 0.2;

/// [-] Turns between friction and pressure in a patch end with one that changes its velocities by less than
/// this share of the largest change. Reason: sweeps over the island come back to the patch and
/// correct what is left. (6.3.1)
inline constexpr double patch_settled = 1e-4;

/// [-] Friction that exceeds its bound by less than this share of the bound meets it. Reason: about fifty
/// times the rounding of a number. (6.3.1)
inline constexpr double friction_rounding = 1e-14;

}  // namespace tumble::tolerance
