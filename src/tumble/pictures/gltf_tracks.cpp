/// \file
/// \brief Following bodies through frames.
#include "tumble/pictures/gltf_tracks.hpp"

namespace tumble {

void add_numbers(const Vec3& v, std::vector<float>& list) {
  for (int k = 0; k < 3; ++k) list.push_back(static_cast<float>(v[k]));
}

void add_numbers(const Quat& q, std::vector<float>& list) {
  for (int k = 0; k < 4; ++k) list.push_back(static_cast<float>(q.coeffs()[k]));  // x y z w
}

std::vector<std::optional<GltfTrack>> gltf_tracks(const RecordedRun& run,
                                                  std::span<const RecordedFrame> frames) {
  std::vector<std::optional<GltfTrack>> tracks(run.scene.boxes.size());
  std::vector<Vec3> position_w(tracks.size());
  std::vector<Quat> orientation_wb(tracks.size());
  // Before a body appears it has the pose of its first frame, which is searched first.
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    for (const RecordedPose& pose : frame->poses) {
      const auto k = static_cast<std::size_t>(pose.box);
      tracks[k].emplace();
      position_w[k] = pose.position_w;
      orientation_wb[k] = pose.orientation_wb;
    }
  }
  for (const RecordedFrame& frame : frames) {
    std::vector<char> there(tracks.size(), 0);
    for (const RecordedPose& pose : frame.poses) {
      const auto k = static_cast<std::size_t>(pose.box);
      there[k] = 1;
      tracks[k]->moves = tracks[k]->moves || pose.position_w != position_w[k] ||
                         pose.orientation_wb.coeffs() != orientation_wb[k].coeffs();
      position_w[k] = pose.position_w;
      // q and -q are the same orientation; linear interpolation needs the one with a dot product >= 0
      // with the last key.
      const bool same_side = pose.orientation_wb.dot(orientation_wb[k]) >= 0.0;
      orientation_wb[k].coeffs() = (same_side ? 1.0 : -1.0) * pose.orientation_wb.coeffs();
    }
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      if (!tracks[k]) continue;
      add_numbers(position_w[k], tracks[k]->positions);
      add_numbers(orientation_wb[k], tracks[k]->orientations);
      tracks[k]->there.push_back(there[k]);
    }
  }
  return tracks;
}

}  // namespace tumble
