/// \file
/// \brief Films.
#include "tumble/pictures/film.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/pictures/gif.hpp"
#include "tumble/pictures/lettering.hpp"

#include <algorithm>
#include <limits>

namespace tumble {
namespace {

constexpr std::uint32_t kInk = 0x202020;
constexpr double kPause = 1.0;           // [s] at the end
constexpr double kLetterShare = 0.04;    // height of a digit over that of the picture
constexpr double kSmallestLetter = 9.0;  // [px]

// The floor is drawn around all boxes of the film: this box contains them.
PictureBox around(const Film& film) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const FilmFrame& frame : film.frames) {
    for (const PictureBox& drawn : frame.boxes) {
      for (const Vec3& corner_w : corners_of(drawn.box)) {
        low = low.cwiseMin(corner_w);
        high = high.cwiseMax(corner_w);
      }
    }
  }
  return {make_box(0.5 * (low + high), Quat::Identity(), high - low)};
}

// Two decimals, or as many as distinguish all frames.
int decimals_of(const Film& film) {
  if (film.frames.size() < 2) return 2;
  const double interval = (film.frames.back().time - film.frames.front().time) /
                          static_cast<double>(film.frames.size() - 1);
  int decimals = 2;
  for (double step = 0.01; step > interval && decimals < 6; step *= 0.1) ++decimals;
  return decimals;
}

}  // namespace

Film film_of(std::vector<FilmFrame> frames, const Vec3& direction_w, int width, int height,
             bool floor) {
  std::vector<PictureBox> all;
  for (const FilmFrame& frame : frames)
    all.insert(all.end(), frame.boxes.begin(), frame.boxes.end());
  return {std::move(frames), camera_for(all, direction_w, width, height, floor), floor};
}

FilmPainter::FilmPainter(const Film& film)
    : film_(film), around_(around(film)), decimals_(decimals_of(film)) {}

Raster FilmPainter::painted(int frame) const {
  require::that(
      frame >= 0 && static_cast<std::size_t>(frame) < film_.frames.size(),
      "frame " + std::to_string(frame) + ": the film has " + std::to_string(film_.frames.size()));
  const FilmFrame& shown = film_.frames[static_cast<std::size_t>(frame)];
  Picture picture = draw_boxes(shown.boxes, film_.camera, film_.floor, {&around_, 1});
  const double letter = std::max(kSmallestLetter, kLetterShare * film_.camera.height);
  picture.areas.push_back(
      lettering(fixed_text(shown.time, decimals_) + " s", Vec2(letter, letter), letter, kInk));
  return rasterised(picture);
}

std::vector<int> film_delays(const Film& film, double rate) {
  return gif_delays(static_cast<int>(film.frames.size()), rate, kPause);
}

std::string to_gif(const Film& film, double rate) {
  const FilmPainter painter(film);
  return to_gif(film_delays(film, rate), [&](int frame) { return painter.painted(frame); });
}

}  // namespace tumble
