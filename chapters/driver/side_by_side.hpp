/// \file
/// \brief Films of two runs beside each other.
#pragma once

#include "tumble/pictures/film.hpp"
#include "tumble/pictures/gif.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "driver/played_scene.hpp"

#include <functional>

namespace tumble::chapters {

// Rate of such films when they show every third step of 1/60 s.
inline constexpr double kThirdSteps = 20.0;  // [1/s]

// Frames of a run, one for every third step, or for another number of steps.
// from: [s] first time
// to: [s] last time, after `from`
// zero: [s] time of the run that the film calls 0
// change: of the boxes of a frame, such as a colour; may be empty
inline std::vector<FilmFrame> frames_of_run(
    const Scene& scene, const PlayedTechnique& technique, double from, double to, double zero = 0.0,
    const std::function<void(std::vector<PictureBox>&)>& change = {}, int every = 3) {
  PlayedScene played(scene, technique);
  std::vector<FilmFrame> frames;
  const auto take = [&] {
    frames.push_back({played.world().time() - zero, picture_boxes(played.world())});
    if (change) change(frames.back().boxes);
  };
  int steps = 0;
  played.advance(from);
  take();
  played.advance(to, [&](const StepReport&) {
    if (++steps % every == 0) take();
  });
  return frames;
}

// Films of the same times as a GIF, the first one on the left.
// rate: [1/s] frames in a second, 1 to 50
inline std::string film_beside(const Film& left, const Film& right, double rate) {
  const FilmPainter first(left);
  const FilmPainter second(right);
  return to_gif(film_delays(left, rate),
                [&](int frame) { return beside(first.painted(frame), second.painted(frame)); });
}

// The same for frames, seen by one camera.
// direction_w: [-] from the boxes to the eye
// width, height: [px] of each half
// floor: whether it is drawn
// rate: [1/s] frames in a second
inline std::string film_beside(const std::vector<FilmFrame>& left,
                               const std::vector<FilmFrame>& right, const Vec3& direction_w,
                               int width, int height, bool floor = true,
                               double rate = kThirdSteps) {
  std::vector<PictureBox> all;
  for (const std::vector<FilmFrame>* frames : {&left, &right})
    for (const FilmFrame& frame : *frames)
      all.insert(all.end(), frame.boxes.begin(), frame.boxes.end());
  const Camera camera = camera_for(all, direction_w, width, height, floor);
  return film_beside(Film{left, camera, floor}, Film{right, camera, floor}, rate);
}

}  // namespace tumble::chapters
