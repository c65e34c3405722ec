/// \file
/// \brief The small numbers of the lower layers. Every other folder has its own `tolerances.hpp`.
///
/// Each docstring says: what the constant decides, its unit, why it has that size, and the thesis
/// section it belongs to. Numbers without a unit are ratios and hold for boxes of any size and mass.
/// A bare small literal outside of a `tolerances.hpp` is a mistake.
#pragma once

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

/// [-] A generator of least squares depends on others if the rest of its length without
/// their directions is below this share. Reason: exact dependence leaves 1e-15 of rounding in an
/// orthogonal factor, and factors above 1e10 would carry few digits. (3.3.1)
inline constexpr double dependent_length = 1e-10;

/// [-] An acceleration counts as not negative above minus this share of max |b|; in least
/// squares, a slope below this share of |d| counts as none. Reason: 1e-13 is rounding with 30
/// contacts, and the answers of different solvers are compared at 1e-9. (3.3.1)
inline constexpr double complementarity = 1e-11;

/// [rad] Below this angle coefficients of rotations are the first term of their series. Reason: the next
/// term is a hundredth of the square, 1e-10, of a part that is itself the square of the angle times the
/// whole. (6.2)
inline constexpr double small_angle = 1e-4;

/// [-] A radius that changes less than this share of the slope is used up without a search (minimum_in_ball()).
/// Reason: below the rounding of the slope, 1e-16. (6.3.1)
inline constexpr double ball_negligible = 1e-17;

/// [any] A slope below it is scaled up. Reason: products of four of its size are not yet rounded to 0. (6.3.1)
inline constexpr double ball_smallest = 1e-70;

/// [-] The power of two by which it is scaled. Reason: 1e60, so that the smallest number there is takes five steps. (6.3.1)
inline constexpr int ball_power = 200;

/// [-] Excess over the radius below which the next Newton step is the last one and is taken to first
/// order. Reason: its error is the square of this, 1e-14. (6.3.1)
inline constexpr double ball_last_step = 1e-7;

/// [-] An excess over the radius below this share of it counts as none. Reason: about fifty times the rounding of a
/// number. (6.3.1)
inline constexpr double ball_rounding = 1e-14;

/// [-] Newton steps to the sphere, at most. Reason: they converge quadratically; a few do. (6.3.1)
inline constexpr int ball_newton_steps = 30;

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
/// direction. Reason: above rounding (1e-16); the loss is this part of a half edge. (3.2)
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

// --- dynamics -----------------------------------------------------------------------------

/// [-] How far mass times inverse mass may be from 1 in properties that a caller has filled in.
/// Reason: as for unit_length, 9 digits in a text file; a sloppier one is a mistake. (3.1)
inline constexpr double reciprocal = 1e-9;

/// [s] How closely collision times are found. Reason: at 10 m/s a body moves 10 µm meanwhile, a
/// hundredth of what repair leaves of a box of 1 m, and 1/60 s takes 15 halvings. A share of the
/// step would find other times when the step changes. (3.3.1)
inline constexpr double event_resolution = 1e-6;

/// [s] The smallest resolution that a search for events accepts. Reason: times of a step of 1/60 s have digits
/// down to 3e-18 s, and a search needs a few of them below its resolution. (3.2)
inline constexpr double least_event_resolution = 1e-15;

/// [-] Overlap that counts as rounding, as a share of the longest edge of the two bodies. Reason: places
/// of boxes a few metres away are rounded to 1e-15 of their size, and a step adds a few roundings;
/// visible sizes begin a thousand million times above. (2.1)
inline constexpr double rounding_overlap = 1e-12;

// --- scenes -------------------------------------------------------------------------------

/// [-] Overlap at the start of a run up to which a scene is accepted, as a share of the shortest
/// edge of the two bodies. Reason: positions are typed with six digits. (4.4)
inline constexpr double start_overlap = 1e-3;

/// [-] How much too late, as a share of a step, a moment may be at which a box appears or disappears, and yet belong to
/// the step that begins. Reason: the sum of a million steps of 1/60 s is off by up to a ten-thousandth of one. (3.1)
inline constexpr double moment = 1e-3;

}  // namespace tumble::tolerance
