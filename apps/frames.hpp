/// \file
/// \brief The boxes of recorded frames as they are drawn.
#pragma once

#include "tumble/pictures/film.hpp"
#include "tumble/record/recorded_run.hpp"

#include <span>
#include <vector>

namespace tumble::app {

/// The boxes of every frame. Each box has one colour throughout; fixed ones that stand in front of others in
/// all frames, as the front walls of a cage, are left out of all.
/// \param frames       recorded ones, or between these
/// \param direction_w  [-] from the boxes to the eye
std::vector<FilmFrame> shown_frames(const RecordedRun& run, std::span<const RecordedFrame> frames,
                                    const Vec3& direction_w);

}  // namespace tumble::app
