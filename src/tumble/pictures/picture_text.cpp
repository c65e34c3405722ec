/// \file
/// \brief A picture as commands of gnuplot and as SVG.
#include "tumble/base/number_text.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/picture.hpp"

namespace tumble {
namespace {

// A tenth of a pixel is below visibility.
std::string pair_text(double x, double y, char separator) {
  return fixed_text(x, 1).append(1, separator).append(fixed_text(y, 1));
}

std::string share_text(double share) { return fixed_text(share, 4); }

std::string whole_text(double pixels) { return fixed_text(pixels, 0); }

// gnuplot's polygons have one loop: further loops are joined by a bridge of no width.
Polygon joined(const std::vector<Polygon>& loops) {
  Polygon out;
  for (const Polygon& loop : loops) {
    out.insert(out.end(), loop.begin(), loop.end());
    out.push_back(loop.front());
    if (&loop != &loops.front()) out.push_back(loops.front().front());
  }
  return out;
}

}  // namespace

std::string to_gnuplot(const Picture& picture) {
  std::string out = "unset object; unset key; unset border; unset tics\n";
  out += "set margins 0,0,0,0; set size ratio " + share_text(picture.height / picture.width);
  out += "; set xrange [0:" + whole_text(picture.width);
  out += "]; set yrange [0:" + whole_text(picture.height) + "]\n";
  // From the last one drawn to the first: gnuplot looks for the place of each among those of lower numbers.
  for (std::size_t number = picture.areas.size(); number > 0; --number) {
    const PictureArea& area = picture.areas[number - 1];
    out += "set object " + std::to_string(number) + " polygon";
    const char* join = " from ";
    for (const Vec2& p : joined(area.loops)) {  // y goes up in gnuplot
      out += join + pair_text(p.x(), picture.height - p.y(), ',');
      join = " to ";
    }
    out += " fc rgb '" + colour_text(area.colour) + "' fs ";
    if (area.opacity < 1.0) out += "transparent ";
    out += "solid " + share_text(area.opacity);
    if (area.outlined) {
      out += " border lc rgb '" + colour_text(area.outline) + "' lw 0.7\n";
    } else {
      out += " noborder\n";
    }
  }
  return out + "plot NaN\n";
}

std::string to_svg(const Picture& picture) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  out += whole_text(picture.width) + ' ' + whole_text(picture.height);
  out += "\" stroke-linejoin=\"round\" stroke-width=\"0.8\">\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const PictureArea& area : picture.areas) {
    out += "<path d=\"";
    for (const Polygon& loop : area.loops) {
      char join = 'M';
      for (const Vec2& p : loop) {
        out += join + pair_text(p.x(), p.y(), ' ');
        join = 'L';
      }
      out += 'z';
    }
    out += "\" fill=\"" + colour_text(area.colour) + '"';
    if (area.opacity < 1.0) out += " fill-opacity=\"" + share_text(area.opacity) + '"';
    if (area.outlined) out += " stroke=\"" + colour_text(area.outline) + '"';
    out += "/>\n";
  }
  return out + "</svg>\n";
}

}  // namespace tumble
