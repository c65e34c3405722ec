/// \file
/// \brief Strokes of digits.
#include "tumble/pictures/lettering.hpp"

#include "tumble/base/error.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace tumble {
namespace {

constexpr double kTall = 6.0;    // units of a digit's height
constexpr double kThick = 0.42;  // half the width of a stroke
constexpr double kCorner = 0.7;  // of a joint's disc, an octagon: its diagonals over its radius

// A letter: strokes as lists of corners, in units from its upper left corner.
struct Letter {
  char sign;
  double width;  // with the space after it
  std::vector<Polygon> strokes;
};

const std::array<Letter, 14>& letters() {
  using P = Vec2;
  static const std::array<Letter, 14> all = {{
      {'0',
       5.6,
       {{P(1, 0), P(3, 0), P(4, 1.2), P(4, 4.8), P(3, 6), P(1, 6), P(0, 4.8), P(0, 1.2), P(1, 0)}}},
      {'1', 5.6, {{P(0.6, 1.3), P(2.2, 0), P(2.2, 6)}, {P(0.6, 6), P(3.8, 6)}}},
      {'2', 5.6, {{P(0, 1.2), P(1, 0), P(3, 0), P(4, 1), P(4, 2.2), P(0, 6), P(4, 6)}}},
      {'3',
       5.6,
       {{P(0, 0.9), P(1, 0), P(3, 0), P(4, 0.9), P(4, 2), P(3, 2.8), P(1.6, 2.8)},
        {P(3, 2.8), P(4, 3.7), P(4, 5), P(3, 6), P(1, 6), P(0, 5.1)}}},
      {'4', 5.6, {{P(3, 6), P(3, 0), P(0, 4.2), P(4.1, 4.2)}}},
      {'5',
       5.6,
       {{P(3.8, 0), P(0.5, 0), P(0.3, 2.9), P(1.2, 2.4), P(3, 2.4), P(4, 3.4), P(4, 4.9), P(3, 6),
         P(1, 6), P(0, 5.1)}}},
      {'6',
       5.6,
       {{P(3.8, 0.8), P(3, 0), P(1.2, 0), P(0, 1.4), P(0, 4.9), P(1, 6), P(3, 6), P(4, 5),
         P(4, 3.6), P(3, 2.6), P(1, 2.6), P(0, 3.5)}}},
      {'7', 5.6, {{P(0, 0), P(4, 0), P(1.5, 6)}}},
      {'8',
       5.6,
       {{P(1, 2.8), P(0, 2), P(0, 0.9), P(1, 0), P(3, 0), P(4, 0.9), P(4, 2), P(3, 2.8), P(1, 2.8),
         P(0, 3.7), P(0, 5.1), P(1, 6), P(3, 6), P(4, 5.1), P(4, 3.7), P(3, 2.8)}}},
      {'9',
       5.6,
       {{P(0.2, 5.2), P(1, 6), P(2.8, 6), P(4, 4.6), P(4, 1.1), P(3, 0), P(1, 0), P(0, 1),
         P(0, 2.4), P(1, 3.4), P(3, 3.4), P(4, 2.5)}}},
      {'.', 2.0, {{P(0.3, 5.9), P(0.31, 5.9)}}},
      {'-', 5.6, {{P(0.6, 3.2), P(3.4, 3.2)}}},
      {' ', 2.8, {}},
      {'s',
       4.6,
       {{P(3, 2.9), P(2.4, 2.4), P(0.8, 2.4), P(0.1, 3), P(0.1, 3.5), P(0.8, 4.1), P(2.4, 4.3),
         P(3.1, 4.8), P(3.1, 5.4), P(2.4, 6), P(0.7, 6), P(0, 5.4)}}},
  }};
  return all;
}

const Letter& letter_of(char sign) {
  for (const Letter& letter : letters())
    if (letter.sign == sign) return letter;
  std::string complaint = "lettering of '?': expected digits, points, hyphens, blanks and s";
  complaint[complaint.find('?')] = sign;
  throw std::invalid_argument(complaint);
}

// A stroke and a round end: neighbours of a line share their ends.
void add_stroke(const Vec2& from, const Vec2& to, double half, std::vector<Polygon>& loops) {
  const Vec2 along = half * (to - from).normalized();
  const Vec2 across(-along.y(), along.x());
  loops.push_back({from - across, to - across, to + across, from + across});
  for (const Vec2& end : {from, to}) {
    Polygon disc;
    for (const Vec2& turn :
         {Vec2(1, 0), Vec2(kCorner, kCorner), Vec2(0, 1), Vec2(-kCorner, kCorner), Vec2(-1, 0),
          Vec2(-kCorner, -kCorner), Vec2(0, -1), Vec2(kCorner, -kCorner)})
      disc.emplace_back(end + half * turn);
    loops.push_back(std::move(disc));
  }
}

}  // namespace

PictureArea lettering(std::string_view text, const Vec2& corner, double height,
                      std::uint32_t colour) {
  require::positive(height, "height of lettering");
  const double unit = height / kTall;
  PictureArea area{.colour = colour};
  Vec2 place = corner;
  for (const char sign : text) {
    const Letter& letter = letter_of(sign);
    for (const Polygon& line : letter.strokes)
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        add_stroke(place + unit * line[k], place + unit * line[k + 1], kThick * unit, area.loops);
    place.x() += unit * letter.width;
  }
  return area;
}

}  // namespace tumble
