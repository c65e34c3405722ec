/// \file
/// \brief The boxes in view and their colours.
#include "frames.hpp"

#include "tumble/pictures/world_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::app {
namespace {

// Whether the straight way between two points runs into a box: the part of it inside the slabs of
// all three axes is not empty.
bool hides(const Box& box, const Vec3& from_w, const Vec3& to_w) {
  const Vec3 start_b = box.axes_w.transpose() * (from_w - box.center_w);
  const Vec3 way_b = box.axes_w.transpose() * (to_w - from_w);
  double enter = 0.0;
  double leave = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double low = (-box.half[k] - start_b[k]) / way_b[k];
    const double high = (box.half[k] - start_b[k]) / way_b[k];
    if (way_b[k] == 0.0 && std::abs(start_b[k]) > box.half[k]) return false;
    if (way_b[k] == 0.0) continue;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter < leave;
}

// A box between the eye and the middle of a movable one.
bool stands_in_front(const RecordedRun& run, const RecordedFrame& frame, const Box& box,
                     const Vec3& direction_w) {
  for (const RecordedPose& pose : frame.poses) {
    if (run.scene.boxes[static_cast<std::size_t>(pose.box)].fixed) continue;
    const double far = (box.center_w - pose.position_w).norm() + box.half.norm();
    if (hides(box, pose.position_w, pose.position_w + far * direction_w.normalized())) return true;
  }
  return false;
}

// All boxes that there ever are: colours do not depend on which are present.
std::vector<PictureBox> coloured(const Scene& scene) {
  World world;
  for (const SceneBox& box : scene.boxes) {
    const BodyProperties body = properties_of(box);
    world.add(body, make_state(body, box.position_w, box.orientation_wb), box.name);
  }
  return picture_boxes(world);
}

}  // namespace

std::vector<FilmFrame> shown_frames(const RecordedRun& run, std::span<const RecordedFrame> frames,
                                    const Vec3& direction_w) {
  const std::vector<PictureBox> boxes = coloured(run.scene);
  const auto drawn = [&](const RecordedPose& pose) {
    const auto k = static_cast<std::size_t>(pose.box);
    PictureBox out = boxes[k];
    out.box = make_box(pose.position_w, pose.orientation_wb, run.scene.boxes[k].size);
    return out;
  };
  std::vector<std::size_t> in_front(boxes.size(), 0);  // in how many frames
  for (const RecordedFrame& frame : frames)
    for (const RecordedPose& pose : frame.poses)
      if (const auto k = static_cast<std::size_t>(pose.box);
          run.scene.boxes[k].fixed && stands_in_front(run, frame, drawn(pose).box, direction_w))
        ++in_front[k];
  std::vector<FilmFrame> shown;
  for (const RecordedFrame& frame : frames) {
    shown.push_back({frame.time, {}});
    for (const RecordedPose& pose : frame.poses)
      if (in_front[static_cast<std::size_t>(pose.box)] < frames.size())
        shown.back().boxes.push_back(drawn(pose));
  }
  return shown;
}

}  // namespace tumble::app
