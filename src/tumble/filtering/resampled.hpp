/// \file
/// \brief A run at equal times, for filters that need them (thesis 5.5).
#pragma once

#include "tumble/dynamics/trajectory.hpp"

namespace tumble {

/// Puts frames of any spacing on a grid of equal times, which a box filter needs.
///
/// The grid begins with the first frame, and ends with the last multiple of the interval that is not
/// after the last frame. Between the two recorded frames around a time, positions and momenta go
/// along straight lines, and orientations turn the shorter way about one axis, all by the share of
/// the time that has passed.
///
/// A recorded frame that is on the grid, to tolerance::on_the_grid of an interval, is taken over bit
/// by bit with its own time; so is a body that rests between two frames, and a run that was on the
/// grid is returned as it was. Elsewhere a body is there if both recorded frames have it: no pose is
/// made up for one that has not come yet or is gone.
/// \par Limits
/// A motion that is quicker than the recorded frames cannot be brought back, and one that is quicker
/// than the grid appears slower than it was. An impact between two frames is cut short.
/// \param run       frames, times ascending
/// \param interval  [s] between the frames of the result, above 0
/// \return frames at equal times, `step` that of the recorded frame before; none for a run of none
/// \throws std::invalid_argument for an interval that is not finite and above 0, or so short that there
///         would be 10^8 frames or more; for times that do not ascend, and for states that are not
///         finite
/// \par Cost
/// O(frames recorded and made, times bodies).
Trajectory resampled(const Trajectory& run, double interval);

}  // namespace tumble
