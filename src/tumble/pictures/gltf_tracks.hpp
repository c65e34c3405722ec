/// \file
/// \brief The ways of bodies through frames, as the keys of a glTF animation.
#pragma once

#include "tumble/record/recorded_run.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// The way of one body through all frames.
struct GltfTrack {
  std::vector<float>
      positions;  ///< [m] x y z for each frame; where it is not there, of one where it is
  std::vector<float> orientations;  ///< [-] x y z w, likewise; neighbours are on the same side
  std::vector<char> there;          ///< whether it is there, for each frame
  bool moves = false;               ///< whether two of its poses differ
};

/// Follows every body.
/// \param run     of which the frames are
/// \param frames  times ascending
/// \return for each box of the scene; none for one that no frame has
std::vector<std::optional<GltfTrack>> gltf_tracks(const RecordedRun& run,
                                                  std::span<const RecordedFrame> frames);

/// Adds numbers in single precision to a list.
/// \param v     x, y, z
/// \param list  what they are added to
void add_numbers(const Vec3& v, std::vector<float>& list);

/// Adds numbers in single precision to a list.
/// \param q     a quaternion
/// \param list  what x, y, z and w are added to, in the order of glTF
void add_numbers(const Quat& q, std::vector<float>& list);

}  // namespace tumble
