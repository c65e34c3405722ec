/// \file
/// \brief Features of a body's motion in its last frames (thesis 6.3.1).
#pragma once

#include "tumble/dynamics/body.hpp"

#include <cstddef>
#include <span>

namespace tumble {

/// Pose of a box as a point: its centre, then its three half edges as vectors.
///
/// The distance of two such points is the root mean square displacement of the eight corners; so a
/// rotation counts by its effect on corners, and no axis is special.
using Placement = Eigen::Matrix<double, 12, 1>;

/// The placement of a box.
/// \param body   its constant part, a box
/// \return [m] see Placement
[[nodiscard]] Placement placement_of(const BodyProperties& body, const BodyState& state);

/// Limit of swing_of(): two seconds at 60 frames per second.
inline constexpr std::size_t kMostPlaces = 121;

/// Features of motion in successive frames.
struct MotionHistory {
  double displacement = 0.0;  ///< [m] D: distance of the last place from the first
  double path = 0.0;          ///< [m] P: the sum of all steps, at least D
  double excursion = 0.0;     ///< [m] the largest distance from the first place
  /// [m] displacement along the straight line of best fit: D without oscillation about the line
  double drift = 0.0;
  double swing = 0.0;  ///< [m] A: see swing_of()
};

/// The features of successive places, except the swing.
/// \param places at least two
/// \return with a swing of 0
[[nodiscard]] MotionHistory history_of(std::span<const Placement> places);

/// The swing: amplitude of a motion to and fro.
///
/// The places are projected on their principal direction, along which the steps are largest in mean
/// mean square. With its coordinate \f$u_0 \dots u_W\f$ there, the swing for Z reversals is
/// \f[ A_Z = \max_{k_0 < k_1 < \dots < k_{Z+1}} \ \min_{m}\ \pm(-1)^m\, (u_{k_{m+1}} - u_{k_m}), \f]
/// the largest length by which the body went forth, back, forth ..., Z + 1 times in turn. Motion in one
/// direction, however curved and uneven, has a swing of 0, and so has motion with fewer than Z
/// reversals: a single swing back is no chatter. A slow drift reduces the swing by its displacement in
/// half a period; bursts count if Z reversals are within the frames.
/// \param places     in successive frames, at most kMostPlaces
/// \param reversals  Z, at least 1
/// \return [m] 0 if there are too few places
/// \throws std::invalid_argument for more places, or less reversals
/// \par Cost
/// O(n² Z) for n places.
[[nodiscard]] double swing_of(std::span<const Placement> places, int reversals);

}  // namespace tumble
