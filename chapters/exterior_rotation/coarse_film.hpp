/// \file
/// \brief Films of bodies that stick, with steps so long that their joints are seen to open (thesis 6.2).
#pragma once

#include "driver/side_by_side.hpp"
#include "exterior_rotation/held_run.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tumble::chapters {

struct CoarseSteps {
  double step = 0.1;  // [s] at 1/60 s a gap is too small to be seen
  int steps = 11;
  double enlarged = 5.0;  // [-] by the lens
};

inline Film film_of(const HeldRun& run, const Camera& camera) {
  Film film{.camera = camera, .floor = has_ground(run.start)};
  for (const HeldFrame& frame : run.frames)
    film.frames.push_back({frame.time, picture_boxes(run.world(frame))});
  return film;
}

// As close as it can be with all that moves in the picture, and with room for a lens below on the right: of what
// it falls off a part is enough.
inline Camera close_camera(const HeldRun& run) {
  constexpr int size = 320;  // [px] of each side
  std::vector<Vec3> corners_w;
  double least_x = 0.0;
  double most_x = 0.0;
  for (const HeldFrame& frame : run.frames) {
    for (std::size_t k = 0; k < frame.states.size(); ++k) {
      const BodyProperties& body = run.start.bodies()[k];
      if (!body.movable()) continue;
      for (const Vec3& corner_w : corners_of(box_of(body, frame.states[k]))) {
        least_x = corners_w.empty() ? corner_w.x() : std::min(least_x, corner_w.x());
        most_x = corners_w.empty() ? corner_w.x() : std::max(most_x, corner_w.x());
        corners_w.push_back(corner_w);
      }
    }
  }
  const Vec3 lowest_w = *std::ranges::min_element(
      corners_w, [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  constexpr double room = 0.3;  // for the lens, over the width of the motion
  corners_w.emplace_back(most_x + room * (most_x - least_x), lowest_w.y(), lowest_w.z());
  const Vec3 direction_w(0.12, 0.12, 1.0);  // from the side on which it falls, and a little above
  return camera_for(corners_w, direction_w, size, size);
}

// The point at which the highest joint is seen to open: its end on the pivot's side, or its edge.
inline Vec3 seen_joint(const HeldRun& run, const HeldFrame& frame) {
  const Joint& joint = run.joints.back();
  const Vec3 held_w = held_point(joint, frame.states).first_w;
  if (joint.hold != JointHold::area) return held_w + Vec3(0.0, 0.0, 0.5);  // its nearer end
  return held_w + frame.states[idx(joint.first)].orientation_wb * Vec3(0.5, 0.0, 0.5);
}

// A frame with a lens: the point is drawn again below on the right, enlarged, without shadows of the floor.
inline Raster with_lens(const Film& film, int frame, const FilmPainter& painter,
                        const Vec3& point_w, double enlarged) {
  constexpr int size = 108;            // [px] of the lens
  constexpr std::uint8_t dark = 0x20;  // its edge
  const std::vector<PictureBox>& boxes = film.frames[idx(frame)].boxes;
  const Vec3 direction_w(0.12, 0.03,
                         1.0);  // lower than that of the film: a gap above a surface is seen
  Camera near = film.camera;
  near.target_w = point_w;
  near.eye_w =
      point_w + (film.camera.eye_w - film.camera.target_w).norm() * direction_w.normalized();
  near.field_of_view *= size / (enlarged * near.height);
  near.width = near.height = size;
  const Raster lens = rasterised(draw_boxes(boxes, near, false));
  Raster out = painter.painted(frame);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < 3 * size; ++x) {
      const bool edge = std::min({x / 3, y, size - 1 - x / 3, size - 1 - y}) < 2;
      const int at = 3 * ((out.height - size + y - 4) * out.width + out.width - size - 4) + x;
      out.rgb[idx(at)] = edge ? dark : lens.rgb[static_cast<std::size_t>(3 * size * y + x)];
    }
  }
  return out;
}

// Forward Euler, four times slowed down: on the left centres and orientations are moved apart, on the right each
// body by the exponential of its twist. A lens shows the highest joint. A GIF.
inline std::string coarse_film(const World& start, const CoarseSteps& coarse) {
  constexpr double speed = 0.25;  // [-] of the film
  const auto run = [&](PoseUpdate pose) {
    return run_held(start, glued_options(GluedScheme::forward_euler, pose), coarse.step,
                    coarse.steps);
  };
  const HeldRun apart = run(PoseUpdate::separate);
  const HeldRun arcs = run(PoseUpdate::exponential);
  const Camera camera = close_camera(apart);
  const Film left = film_of(apart, camera);
  const Film right = film_of(arcs, camera);
  const FilmPainter first(left);
  const FilmPainter second(right);
  return to_gif(film_delays(left, speed / coarse.step), [&](int frame) {
    const auto k = idx(frame);
    return beside(
        with_lens(left, frame, first, seen_joint(apart, apart.frames[k]), coarse.enlarged),
        with_lens(right, frame, second, seen_joint(arcs, arcs.frames[k]), coarse.enlarged));
  });
}

}  // namespace tumble::chapters
