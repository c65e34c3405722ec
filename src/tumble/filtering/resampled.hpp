/// \file
/// \brief A run resampled at equal times, for filters that need them (thesis 5.5).
#pragma once

#include "tumble/dynamics/trajectory.hpp"

namespace tumble {

/// Resamples frames of any spacing at equal times, which a box filter needs.
///
/// The times begin with the first frame and end with the last multiple of the interval that is not after
/// the last frame. Between two recorded frames positions and momenta are interpolated linearly, and
/// orientations along the shorter rotation about one axis.
///
/// A recorded frame at one of these times, to tolerance::on_the_grid of an interval, is copied bit by bit
/// with its own time; so is a body that rests between two frames, and a run that already has equal times
/// is returned unchanged. At other times a body is present if both recorded frames have it: there is
/// no extrapolation.
/// \par Limits
/// Motion faster than the recorded frames cannot be recovered, and motion faster than the interval
/// appears slower than it was. An impact between two frames is smoothed.
/// \param run       frames, times ascending
/// \param interval  [s] between the frames of the result, above 0
/// \return frames at equal times, with the `step` of the recorded frame before; none for an empty run
/// \throws std::invalid_argument for an interval that is not finite and above 0, or so short that there
///         would be 10^8 frames or more; for times that do not ascend, and for states that are not
///         finite
/// \par Cost
/// O(frames recorded and made, times bodies).
Trajectory resampled(const Trajectory& run, double interval);

}  // namespace tumble
