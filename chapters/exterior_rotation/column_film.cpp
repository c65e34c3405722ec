/// \file
/// \brief A film of the column of figure 6.1.
#include "exterior_rotation/column_film.hpp"

#include "tumble/pictures/film.hpp"
#include "tumble/pictures/gif.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "driver/played_scene.hpp"
#include "exterior_rotation/held_run.hpp"

#include <vector>

namespace tumble::chapters {
namespace {

constexpr double kCoarseStep = 0.1;  // [s] at 1/60 s a gap is too small to be seen
constexpr int kSteps = 11;
constexpr double kSpeed = 0.25;  // [-] of the film
constexpr int kSize = 320;       // [px] of each side

HeldRun fall(const World& start, PoseUpdate pose) {
  GluedOptions options;
  options.scheme = GluedScheme::forward_euler;
  options.pose = pose;
  return run_held(start, options, kCoarseStep, kSteps);
}

Film film_of(const HeldRun& run, const Camera& camera) {
  Film film;
  film.camera = camera;
  film.floor = has_ground(run.start);
  for (const HeldFrame& frame : run.frames)
    film.frames.push_back({frame.time, picture_boxes(run.world(frame))});
  return film;
}

// As close as it can be with all of the column in the picture: of what it falls off a part is enough.
Camera camera_of(const HeldRun& run) {
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
  return camera_for(corners_w, direction_w, kSize, kSize);
}

}  // namespace

std::string column_film(const Parameters& settings) {
  const World start =
      build_world(scene_with("fig6_1", {"count=" + std::to_string(settings.count("boxes")),
                                        setting("angle", settings.number("angle"))}));
  const HeldRun apart = fall(start, PoseUpdate::separate);
  const Camera camera = camera_of(apart);
  const Film left = film_of(apart, camera);
  const Film right = film_of(fall(start, PoseUpdate::exponential), camera);
  const FilmPainter first(left);
  const FilmPainter second(right);
  return to_gif(film_delays(left, kSpeed / kCoarseStep),
                [&](int frame) { return beside(first.painted(frame), second.painted(frame)); });
}

}  // namespace tumble::chapters
