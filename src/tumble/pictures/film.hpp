/// \file
/// \brief Films: frames of boxes seen by one camera, with the time in a corner.
#pragma once

#include "tumble/pictures/picture.hpp"
#include "tumble/pictures/raster.hpp"

#include <string>
#include <vector>

namespace tumble {

/// A frame of a film.
struct FilmFrame {
  double time = 0.0;              ///< [s] displayed in it
  std::vector<PictureBox> boxes;  ///< its boxes
};

/// Frames and their camera.
struct Film {
  std::vector<FilmFrame> frames;  ///< times ascending
  Camera camera;                  ///< of all frames; its size is that of the film
  bool floor = true;              ///< whether the floor y = 0 is drawn
};

/// A film whose camera has all boxes in the picture at all times.
/// \param frames       at least one box in them
/// \param direction_w  [-] from the boxes to the eye, any length but 0, not vertical
/// \param width        [px] of the film
/// \param height       [px] of the film
/// \param floor        whether the floor y = 0 is drawn
/// \throws std::invalid_argument naming the value that is out of range
Film film_of(std::vector<FilmFrame> frames, const Vec3& direction_w, int width, int height,
             bool floor);

/// Paints the frames of a film.
/// \verified{All frames of a film are seen by one camera and have their time in a corner}
class FilmPainter {
 public:
  /// Finds the data that all frames share: the extent of the floor, and the decimals of the time.
  /// \param film  must outlive this object
  explicit FilmPainter(const Film& film);

  /// Paints a frame.
  /// \param frame  its number, from 0
  /// \return its pixels, with the time at the upper left: at least two decimals, and enough to distinguish frames
  /// \throws std::invalid_argument for an unknown frame, or as draw_boxes() does
  [[nodiscard]] Raster painted(int frame) const;

 private:
  const Film& film_;
  PictureBox around_;
  int decimals_;
};

/// Duration of each frame of a film with at least one: the last one is shown for a second more.
/// \param rate  [1/s] frames in a second, 1 to 50
/// \return [1/100 s] for each frame
/// \throws std::invalid_argument as gif_delays() does
std::vector<int> film_delays(const Film& film, double rate);

/// Writes a film as a GIF.
/// \param rate  [1/s] frames in a second, 1 to 50
/// \throws std::invalid_argument as FilmPainter and gif_delays() do
std::string to_gif(const Film& film, double rate);

}  // namespace tumble
