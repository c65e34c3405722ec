/// \file
/// \brief Boxes coloured by their chatter (thesis 6.1).
#pragma once

#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

inline constexpr double kQuietest = 1e-3;  // [mm] the scale of colours begins here,
inline constexpr double kLoudest = 1e2;    // [mm] and ends here, a tenth of an edge of 1 m

// From blue to vermilion over a pale grey: lightness turns there only, and both ends differ
// for readers that do not see red or green.
// amplitude: [mm]
inline std::uint32_t chatter_colour(double amplitude) {
  constexpr std::uint32_t cold = 0x0072b2, middle = 0xf0ead2, hot = 0xd55e00;
  const double clipped = std::clamp(amplitude, kQuietest, kLoudest);
  const double place = elementary::log(clipped / kQuietest) / elementary::log(kLoudest / kQuietest);
  return place < 0.5 ? mixed(cold, middle, 2.0 * place) : mixed(middle, hot, 2.0 * place - 1.0);
}

// The scale as a table, for a bar.
inline Table chatter_colour_bar() {
  Table bar{"bar",
            {{"chatter_mm", "mm", "an amplitude"}, {"colour", "-", "its colour as 0xRRGGBB"}}};
  constexpr int shades = 100;
  for (int k = 0; k <= shades; ++k) {
    const double amplitude = kQuietest * elementary::pow(kLoudest / kQuietest, 1.0 * k / shades);
    bar.add(amplitude, chatter_colour(amplitude));
  }
  return bar;
}

// The boxes of a world, each in the colour of its chatter.
struct ChatterPicture {
  std::vector<PictureBox> boxes = {};  // those that move, dark grey if they do not rest
  double worst = 0.0;                  // [mm] chatter of those that rest
  int travelling = 0;                  // that do not rest
};

inline ChatterPicture coloured_by_chatter(const World& world, const ChatterMeter& meter) {
  constexpr std::uint32_t moving = 0x8a8a8a;  // does not rest, so chatter does not apply
  ChatterPicture picture{.boxes = picture_boxes(world)};
  const std::vector<BodyChatter> resting = meter.each(world.gravity_w.norm());
  auto next = resting.begin();  // both are in the order of ids
  std::size_t drawn = 0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    const bool rests = next != resting.end() && next->id == world.ids()[k];
    const double amplitude = rests ? 1e3 * (next++)->amplitude : 0.0;
    picture.boxes[drawn++].colour = rests ? chatter_colour(amplitude) : moving;
    picture.worst = std::max(picture.worst, amplitude);
    picture.travelling += rests ? 0 : 1;
  }
  return picture;
}

}  // namespace tumble::chapters
