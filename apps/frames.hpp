/// \file
/// \brief The boxes of recorded frames as they are drawn, and films and animated scenes of them.
#pragma once

#include "tumble/pictures/film.hpp"
#include "tumble/record/recorded_run.hpp"

#include "request.hpp"

#include <span>
#include <string>
#include <vector>

namespace tumble::app {

/// The boxes of every frame. Each box has one colour throughout; fixed ones that stand in front of others in
/// all frames, as the front walls of a cage, are left out of all.
/// \param frames       recorded ones, or between these
/// \param direction_w  [-] from the boxes to the eye
std::vector<FilmFrame> shown_frames(const RecordedRun& run, std::span<const RecordedFrame> frames,
                                    const Vec3& direction_w);

/// Writes film.gif, film.mp4, film.gltf or view.html into the folder of the run. A file that cannot be finished
/// is not left half written.
/// \param request what was typed; its form is gif, mp4, gltf or html
/// \return the name of the file
/// \throws std::invalid_argument naming the value that is out of range
/// \throws CannotWrite if it cannot be written, or ffmpeg is missing, naming its package
std::string write_moving(const RenderRequest& request, const RecordedRun& run);

}  // namespace tumble::app
