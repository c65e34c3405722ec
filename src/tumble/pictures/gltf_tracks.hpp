/// \file
/// \brief Trajectories of bodies as the keys of a glTF animation.
#pragma once

#include "tumble/record/recorded_run.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// The trajectory of one body.
struct GltfTrack {
  std::vector<float>
      positions;  ///< [m] x y z for each frame; where it is absent, of a frame that has it
  std::vector<float> orientations;  ///< [-] x y z w, likewise; neighbours have a dot product >= 0
  std::vector<char> there;          ///< whether it is present, for each frame
  bool moves = false;               ///< whether two of its poses differ
};

/// Collects the trajectory of each body.
/// \param frames  its frames, times ascending
/// \return for each box of the scene; none for one that is in no frame
std::vector<std::optional<GltfTrack>> gltf_tracks(const RecordedRun& run,
                                                  std::span<const RecordedFrame> frames);

/// Adds numbers in single precision to a list.
void add_numbers(const Vec3& v, std::vector<float>& list);

/// Adds numbers in single precision to a list.
/// \param list  receives x, y, z and w, in the order of glTF
void add_numbers(const Quat& q, std::vector<float>& list);

}  // namespace tumble
