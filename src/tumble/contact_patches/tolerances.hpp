/// \file
/// \brief The small numbers of one contact patch.
#pragma once

namespace tumble::tolerance {

/// [-] Overlap and gap of bodies at rest, as a share of the shortest edge of the two. Reason: 10 micrometres for a metre is
/// not seen and far above rounding. (6.3.1)
inline constexpr double contact_slop = 1e-5;

/// [-] Multiple of the slop up to which a point that pushes goes on touching. Reason: where overlap is repaired, other corners of the
/// box rise by less. As long as they opened and fell back, heaps did not come to rest. (4.4)
inline constexpr double kept_touch = 1.1;

/// [-] Share of the slop that targets of points may be off from those of the one motion that replaces them. Reason: with a
/// whole slop a patch that rests on some points would move in every step in a way that they do not ask for. (6.3.1)
inline constexpr double planar_targets = 0.01;

/// [-] A point that pushes and slides no faster than this multiple of the allowed residual rests. Reason: creeping points
/// take IslandSolver many steps, and friction under the common bound of their patch would set it back in each. (6.3.1)
inline constexpr double patch_creep = 10.0;

/// [-] Turns between friction and pressure in a patch end with one that changes its velocities by less than this share of
/// the largest change. Reason: sweeps over the island come back to the patch. (6.3.1)
inline constexpr double patch_settled = 1e-4;

/// [rad] Turn in a step beyond which the way of a point by rotation is taken along its arc. Reason: up to
/// here the tangent is off by less than an eighth of the arm. (6.3.1)
inline constexpr double fast_turn = 0.5;

/// [-] Bodies as near as this share of the shortest edge get a patch, whatever their speed. Reason: a corner that hangs a
/// millimetre over its support belongs to the patch that carries the box. (6.3.1)
inline constexpr double kept_margin = 1e-3;

/// [-] A contact patch is kept while neither body has moved by more than this share of an edge, or turned by as many radians.
/// Reason: lever arms are wrong by as much, and gaps by its square. (6.3.1)
inline constexpr double kept_motion = 1e-6;

/// [-] Growth of a pair's reach at which a kept patch is looked for again. Reason: at rest it does not change; a push changes it by
/// more. (3.2)
inline constexpr double kept_reach = 2.0;

/// [-] A corner beside a face is a point of contact if it is nearer than all others by this share of the shortest edge. Reason:
/// with less, neighbours in a tower get points; with 0.02 and 0.05, cubes that hit at 6 m/s overlap more. (3.2)
inline constexpr double corner_beside = 0.005;

}  // namespace tumble::tolerance
