/// \file
/// \brief The small numbers of contacts, also those that several techniques use.
#pragma once

namespace tumble::tolerance {

// --- contact ------------------------------------------------------------------------------

/// [-] Largest sine of the angle between a contact normal and the horizontal at which neither body
/// holds up the other: 6 degrees. Reason: bodies side by side wobble by a degree or two; nothing
/// rests on a face as steep as 84 degrees below a coefficient of friction of 10. (4.4)
inline constexpr double side_contact = 0.1;

/// [-] Overlap that repair leaves, as a share of the shortest edge of the two bodies. Reason: a
/// gap would lose the contact and the body would fall into it on the next step; a thousandth
/// of an edge is below what a picture shows. (4.4)
inline constexpr double repair_slop = 1e-3;

/// [-] How much deeper than the slop an overlap must be to be worth a move, as a share of the
/// slop. Reason: sweeps come near their end like a geometric series; a hundredth of the slop is
/// far above rounding and ends it soon. (4.4)
inline constexpr double repair_closeness = 0.01;

/// [-] Two pushes on a body in a row count as to and fro if the cosine between them is below
/// this. Reason: walls that open by more than 26 degrees let a body escape sideways. (4.4)
inline constexpr double repair_to_and_fro = -0.9;

/// [-] Below this speed of its fastest point a body is slow, as a share of sqrt(g L), L its
/// shortest edge. Reason: about 3 cm/s for a box of 1 m; a free body gains 16 cm/s in 1/60 s. (4.5)
inline constexpr double sleeping_speed = 0.01;

/// [-] The same where there is no gravity, as a share of L / dt. Reason: a motion of less than a
/// ten-thousandth of an edge in a frame is not seen. (4.5)
inline constexpr double sleeping_speed_weightless = 1e-4;

/// [s] How long all bodies of an island must have been slow before it falls asleep. Reason: a
/// body that turns round at the top of its way is slow for less than 0.01 s at 1 m, and half a
/// second is not long to wait. (4.5)
inline constexpr double sleeping_time = 0.5;

/// [-] A direction in which a pair of bodies yields less than this share of the sum over all three
/// is one that nothing moves along. Reason: locked axes leave rounding, 1e-16; the thinnest box
/// that makes sense, 1 to 1000, leaves 1e-6. (5.2)
inline constexpr double rigid = 1e-13;

/// [-] A slip below this share of the relative velocity has no direction. Reason: rounding leaves
/// 1e-16 of a velocity that only points along the normal. (5.2)
inline constexpr double still = 1e-12;

/// [-] If friction leaves less than this share of the yield along the normal, there is no slipping
/// impulse (Painleve). Reason: impulses a million times larger than without friction are no answer,
/// and the guard of energy would scale them down to nothing anyway. (5.2)
inline constexpr double jamming = 1e-6;

/// [-] A gain of energy below this share of the work of an impulse is rounding. Reason: some ten
/// operations of 1e-16 each. (5.3)
inline constexpr double energy_rounding = 1e-14;

/// [-] Collisions slower than this share of sqrt(g L) stick. Reason: 0.16 m/s for a box of 1 m, as
/// much as gravity gives in 1/60 s; such a bounce with e = 1 rises by 1.3 mm. (4.3)
inline constexpr double sticky_speed = 0.05;

/// [-] The same where there is no gravity, as a share of L / dt. Reason: a bounce of less than a
/// ten-thousandth of an edge in a frame is not seen. (4.3)
inline constexpr double sticky_speed_weightless = 1e-4;

/// [-] Width of a contact area, its widest reach being 1, below which it is taken for a line.
/// Reason: pressure spread over a narrower one would lose more than five digits. (3.2)
inline constexpr double thin_patch = 1e-5;

/// [-] Friction has settled when a step changes it by less than this share of the normal impulses.
/// Reason: the rest of an approach is of that order, a nanometre per second for one of 1 m/s;
/// each digit more costs a fifth more steps. (5.2)
inline constexpr double friction_settled = 1e-9;

/// [-] An approach slower than this share of the fastest one when the event began is none.
/// Reason: impacts one after the other end like a geometric series, and at 1 m/s the bodies sink by
/// less than 2e-8 m in 1/60 s. (5.2)
inline constexpr double impact_settled = 1e-6;

/// [-] How close to Coulomb's limit a friction impulse has to be to be called slipping. Reason: it
/// decides the report, never the computation, so it only has to be above rounding. (3.3.2)
inline constexpr double friction_limit = 1e-9;

/// [-] Two bodies stick where they push each other if their materials there part by less than this
/// share of the speed at which turning moves the bodies' ends. Reason: solvers leave a thousandth, what
/// slides has ten times as much. In between it hardly matters which body is carried: the two ways of moving
/// differ by half the angle of a step, and only in where what slides is led. (6.2)
inline constexpr double carried_slip = 1e-2;

/// [-] How far the corners of a body may have got in half a second for it to rest, as a share of its
/// shortest edge. Reason: what slides or tips gets further. (3.3.2)
inline constexpr double resting_movement = 0.01;

/// [-] A contact point rests if it approaches or parts slower than this share of sqrt(g L): 3 mm/s
/// for a box of 1 m. Reason: gravity ends such a hop in 0.6 ms and half a micrometre up, and the error
/// of a step is a tenth of it; a rebound has to be faster, 1/50 of the sticky speed. (3.3.1)
inline constexpr double resting_speed = 1e-3;

/// [-] The same where there is no gravity, as a share of L / dt. Reason: a tenth of the sticky speed
/// there. (3.3.1)
inline constexpr double resting_speed_weightless = 1e-5;

/// [-] How far surfaces may be apart and still hold up a body, as a share of the shortest edge of
/// the two, when boxes are classified as stable. Reason: repair leaves gaps of up to ε1. (5.4)
inline constexpr double stability_margin = 2e-3;

/// [-] Largest sine between a contact normal and the vertical at which the contact counts as
/// vertical. Reason: upright boxes of a pile lean by less than 1e-3; at 3e-3 a load of 300 pushes
/// aside with a weight of one. (5.4)
inline constexpr double vertical_normal = 3e-3;

/// [-] Largest sine between a contact normal and the vertical at which the contact counts as vertical
/// where boxes leave the system of exact forces. Reason: the bodies pushed aside then are a tenth of
/// what the forces may miss (tolerance::force_residual). (5.4)
inline constexpr double exact_vertical = 1e-6;

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

/// [-] Height of an edge below which two bodies pass each other there, as a share of the shortest edge. Reason: flush
/// neighbours that stand on the ground differ by 1e-9, those that a heavy slider presses down by 1e-4, and a step so low is
/// repaired as overlap. (3.2)
inline constexpr double flush_height = 5e-4;

/// [-] How far two bodies are closed to see whether the edge at which they meet has a height, ditto. Reason: ten times
/// that height, so that the direction in which they meet is not taken for the one without height. (3.2)
inline constexpr double flush_overlap = 5e-3;

/// [-] Axes that may separate two boxes one after the other while they pass each other. Reason: without turning two or three do;
/// the end of a bar that turns by 0.8 rad past a block, at a hundredth of its length from it, needs more than 30. (3.2)
inline constexpr int passing_axes = 200;

/// [-] Cosine above which the plane of an edge is that of a contact. Reason: flush faces are parallel to within a
/// tenth of a degree or so. (3.2)
inline constexpr double flush_plane = 0.999;

}  // namespace tumble::tolerance
