/// \file
/// \brief Bodies seen from the side, and a place of them magnified, as commands of gnuplot.
#pragma once

#include "tumble/pictures/polygon.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Style of a line of a side view.
struct LineLook {
  std::uint32_t colour = 0x404040;  // 0xRRGGBB
  double width = 1.0;               // [pt]
  bool dashed = false;              // or continuous
};

// A part of the plane z = 0, drawn in metres: x to the right, y up.
class SideView {
 public:
  // An empty view.
  // low: [m] lower left corner
  // high: [m] upper right corner, above and to the right of the other one
  SideView(const Vec2& low, const Vec2& high) : low_(low), high_(high) {}

  // Fills a polygon.
  // corners: [m] convex
  // opacity: [-] 0 to 1; below 1 overlap is darker
  void fill(const Polygon& corners, std::uint32_t colour, double opacity = 0.55);
  // Draws the edges of a polygon.
  // corners: [m] convex
  void outline(const Polygon& corners, const LineLook& look);
  // Draws a circle.
  // centre: [m]
  // radius: [m]
  void circle(const Vec2& centre, double radius, const LineLook& look);
  // Fills a circle.
  // centre: [m]
  // radius: [m]
  void dot(const Vec2& centre, double radius, std::uint32_t colour);
  // Draws a line.
  // from: [m]
  // to: [m]
  void line(const Vec2& from, const Vec2& to, const LineLook& look);
  // Draws the border of the view.
  void frame(const LineLook& look);
  // Writes a word.
  // where: [m] the middle of its foot
  void write(std::string_view text, const Vec2& where);

  // All of it, to be read in a multiplot after margins have been set in the view's proportions.
  [[nodiscard]] std::string commands() const;

 private:
  [[nodiscard]] Polygon inside(const Polygon& corners) const;

  Vec2 low_;
  Vec2 high_;
  std::string objects_;
  std::string circles_;
};

// The outline of a box seen along z [m]: its four corners, anticlockwise.
Polygon side_of(const BodyProperties& body, const BodyState& state);

// A frame of a film, the magnified place in it, and how large they are on paper.
struct FilmLayout {
  Vec2 low = Vec2::Zero();        // [m] lower left corner of what a frame shows
  Vec2 high = Vec2::Ones();       // [m] upper right corner
  double width = 294.0;           // [pt] of a frame
  double magnification = 50.0;    // [-] of the inset, over the frame
  Vec2 inset_low = Vec2::Zero();  // [m] where in the frame the inset's lower left corner is
  double inset = 96.0;            // [pt] its edge
  double bar = 0.01;              // [m] of the scale bar in the inset

  // Length of a metre of a frame [pt/m].
  [[nodiscard]] double scale() const { return width / (high.x() - low.x()); }
  // Part of the world that the inset shows [m]: its edge.
  [[nodiscard]] double seen() const { return inset / (scale() * magnification); }
  // Puts the inset into the upper left corner, with its own size.
  void put_inset_above();
  // The places of frames and insets, for a script.
  [[nodiscard]] Drawing drawing() const;
};

// A circle of a frame.
struct FilmCircle {
  Vec2 centre;    // [m]
  double radius;  // [m]
  LineLook look;  // of the line
};

// A frame: bodies, and marks beside them.
struct SideViewFrame {
  std::span<const BodyState> states;     // of the bodies that are filled, by index
  std::span<const BodyState> exact;      // the same, as they should be: dashed; may be empty
  std::vector<Vec2> pivots;              // [m] marked
  Vec2 magnified = Vec2::Zero();         // [m] the middle of the inset
  std::vector<FilmCircle> circles = {};  // in front of the bodies
};

// The colours of the film strips.
namespace film_colour {
inline constexpr std::uint32_t supporter = 0xdcdcdc;       // immovable bodies
inline constexpr std::uint32_t supporter_edge = 0x808080;  // their edges
inline constexpr std::uint32_t body = 0x56b4e9;            // others
inline constexpr std::uint32_t edge = 0x0072b2;            // their edges
inline constexpr std::uint32_t dark = 0x303030;            // what should be, and centres
inline constexpr std::uint32_t pivot = 0xd55e00;           // pivots, and circles about them
}  // namespace film_colour

// Number of frames of a strip.
inline constexpr int kFilmFrames = 2;

// Adds the settings of a strip.
// duration: [s] of the motion
// times: [s] of the frames
Parameters film_parameters(Parameters first, double duration,
                           const std::array<double, kFilmFrames>& times);

// The time of a frame [s].
double film_time(const Parameters& settings, int number);

// Draws a frame and its magnified place.
void add_film_frame(const World& world, const FilmLayout& layout, const SideViewFrame& frame,
                    int number, Result& result);

}  // namespace tumble::chapters
