/// \file
/// \brief Films and animated scenes of a recorded run.
#pragma once

#include "tumble/record/recorded_run.hpp"

#include "request.hpp"

#include <string>

namespace tumble::app {

/// Writes film.gif, film.mp4, film.gltf or view.html into the folder of the run. A file that cannot be finished
/// is not left half written.
/// \param request what was typed; its form is gif, mp4, gltf or html
/// \return the name of the file
/// \throws std::invalid_argument naming the value that is out of range
/// \throws CannotWrite if it cannot be written, or ffmpeg is missing, naming its package
std::string write_moving(const RenderRequest& request, const RecordedRun& run);

}  // namespace tumble::app
