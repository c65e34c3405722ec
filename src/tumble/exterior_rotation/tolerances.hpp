/// \file
/// \brief The small numbers of `exterior_rotation`.
#pragma once

namespace tumble::tolerance {

// --- exterior_rotation --------------------------------------------------------------------

/// [-] A row of the joints whose part that no row before it holds is below this share of it depends on
/// them. Reason: rounding leaves 1e-13 of the rows of a ring of boxes, and the stiffest joint of the
/// scenes, a plate on a plate a hundred times wider, has 1e-6. (6.2)
inline constexpr double redundant_row = 1e-10;

/// [-] How far apart surfaces may be at the start to be glued together, over the shortest edge. Reason:
/// scenes are written with four digits or more. (6.2)
inline constexpr double glue_margin = 1e-5;

/// [-] How exactly a moment of a step is searched for at which a joint opens or closes, in steps. Reason:
/// a joint then has moved by 1e-24 of gravity's way, and 40 halvings find it. (6.2)
inline constexpr double joint_moment = 1e-12;

/// [-] An open area closes when it overlaps by this share of the shortest edge. Reason: rounding makes an
/// area that has just opened overlap by 1e-16 to 1e-15. (6.2)
inline constexpr double closed_area = 1e-12;

/// [-] Share of the kinetic energy that joints must take away at once for velocities to be changed by them.
/// Reason: the square of a millionth of the speed; scenes give velocities with fewer digits. (6.2)
inline constexpr double joining_energy = 1e-12;

/// [-] Error that the integration with a controlled one accepts in a step. Reason: errors of a
/// thousand steps add up to a millionth, far below those of the simple schemes. (6.2)
inline constexpr double rotation_accuracy = 1e-9;

/// [-] Smallest such error that may be asked for. Reason: fifty times the rounding of a number. (6.2)
inline constexpr double least_rotation_accuracy = 1e-14;

}  // namespace tumble::tolerance
