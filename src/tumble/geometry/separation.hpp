/// \file
/// \brief Whether two boxes overlap, how deep, and along which direction (thesis 3.2).
#pragma once

#include "tumble/geometry/box.hpp"

namespace tumble {

/// One of the 15 directions that can separate two boxes, by number.
///
/// 0-2: face axes of the first box; 3-5: face axes of the second; 6 + 3 i + j: the cross product
/// of axis i of the first with axis j of the second.
using AxisIndex = int;

/// No direction: none was remembered.
inline constexpr AxisIndex kNoAxis = -1;

/// The direction along which two boxes are farthest apart, or overlap least.
struct Separation {
  /// [m] signed: above 0 the boxes are disjoint and this is a lower bound of their distance;
  /// below 0 they overlap and -distance is the shortest translation that parts them.
  double distance = 0.0;
  Vec3 normal_w = Vec3::UnitX();  ///< [-] world frame, length 1, from the first box to the second
  AxisIndex axis = kNoAxis;       ///< which of the 15
};

/// How a separation is searched for.
struct SeparationOptions {
  /// Prefer face axes: an edge axis is taken only if it beats the best face axis clearly
  /// (tolerance::face_preference). This keeps the normal from flickering in stacks. Off, the
  /// exact minimum over the 15 axes is returned.
  bool prefer_faces = true;
  /// [m] Stop at the first axis along which the boxes are farther apart than this. Infinity: look
  /// at all 15.
  double enough = 0.0;
  /// The axis that the same pair had before: looked at first, and kept if no other one beats it
  /// clearly. kNoAxis if there is none.
  AxisIndex remembered = kNoAxis;
};

/// Finds the direction along which two boxes are farthest apart, or overlap least.
///
/// Two convex polyhedra are disjoint exactly if the normal of a face of one of them or the cross
/// product of an edge of each separates them; for boxes that leaves 15 directions n. Along each,
/// \f[ s(n) = |d \cdot n| - \sum_i a_i |A_i \cdot n| - \sum_j b_j |B_j \cdot n|, \quad |n| = 1 \f]
/// (d from centre to centre, A_i and B_j the axes, a_i and b_j the half sizes) and the largest s
/// is the answer. It is exact for boxes that overlap: -s is the shortest translation that parts
/// them. Touching is s = 0.
///
/// With a preference or a remembered axis the answer s may miss the largest one, by at most
/// `tolerance::face_preference` |s| + `tolerance::face_preference_length` times the shortest half
/// edge of the two boxes, and never across `enough`: boxes that are farther apart than `enough`
/// are always found to be. Here s is the answer, not the largest one.
///
/// For boxes that are apart and have almost parallel edges, the cross product of these has a
/// direction only to rounding over the sine of their angle, and so has the distance. Any direction
/// gives a true lower bound of the distance.
/// \param first    the box that the normal leaves
/// \param second   the box that the normal enters; exactly concentric boxes have the normal
///                 along the positive axis
/// \return the direction and how far apart the boxes are along it
/// \throws std::invalid_argument if `enough` is not a number or `remembered` is not an AxisIndex
/// \pre both boxes are finite with orthonormal axes (make_box sees to that)
/// \par Cost and determinism
/// About 60 ns (2026, one core of a server); without allocation. The same bits with any compiler, and bitwise proportional to
/// the lengths if those are multiplied by a power of two.
/// \see Thesis 3.2; Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996.
/// \algorithm{Overlap of two boxes: section 3.2}
/// \verified{The separation of 20000 pairs is that of the plain loop over fifteen axes}
Separation separation(const Box& first, const Box& second, const SeparationOptions& options = {});

}  // namespace tumble
