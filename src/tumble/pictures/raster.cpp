/// \file
/// \brief Rasterisation of convex polygons, antialiased.
#include "tumble/pictures/raster.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace tumble {
namespace {

constexpr int kPoints = 4;            // of a pixel along each of its edges
constexpr unsigned kAllPoints = 0xf;  // one row of them
constexpr double kOutline = 0.4;      // [px] half the width of an outline
constexpr double kMostPixels = 1e4;

// Intersection of a horizontal line with a convex polygon; empty if `right` is less than `left`.
struct Span {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
};

Span span_at(const Polygon& polygon, double y) {
  Span span;
  if (polygon.size() < 3) return span;  // a line has no inside
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2& b = polygon[(k + 1) % polygon.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y()));
    span.left = std::min(span.left, x);
    span.right = std::max(span.right, x);
  }
  return span;
}

// A stroke from one point to another, longer at both ends by half its width.
Polygon stroke(const Vec2& from, const Vec2& to) {
  const Vec2 along = kOutline * (to - from).normalized();
  const Vec2 across(-along.y(), along.x());
  return {from - along - across, to + along - across, to + along + across, from - along + across};
}

constexpr std::int32_t kWhole = 1 << 16;  // a share of 1

// Number of bits of a byte.
constexpr std::array<std::uint8_t, 256> kBits = [] {
  std::array<std::uint8_t, 256> bits{};
  for (std::size_t k = 0; k < bits.size(); ++k)
    bits[k] = static_cast<std::uint8_t>(std::popcount(k));
  return bits;
}();

// The colour of an area, with its share of a pixel by the number of covered points.
struct Paint {
  std::array<std::uint8_t, 3> rgb{};
  std::array<std::int32_t, kPoints * kPoints + 1> shares{};

  Paint(std::uint32_t colour, double opacity)
      : rgb{static_cast<std::uint8_t>(colour >> 16U), static_cast<std::uint8_t>(colour >> 8U),
            static_cast<std::uint8_t>(colour)} {
    for (std::size_t k = 0; k < shares.size(); ++k)
      shares[k] = static_cast<std::int32_t>(
          std::lround(kWhole * opacity * static_cast<double>(k) / (kPoints * kPoints)));
  }
};

class Canvas {
 public:
  Canvas(int width, int height) {
    raster_.width = width;
    raster_.height = height;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    raster_.rgb.assign(3 * pixels, 0xff);
    covered_.assign(static_cast<std::size_t>(width), 0);
  }

  // Fills the union of the polygons.
  void fill(const std::vector<Polygon>& polygons, std::uint32_t colour, double opacity);
  Raster take() { return std::move(raster_); }

 private:
  void cover(const Span& span, int row);
  void blend(int y, const Paint& paint);

  Raster raster_;
  // For the row being painted: a bit for each covered point of a pixel, and the range of pixels with
  // any.
  std::vector<std::uint16_t> covered_;
  int first_ = 0, last_ = -1;
  // For the polygons being filled: the range of rows of each.
  struct Extent {
    double low, high;
  };
  std::vector<Extent> extents_;
};

void Canvas::fill(const std::vector<Polygon>& polygons, std::uint32_t colour, double opacity) {
  const Paint paint(colour, opacity);
  double top = raster_.height;
  double bottom = 0.0;
  extents_.clear();
  for (const Polygon& polygon : polygons) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec2& p : polygon) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    extents_.push_back({low, high});
    top = std::min(top, low);
    bottom = std::max(bottom, high);
  }
  const int from = static_cast<int>(std::max(0.0, std::floor(top)));
  const int to = static_cast<int>(std::min<double>(raster_.height, std::ceil(bottom)));
  for (int y = from; y < to; ++y) {
    first_ = raster_.width;
    last_ = -1;
    for (std::size_t k = 0; k < polygons.size(); ++k) {
      if (extents_[k].high < y || extents_[k].low > y + 1) continue;
      for (int row = 0; row < kPoints; ++row)
        cover(span_at(polygons[k], y + (row + 0.5) / kPoints), row);
    }
    if (first_ <= last_) blend(y, paint);
  }
}

// Marks the points of a row that are in a span: point k is at (k + 1/2)/4.
void Canvas::cover(const Span& span, int row) {
  if (!(span.left <= span.right)) return;
  const double most = static_cast<double>(raster_.width) * kPoints - 1.0;
  const double left = std::ceil(span.left * kPoints - 0.5);
  const double right = std::floor(span.right * kPoints - 0.5);
  if (left > most || right < 0.0 || left > right) return;
  const int a = static_cast<int>(std::max(0.0, left));
  const int b = static_cast<int>(std::min(most, right));
  const int shift = row * kPoints;
  const auto mark = [&](int x, unsigned points) {
    covered_[static_cast<std::size_t>(x)] |= static_cast<std::uint16_t>(points << shift);
  };
  const unsigned from = kAllPoints << static_cast<unsigned>(a % kPoints);
  const unsigned to = kAllPoints >> static_cast<unsigned>(kPoints - 1 - b % kPoints);
  if (a / kPoints == b / kPoints) {
    mark(a / kPoints, kAllPoints & from & to);
  } else {
    mark(a / kPoints, kAllPoints & from);
    for (int x = a / kPoints + 1; x < b / kPoints; ++x) mark(x, kAllPoints);
    mark(b / kPoints, to);
  }
  first_ = std::min(first_, a / kPoints);
  last_ = std::max(last_, b / kPoints);
}

// Blends the colour into the row by the share of covered points, and clears these.
void Canvas::blend(int y, const Paint& paint) {
  const bool opaque = paint.shares.back() == kWhole;
  std::uint8_t* pixel =
      raster_.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * raster_.width + first_);
  for (int x = first_; x <= last_; ++x, pixel += 3) {
    const std::uint16_t points = std::exchange(covered_[static_cast<std::size_t>(x)], 0);
    if (points == 0) continue;
    if (opaque && points == 0xffff) {
      for (std::size_t k = 0; k < 3; ++k) pixel[k] = paint.rgb[k];
      continue;
    }
    const std::int32_t share =
        paint.shares[static_cast<std::size_t>(kBits[points & 0xffU] + kBits[points >> 8U])];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t before = pixel[k];
      pixel[k] = static_cast<std::uint8_t>(before +
                                           (((paint.rgb[k] - before) * share + kWhole / 2) >> 16));
    }
  }
}

}  // namespace

Raster rasterised(const Picture& picture) {
  require::within(picture.width, 1.0, kMostPixels, "width of the picture");
  require::within(picture.height, 1.0, kMostPixels, "height of the picture");
  Canvas canvas(static_cast<int>(picture.width), static_cast<int>(picture.height));
  for (const PictureArea& area : picture.areas) {
    canvas.fill(area.loops, area.colour, area.opacity);
    if (!area.outlined) continue;
    std::vector<Polygon> strokes;
    for (const Polygon& loop : area.loops) {
      const std::size_t edges = loop.size() > 2 ? loop.size() : loop.size() / 2;
      for (std::size_t k = 0; k < edges; ++k) {
        const Vec2& next = loop[(k + 1) % loop.size()];
        if (next != loop[k]) strokes.push_back(stroke(loop[k], next));
      }
    }
    canvas.fill(strokes, area.outline, 1.0);
  }
  return canvas.take();
}

Raster beside(const Raster& left, const Raster& right) {
  require::that(left.height == right.height, "heights " + std::to_string(left.height) + " and " +
                                                 std::to_string(right.height) +
                                                 ": expected equal ones");
  Raster out{left.width + right.width, left.height, {}};
  for (int y = 0; y < left.height; ++y) {
    for (const Raster* part : {&left, &right}) {
      const auto row = static_cast<std::ptrdiff_t>(3) * part->width;
      out.rgb.insert(out.rgb.end(), part->rgb.begin() + y * row, part->rgb.begin() + (y + 1) * row);
    }
  }
  return out;
}

}  // namespace tumble
