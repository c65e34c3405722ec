/// \file
/// \brief The thresholds of pictures, each with its reason.
#pragma once

namespace tumble::tolerance {

// --- pictures ---------------------------------------------------------------------------

/// [-] Sine of the angle between an edge and the line of sight below which the edge is seen end on and
/// has no line in the picture. Reason: the root of rounding (1e-16), which gives either error the
/// same size; outlines are wrong by this part of an edge. (pictures only)
inline constexpr double seen_end_on = 1e-8;

/// [-] How far a corner may be from a plane, over the size of its group of boxes, to be in it. Reason:
/// cutting a face there leaves a sliver that no pixel shows; rounding is a millionth of it. (pictures only)
inline constexpr double in_plane = 1e-9;

/// [-] Depth of overlap, over the shortest edge of two boxes, up to which one of them is painted as a
/// whole after the other. Reason: what a simulation leaves where boxes rest on each other is less, and
/// the wrong area is as narrow as the overlap. (pictures only)
inline constexpr double painted_whole = 5e-3;

}  // namespace tumble::tolerance
