/// \file
/// \brief The small numbers of `analytic_lcp`.
#pragma once

namespace tumble::tolerance {

// --- analytic_lcp -------------------------------------------------------------------------

/// [-] How far surfaces may be apart and still have a contact force between them, as a share of the
/// shortest edge of the smaller body. Reason: rounding and the step's error part resting bodies by a
/// tenth of it; a ten-thousandth is not seen. (3.3.1)
inline constexpr double contact_margin = 1e-4;

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

/// [-] What slides by more than this share of the smaller body's shortest edge in half a flight may stand on others there. Reason: a
/// box on one side of a seam then has most of itself on that side. (3.3.1)
inline constexpr double far_slide = 0.1;

/// [-] Energy that friction gives bodies in a flight, over their kinetic energy and the sum of m g L, from which on forces of its middle
/// are not used. Reason: rounding and the midpoint rule leave a millionth; a hundred flights must not make a hundredth. (3.3.1)
inline constexpr double driving_friction = 1e-4;

/// [-] Energy by which repair lifts bodies after a step of velocities, over their kinetic energy and the sum of m g L, from which on
/// that step is divided. Reason: sixty such steps must not make a hundredth. (3.3.1)
inline constexpr double lifting_repair = 1e-4;

/// [-] How far unknowns of a contact problem with friction may fall below 0 on the way, as a share of
/// max |b|. Reason: boxes that have turned by 1e-9 have rows that depend on each other to as much, and
/// a hundred pivots may then add up to the accepted error at most. (2.6.3)
inline constexpr double slack = 1e-10;

/// [-] Error of the velocities at the end of a time step, as a share of the fastest point of the island,
/// up to which they are accepted. Reason: rows that nearly depend on each other leave 1e-8; this
/// much is 2 nm in 1/60 s at 1 m/s. (2.6.3)
inline constexpr double step_residual = 1e-7;

/// [-] Overlap at the end of a time step, as a share of the smaller body's shortest edge, from which on the step is solved again with
/// the points that overlap. Reason: points that are known overlap by half (hω)² of an edge, 0.5 % of it for a tenth of a radian. (2.6.3)
inline constexpr double missed_overlap = 5e-3;

/// [-] How often that is done in a step, at most. Reason: each time one more corner of an edge may come in. (2.6.3)
inline constexpr int most_missed = 3;

/// [-] What slides more slowly at the end of a time step, as a share of the fastest point of the island,
/// needs no friction. Reason: rounding in a pile at rest is 1e-13; at 0.16 m/s, gravity's share of
/// 1/60 s, this is 5 mm in a year. (2.6.3)
inline constexpr double step_sliding = 1e-9;

/// [-] Relative excess of a contact point's response to its own push while rows that nearly depend on
/// each other are kept apart. Reason: far above rounding, and two rounds of the remedy leave its square
/// as the error. (2.6.3)
inline constexpr double compliance = 1e-6;

/// [-] Residual of an answer of Lemke's method that does not hold, up to which sweeps start from it. Reason:
/// answers that are off by rounding have 1e-4 at most; a path that was lost has 1 and more. (2.6.3)
inline constexpr double sweep_start = 1e-2;

/// [-] Change of a point's motion at which sweeps have settled, as a share of the fastest point of the island. Reason:
/// with 1e-7 a pyramid of boxes at rest shakes by 4 nm, with this by rounding. (2.6.3)
inline constexpr double sweeps_settled = 1e-10;

/// [-] What sweeps may leave, as a share of the fastest point of the island, where bodies bounce. Reason: a
/// millimetre per second at 1 m/s; restitution that no motion gives leaves a part of itself. (2.6.3)
inline constexpr double sweep_bounce = 1e-3;

}  // namespace tumble::tolerance
