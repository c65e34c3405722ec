/// \file
/// \brief Clips a parallelogram to a rectangle, one side at a time.
#include "tumble/geometry/rectangle_clip.hpp"

#include <bit>
#include <cassert>
#include <utility>

namespace tumble {
namespace {

// Where the edge between two corners, one of them beyond the side x_k = at and the other not,
// crosses it.
template <std::size_t k>
void cross(const ClipCorner& from, const ClipCorner& to, double at, std::size_t line,
           ClipCorner& out) {
  constexpr std::size_t other = 1 - k;
  const double t = (at - from.x[k]) / (to.x[k] - from.x[k]);
  out.x[k] = at;
  out.x[other] = from.x[other] + t * (to.x[other] - from.x[other]);
  out.x[2] = from.x[2] + t * (to.x[2] - from.x[2]);
  out.line = line;
}

// Cuts off what lies beyond x_k = half, or x_k = -half for the low side (Sutherland and Hodgman 1974). The area is convex, so the
// corners beyond follow each other, and two take their place: where the boundary reaches the side
// and follows it, and where it leaves it again on the edge that it came back on. Returns false,
// without writing, if there is nothing to cut off.
template <std::size_t k, bool high>
bool cut(const ClipArea& in, double half, ClipArea& out) {
  constexpr std::size_t line = 4 + 2 * k + (high ? 1 : 0);
  const double at = high ? half : -half;
  const std::size_t n = in.count;
  unsigned beyond = 0;  // bit i: corner i
  for (std::size_t i = 0; i < n; ++i)
    beyond |= static_cast<unsigned>(high ? in.corners[i].x[k] > at : in.corners[i].x[k] < at) << i;
  if (beyond == 0) return false;
  const unsigned all = (1U << n) - 1U;
  out.count = 0;
  if (beyond == all) return true;

  // The first corner beyond, the one after the last, and the corner before the first.
  const unsigned after_one_beyond = (beyond << 1U | beyond >> (n - 1)) & all;
  const auto first = static_cast<std::size_t>(std::countr_zero(beyond & ~after_one_beyond));
  const auto run = static_cast<std::size_t>(std::countr_one((beyond | beyond << n) >> first));
  const auto wrapped = [n](std::size_t i) { return i < n ? i : i - n; };
  const std::size_t last = wrapped(first + run - 1), back = wrapped(last + 1);
  const std::size_t before = first == 0 ? n - 1 : first - 1;

  cross<k>(in.corners[before], in.corners[first], at, line, out.corners[0]);
  cross<k>(in.corners[last], in.corners[back], at, in.corners[last].line, out.corners[1]);
  out.count = 2 + n - run;
  for (std::size_t i = 2, from = back; i < out.count; ++i, from = wrapped(from + 1))
    out.corners[i] = in.corners[from];
  return true;
}

}  // namespace

const ClipArea& clip_to_rectangle(ClipArea& area, ClipArea& scratch, double half_x, double half_y) {
  assert(area.count == 4);
  ClipArea *now = &area, *next = &scratch;
  if (cut<0, false>(*now, half_x, *next)) std::swap(now, next);
  if (cut<0, true>(*now, half_x, *next)) std::swap(now, next);
  if (cut<1, false>(*now, half_y, *next)) std::swap(now, next);
  if (cut<1, true>(*now, half_y, *next)) std::swap(now, next);
  return *now;
}

}  // namespace tumble
