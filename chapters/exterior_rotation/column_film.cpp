/// \file
/// \brief A film of the column of figure 6.1.
#include "exterior_rotation/column_film.hpp"

#include "tumble/record/film.hpp"
#include "tumble/record/gif.hpp"
#include "tumble/record/world_picture.hpp"

#include "driver/played_scene.hpp"
#include "exterior_rotation/held_run.hpp"

#include <vector>

namespace tumble::chapters {
namespace {

constexpr double kStep = 0.1;  // [s] at 1/60 s a gap is too small to be seen
constexpr int kSteps = 11;
constexpr double kSpeed = 0.25;  // [-] of the film
constexpr int kWidth = 320;      // [px] of one column
constexpr int kHeight = 360;     // [px]

std::vector<FilmFrame> fall(const World& start, PoseUpdate pose) {
  GluedOptions options;
  options.scheme = GluedScheme::forward_euler;
  options.pose = pose;
  const HeldRun run = run_held(start, options, kStep, kSteps);
  std::vector<FilmFrame> frames;
  for (const HeldFrame& frame : run.frames)
    frames.push_back({frame.time, picture_boxes(run.world(frame))});
  return frames;
}

}  // namespace

std::string column_film(const Parameters& settings) {
  const World start =
      build_world(scene_with("fig6_1", {"count=" + std::to_string(settings.count("boxes")),
                                        setting("angle", settings.number("angle"))}));
  std::vector<FilmFrame> apart = fall(start, PoseUpdate::separate);
  std::vector<FilmFrame> together = fall(start, PoseUpdate::exponential);
  const Vec3 direction_w(0.12, 0.12, 1.0);  // from the side on which it falls, and a little above
  std::vector<FilmFrame> all = apart;
  all.insert(all.end(), together.begin(), together.end());
  const Camera camera =
      film_of(std::move(all), direction_w, kWidth, kHeight, has_ground(start)).camera;
  const Film left{std::move(apart), camera, has_ground(start)};
  const Film right{std::move(together), camera, has_ground(start)};
  return to_gif(film_delays(left, kSpeed / kStep),
                [&](int frame) { return beside(painted(left, frame), painted(right, frame)); });
}

}  // namespace tumble::chapters
