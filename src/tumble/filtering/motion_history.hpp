/// \file
/// \brief What the last frames of a body tell about how it moves (thesis 6.3.1).
#pragma once

#include "tumble/dynamics/body.hpp"

#include <cstddef>
#include <span>

namespace tumble {

/// Where a box is and how it is turned, as a point: its centre, then its three half edges as vectors.
///
/// The distance of two such points is the root mean square, over the eight corners, of the ways
/// between their places; so a turn counts as what it does to corners, and no axis is special.
using Placement = Eigen::Matrix<double, 12, 1>;

/// A box's place.
/// \param body   its constant part, a box
/// \param state  its pose
/// \return [m] see Placement
[[nodiscard]] Placement placement_of(const BodyProperties& body, const BodyState& state);

/// Places that swing_of() and reversals_of() can look at: two seconds at 60 frames a second.
inline constexpr std::size_t kMostPlaces = 121;

/// How a body has moved in successive frames.
struct MotionHistory {
  double way = 0.0;        ///< [m] D: from the first place to the last
  double path = 0.0;       ///< [m] P: the sum of all steps, at least D
  double excursion = 0.0;  ///< [m] the largest distance from the first place
  /// [m] the way along the straight line that fits best: D without what shakes about the line
  double drift = 0.0;
  double swing = 0.0;  ///< [m] A: see swing_of()
};

/// What there is to tell of successive places, all but the swing.
/// \param places at least two
/// \return with a swing of 0
[[nodiscard]] MotionHistory history_of(std::span<const Placement> places);

/// The swing: how far a body goes to and fro.
///
/// The places are projected on their principal direction, along which the steps are largest in the
/// mean square. With its coordinate \f$u_0 \dots u_W\f$ there, the swing for Z reversals is
/// \f[ A_Z = \max_{k_0 < k_1 < \dots < k_{Z+1}} \ \min_{m}\ \pm(-1)^m\, (u_{k_{m+1}} - u_{k_m}), \f]
/// the largest length by which the body went forth, back, forth ..., Z + 1 times in turn. What
/// only goes on, however curved its path and uneven its speed, has a swing of 0, and so has what turns
/// round less than Z times: a swing back is no chatter. A slow drift under the shaking takes off
/// what it does within half a period; bursts count if Z reversals are within the frames.
/// \param places     in successive frames, at most kMostPlaces
/// \param reversals  Z, at least 1
/// \return [m] 0 if there are too few places
/// \throws std::invalid_argument for more places, or less reversals
/// \par Cost
/// O(n² Z) for n places.
[[nodiscard]] double swing_of(std::span<const Placement> places, int reversals);

/// The number of reversals along the principal direction, counting swings of a certain size only.
/// \param places  in successive frames, at most kMostPlaces
/// \param least   [m] a turn back counts once the body has gone back by as much, above 0
/// \return Z
/// \throws std::invalid_argument for more places, or a length that is not finite and above 0
[[nodiscard]] int reversals_of(std::span<const Placement> places, double least);

}  // namespace tumble
