/// \file
/// \brief Films of bodies that stick, with steps so long that their joints are seen to open (thesis 6.2).
#pragma once

#include "driver/side_by_side.hpp"
#include "exterior_rotation/held_run.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

struct CoarseSteps {
  double step = 0.1;  // [s] at 1/60 s a gap is too small to be seen
  int steps = 11;
};

inline Film film_of(const HeldRun& run, const Camera& camera) {
  Film film;
  film.camera = camera;
  film.floor = has_ground(run.start);
  for (const HeldFrame& frame : run.frames)
    film.frames.push_back({frame.time, picture_boxes(run.world(frame))});
  return film;
}

// As close as it can be with all that moves in the picture: of what it falls off a part is enough.
inline Camera close_camera(const HeldRun& run) {
  constexpr int size = 320;  // [px] of each side
  std::vector<Vec3> corners_w;
  for (const HeldFrame& frame : run.frames) {
    for (std::size_t k = 0; k < frame.states.size(); ++k) {
      const BodyProperties& body = run.start.bodies()[k];
      if (!body.movable()) continue;
      for (const Vec3& corner_w : corners_of(box_of(body, frame.states[k])))
        corners_w.push_back(corner_w);
    }
  }
  const Vec3 direction_w(0.12, 0.12, 1.0);  // from the side on which it falls, and a little above
  return camera_for(corners_w, direction_w, size, size);
}

// Forward Euler, four times slowed down: on the left centres and orientations are moved apart, on the right each
// body by the exponential of its twist. A GIF.
inline std::string coarse_film(const World& start, const CoarseSteps& coarse) {
  constexpr double speed = 0.25;  // [-] of the film
  const auto run = [&](PoseUpdate pose) {
    return run_held(start, glued_options(GluedScheme::forward_euler, pose), coarse.step,
                    coarse.steps);
  };
  const HeldRun apart = run(PoseUpdate::separate);
  const Camera camera = close_camera(apart);
  return film_beside(film_of(apart, camera), film_of(run(PoseUpdate::exponential), camera),
                     speed / coarse.step);
}

}  // namespace tumble::chapters
