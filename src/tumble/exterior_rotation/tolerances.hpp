/// \file
/// \brief The small numbers of `exterior_rotation`.
#pragma once

namespace tumble::tolerance {

// --- exterior_rotation --------------------------------------------------------------------

/// [-] A row of the joints is dependent if its part that is independent of the rows before it is below this
/// share of it. Reason: rounding leaves 1e-13 of the rows of a ring of boxes, and the stiffest joint of
/// the scenes, a plate on a plate a hundred times wider, has 1e-6. (6.2)
inline constexpr double redundant_row = 1e-10;

/// [-] Largest gap of surfaces that are glued together at the start, over the shortest edge. Reason:
/// scenes are written with four digits or more. (6.2)
inline constexpr double glue_margin = 1e-5;

/// [-] Accuracy, in steps, of the time at which a joint opens or closes. Reason: the joint has then moved by
/// 1e-24 of the distance of a free fall, and 40 halvings find it. (6.2)
inline constexpr double joint_moment = 1e-12;

/// [-] Overlap at which an open area closes, over the shortest edge. Reason: rounding makes an area that has
/// just opened overlap by 1e-16 to 1e-15. (6.2)
inline constexpr double closed_area = 1e-12;

/// [-] Least share of the kinetic energy that new joints remove for velocities to be changed at all.
/// Reason: the square of a millionth of the speed; scenes give velocities with fewer digits. (6.2)
inline constexpr double joining_energy = 1e-12;

/// [-] Share of an overlap that is pushed out in a step of bodies in joints that meet others. Reason: half of it is seen in the
/// same step; with a fifth an overlap is a tenth in a third of a second at 60 Hz, and the speed is lost again. (2.6.5)
inline constexpr double pushed_out = 0.2;

/// [-] Default error per step of the adaptive integration. Reason: errors of a thousand steps add up to a
/// millionth, far below those of the simple schemes. (6.2)
inline constexpr double rotation_accuracy = 1e-9;

/// [-] Smallest error that may be requested. Reason: fifty times the rounding of a number. (6.2)
inline constexpr double least_rotation_accuracy = 1e-14;

}  // namespace tumble::tolerance
