/// \file
/// \brief Every small number of the library, in one place; those of the chapters are in a file of
///        their own beside this one.
///
/// Each line says: what it decides, its unit, why it has that size, and the thesis section it
/// belongs to. Numbers without a unit are ratios and hold for boxes of any size and mass.
/// A bare small literal anywhere else in the library is a mistake.
#pragma once

#include "tumble/base/chapter_tolerance.hpp"
#include "tumble/base/filtering_tolerance.hpp"
#include "tumble/base/rotation_tolerance.hpp"
#include "tumble/base/stability_tolerance.hpp"

/// Names for every small number.
namespace tumble::tolerance {

// --- base ---------------------------------------------------------------------------------

/// [-] How far the length of a unit vector or quaternion may be from 1 when a caller hands it in.
/// Reason: 16 significant digits survive a text file with 9; a sloppier one is a mistake. (3.1)
inline constexpr double unit_length = 1e-9;

// --- math ---------------------------------------------------------------------------------

/// [any²] Smallest squared length whose square root is taken for a direction; the largest is its
/// reciprocal. Reason: squares below it lose digits to underflow, above to overflow. (3.1)
inline constexpr double smallest_square = 1e-300;

/// [-] Ratio |xyz| / w of a quaternion below which its rotation vector is 2 xyz / w. Reason: the next
/// term of the series is a third of its square, below 2^-55. (3.1)
inline constexpr double small_rotation = 0x1p-27;

/// [-] How far A_ij and A_ji may differ, as a share of sqrt(A_ii A_jj). Reason: assembled in
/// another order they differ by 1e-15; a sloppier matrix is a mistake. (3.3.1)
inline constexpr double symmetry = 1e-9;

/// [-] A contact j depends on others if v·A v is below this share of A_jj, where v is a unit force at
/// it and the forces at the others that undo its effect there; changes of forces and accelerations
/// below it, scaled alike, count as none. Reason: exact dependence of 30 contacts leaves 7e-15 of
/// rounding, points a hundred-thousandth of an edge apart leave 1e-11. (3.3.1)
inline constexpr double dependent = 1e-13;

/// [-] The share of (Σ |v_i| √A_ii)² that is added to that bound. Reason: four units of 2.2e-16, the
/// rounding of A itself, which v·A v sees enlarged by v. (3.3.1)
inline constexpr double matrix_rounding = 0x1p-50;

/// [-] A contact that depends on others sinks whatever they do if b·v is below minus this share of
/// max |b| Σ |v_i|. Reason: v is as uncertain as rounding over the root of `dependent`, 4e-10, and
/// what no force can hold sinks by much more. (3.3.1)
inline constexpr double dependent_sinking = 1e-9;

/// [-] Rounding in a sum of up to 30 products, as a share of the sum of their sizes. Reason: 64
/// units of 2.2e-16. (3.3.1)
inline constexpr double rounding = 0x1p-46;

/// [-] A generator of least squares depends on others if what is left of its length without
/// their directions is below this share. Reason: exact dependence leaves 1e-15 of rounding in an
/// orthogonal factor, and factors above 1e10 would carry few digits. (3.3.1)
inline constexpr double dependent_length = 1e-10;

/// [-] An acceleration counts as not negative above minus this share of max |b|; in least
/// squares, a slope below this share of |d| counts as none. Reason: 1e-13 is rounding with 30
/// contacts, and the answers of different solvers are compared at 1e-9. (3.3.1)
inline constexpr double complementarity = 1e-11;

// --- geometry -----------------------------------------------------------------------------

/// [-] By which part of its separation a preferred axis (a face's, or the remembered one) has to
/// be beaten before another one is taken. Reason: a few percent of depth hide the noise that makes
/// normals flicker in stacks, and cost no more than that in depth. (3.2)
inline constexpr double face_preference = 0.05;

/// [-] The same as a part of the shortest half edge of the two boxes, added so that boxes that
/// just touch have a preference too. Reason: a box that is tilted by 1e-4 still rests on its
/// face. (3.2)
inline constexpr double face_preference_length = 1e-4;

/// [-] Two faces whose separations differ by less than this part of the shortest half edge tie,
/// and the larger one is the reference. Reason: well above rounding at a size ratio of a million,
/// well below anything that moves. (3.2)
inline constexpr double face_tie = 1e-9;

/// [-] Sine of the angle below which two edges are parallel and their cross product has no
/// direction. Reason: above rounding (1e-16); what is lost is this part of a half edge. (3.2)
inline constexpr double parallel_edges = 1e-12;

/// [-] By which part of all lengths in it (half sizes, centre distance) a quick separation along an
/// edge axis may be off. Reason: 50 times the rounding of its sums; an axis that might win by so
/// much is computed again with care. (3.2)
inline constexpr double separation_rounding = 1e-14;

/// [-] By which part of its half edge a face is widened before another one is clipped to it.
/// Reason: edges that lie on each other exactly must not miss each other by rounding. (3.2)
inline constexpr double clip_slack = 1e-12;

/// [-] Two corners of a contact area that are closer than this part of the smaller face's longer
/// half edge are one point. Reason: far above rounding, far below what matters for a torque. (3.2)
inline constexpr double same_point = 1e-9;

/// [-] A gap below this part of the shortest edge of two boxes counts as contact when boxes in flight
/// are advanced to their first contact. Reason: a micrometre for a box of a metre, far above rounding;
/// ten times less costs about six more iterations, of 43 for tumbling boxes. (3.2)
inline constexpr double contact_gap = 1e-6;

/// [-] By which part of its mean extent the bounding tree widens a body's bounds on each side.
/// Reason: a body may then move this far before the tree has to change; more costs needless
/// tests. (4.1)
inline constexpr double tree_margin = 0.1;

/// [-] Widened bounds are kept if the body's own, widened by this part of their mean extent, still
/// contain them. Reason: well above tree_margin, so that a turning box does not pay for getting
/// narrower, yet no body keeps bounds of several times its size. (4.1)
inline constexpr double tree_slack = 0.5;

/// [-] Sine of the angle between an edge and the line of sight below which the edge is seen end on and
/// has no line in the picture. Reason: the root of rounding (1e-16), which gives either error the
/// same size; outlines are wrong by this part of an edge. (pictures only)
inline constexpr double seen_end_on = 1e-8;

// --- dynamics -----------------------------------------------------------------------------

/// [-] How far mass times inverse mass may be from 1 in properties that a caller has filled in.
/// Reason: as for unit_length, 9 digits in a text file; a sloppier one is a mistake. (3.1)
inline constexpr double reciprocal = 1e-9;

/// [s] How closely collision times are found. Reason: at 10 m/s a body moves 10 µm meanwhile, a
/// hundredth of what repair leaves of a box of 1 m, and 1/60 s takes 15 halvings. A share of the
/// step would find other times when the step changes. (3.3.1)
inline constexpr double event_resolution = 1e-6;

// --- contact ------------------------------------------------------------------------------

/// [-] Largest sine of the angle between a contact normal and the horizontal at which neither body
/// holds up the other: 6 degrees. Reason: bodies side by side wobble by a degree or two; nothing
/// rests on a face as steep as 84 degrees below a coefficient of friction of 10. (4.4)
inline constexpr double side_contact = 0.1;

/// [-] Overlap that repair leaves, as a share of the shortest edge of the two bodies. Reason: a
/// gap would let go of the contact and the body would fall into it on the next step; a thousandth
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
/// Reason: what is left of an approach is of that order, a nanometre per second for one of 1 m/s;
/// each digit more costs a fifth more steps. (5.2)
inline constexpr double friction_settled = 1e-9;

/// [-] An approach slower than this share of the fastest one when the event began is none.
/// Reason: impacts one after the other end like a geometric series, and at 1 m/s the bodies sink by
/// less than 2e-8 m in 1/60 s. (5.2)
inline constexpr double impact_settled = 1e-6;

/// [-] How close to Coulomb's limit a friction impulse has to be to be called slipping. Reason: it
/// decides what is reported, never what is computed, so it only has to be above rounding. (3.3.2)
inline constexpr double friction_limit = 1e-9;

/// [-] Overlap that counts as rounding, as a share of the longest edge of the two bodies. Reason: places
/// of boxes a few metres away are rounded to 1e-15 of their size, and a step adds a few roundings;
/// what is seen begins a thousand million times above. (2.1)
inline constexpr double rounding_overlap = 1e-12;

/// [-] Two bodies stick where they push each other if their materials there part by less than this
/// share of the speed at which turning moves the bodies' ends. Reason: solvers leave a thousandth, what
/// slides has ten times as much. In between it hardly matters who is carried: the two ways of moving
/// differ by half the angle of a step, and only in where what slides is led. (6.2)
inline constexpr double carried_slip = 1e-2;

/// [-] A body that is carried is predicted anew if what carries it has moved it by more than this share of
/// its shortest edge. Reason: rounding of a few metres is 1e-15; what rests is not looked at again. (6.2)
inline constexpr double carried_again = 1e-14;

// --- scenes, record -----------------------------------------------------------------------

/// [-] Overlap at the start of a run up to which a scene is accepted, as a share of the shortest
/// edge of the two bodies. Reason: positions are typed with six digits. (4.4)
inline constexpr double start_overlap = 1e-3;

/// [-] Up to this gap two bodies count as touching in measurements of chatter, as a share of the
/// shortest edge of the two. Reason: well below what is seen, well above what techniques leave
/// open. (3.3.2)
inline constexpr double touching = 5e-3;

/// [-] How far the corners of a body may have got in half a second for it to rest, as a share of its
/// shortest edge. Reason: what slides or tips gets further, and that is not chatter. (3.3.2)
inline constexpr double resting_movement = 0.01;

/// [-] By how much of a display frame a step may end before the frame and still show it. Reason: times
/// are sums of steps and carry rounding; a millionth of a frame is 17 ns. (3.3.2)
inline constexpr double frame_slack = 1e-6;

/// [-] A duration that is this part of a step longer than a whole number of steps is one of whole
/// steps. Reason: rounding of 10 s / (1/60 s), well below any remainder somebody asked for. (2.1)
inline constexpr double step_remainder = 1e-9;

}  // namespace tumble::tolerance
