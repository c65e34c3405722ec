/// \file
/// \brief Recorded runs as animated scenes in glTF 2.0, for viewers and renderers.
#pragma once

#include "tumble/record/recorded_run.hpp"

#include <span>
#include <string>

namespace tumble {

/// Writes frames as an animated scene in one self-contained file: a JSON text with an embedded buffer.
///
/// There is one mesh, a box of edge 1, and for each body a node that scales it, in the colours of
/// picture_boxes(). Positions and orientations are interpolated linearly between keys, quaternions without
/// a change of sign. An absent box has the scale 0 (STEP), which glTF defines as invisible. Boxes that
/// never move have no animation. The ground is a thin box below y = 0. Times begin with 0 at the first frame.
/// \param frames  times ascending, at least one; frame_at() interpolates frames between the recorded ones
/// \param speed   [-] seconds of the run in a second of the animation, above 0
/// \return the bytes of the file; keys have single precision, as glTF requires
/// \throws std::invalid_argument for no frames, frames without a box, times that do not ascend, or a speed
///         not above 0
/// \verified{A glTF file that is read back has the poses of the trajectory at its keys}
/// \see glTF 2.0 specification. Khronos Group, 2021.
std::string to_gltf(const RecordedRun& run, std::span<const RecordedFrame> frames,
                    double speed = 1.0);

}  // namespace tumble
