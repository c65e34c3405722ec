/// \file
/// \brief The closest points of two edges.
#include "tumble/geometry/edge_crossing.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// Two edges P + x A and Q + y B of half lengths a and b, seen from the gap Q - P.
struct EdgePair {
  double a, b;                       // [m]
  double along_first, along_second;  // [m] gap . A, gap . B
  double cosine, sine2;              // [-] of the angle between them; the sine is squared
};

// Where the edges are closest to each other, and whether they pass each other there.
struct Crossing {
  double x, y;  // [m] along the first and the second edge, from their middles
  bool within;  // whether neither had to be held to its edge
  double half;  // [m] of the stretch that they share, if they are parallel
};

// The middle of the stretch in which two parallel edges lie beside each other, or the ends that are
// closest.
Crossing beside(const EdgePair& e) {
  const double reach = e.b * std::abs(e.cosine), slack = tolerance::same_point * e.a;
  const double from = std::max(-e.a, e.along_first - reach);
  const double to = std::min(e.a, e.along_first + reach);
  const double x = std::clamp(0.5 * (from + to), -e.a, e.a);
  return {x, std::clamp(e.cosine * x - e.along_second, -e.b, e.b), from <= to + slack,
          std::max(0.0, 0.5 * (to - from))};
}

// The closest points of the two lines if both lie on the edges. Otherwise one is held to its edge,
// the other one is the point closest to it, and the first follows. Where the edges are nearly
// parallel so too, because rounding has to move both points together.
Crossing closest_points(const EdgePair& e) {
  if (e.sine2 < tolerance::edges_side_by_side * tolerance::edges_side_by_side) return beside(e);
  const double on_first = (e.along_first - e.cosine * e.along_second) / e.sine2;
  const double on_second = (e.cosine * e.along_first - e.along_second) / e.sine2;
  double x = std::clamp(on_first, -e.a, e.a), y = std::clamp(on_second, -e.b, e.b);
  const bool within = std::abs(on_first - x) <= tolerance::same_point * e.a &&
                      std::abs(on_second - y) <= tolerance::same_point * e.b;
  if (!within || e.sine2 < tolerance::nearly_parallel_edges * tolerance::nearly_parallel_edges) {
    y = std::clamp(e.cosine * x - e.along_second, -e.b, e.b);
    x = std::clamp(e.along_first + e.cosine * y, -e.a, e.a);
  }
  return {x, y, within, 0.0};
}

// An edge of a box: its midpoint relative to the centre, and its number.
struct Edge {
  Vec3 middle_w;
  FeatureId number;
};

Edge edge_at(const Box& box, int axis, bool at_next, bool at_after) {
  const int next = (axis + 1) % 3, after = (axis + 2) % 3;
  const Vec3 next_w = box.half[next] * box.axes_w.col(next);
  const Vec3 after_w = box.half[after] * box.axes_w.col(after);
  return {(at_next ? 1.0 : -1.0) * next_w + (at_after ? 1.0 : -1.0) * after_w,
          edge_number(idx(axis), at_next, at_after)};
}

// On which side along its axis k a box reaches farthest along a direction, and whether the other side
// reaches as far but for a difference. Of two that reach equally far it is the one on the side of the other box.
struct Side {
  Side(const Box& box, int k, const Vec3& direction_w, const Vec3& to_other_w, double difference) {
    const Vec3 axis_w = box.axes_w.col(k);
    const double along = axis_w.dot(direction_w);
    positive = (std::abs(along) > tolerance::parallel_edges ? along : axis_w.dot(to_other_w)) > 0.0;
    both = 2.0 * box.half[k] * std::abs(along) <= difference;
  }
  bool positive, both;
};

// The edges parallel to an axis that reach farthest along a direction but for a difference, the farthest one first.
struct FarthestEdges {
  FarthestEdges(const Box& box, int axis, const Vec3& direction_w, const Vec3& to_other_w,
                double difference) {
    const Side next(box, (axis + 1) % 3, direction_w, to_other_w, difference);
    const Side after(box, (axis + 2) % 3, direction_w, to_other_w, difference);
    for (const bool other_after : {false, true}) {
      for (const bool other_next : {false, true}) {
        if ((other_next && !next.both) || (other_after && !after.both)) continue;
        edges[count++] =
            edge_at(box, axis, next.positive != other_next, after.positive != other_after);
      }
    }
  }
  std::size_t count = 0;
  std::array<Edge, 4> edges;
};

EdgeContact cross(const BoxPair& pair, int i, const Edge& edge_first, int j,
                  const Edge& edge_second) {
  const Vec3 axis_first_w = pair.first.axes_w.col(i);
  const Vec3 axis_second_w = pair.second.axes_w.col(j);
  const Vec3 gap_w = pair.d_w + edge_second.middle_w - edge_first.middle_w;
  // The squared sine from its components, to lose nothing for small angles.
  const double sine_k = pair.c[kCycle[idx(i) + 1]][idx(j)],
               sine_l = pair.c[kCycle[idx(i) + 2]][idx(j)];
  const auto [x, y, within, half] = closest_points(
      {pair.a[idx(i)], pair.b[idx(j)], gap_w.dot(axis_first_w), gap_w.dot(axis_second_w),
       pair.c[idx(i)][idx(j)], sine_k * sine_k + sine_l * sine_l});
  const Vec3 between_w = gap_w + y * axis_second_w - x * axis_first_w;
  return {pair.first.center_w + edge_first.middle_w + x * axis_first_w + 0.5 * between_w,
          name_of(edge_first.number, kEdgesOfSecond + edge_second.number), between_w.squaredNorm(),
          within, half * axis_first_w};
}

}  // namespace

FeatureId edge_number(std::size_t axis, bool next_is_positive, bool after_is_positive) {
  return static_cast<FeatureId>(axis) * 4U + static_cast<FeatureId>(next_is_positive) +
         static_cast<FeatureId>(after_is_positive) * 2U;
}

FeatureId name_of(FeatureId edge, FeatureId other) {
  return std::min(edge, other) | std::max(edge, other) << 8U;
}

EdgeContact cross_edges(const BoxPair& pair, const Vec3& normal_w, int i, int j) {
  const FarthestEdges first(pair.first, i, normal_w, pair.d_w, -1.0);
  const FarthestEdges second(pair.second, j, -normal_w, -pair.d_w, -1.0);
  return cross(pair, i, first.edges[0], j, second.edges[0]);
}

EdgeContact nearest_edges(const BoxPair& pair, const Vec3& normal_w, double difference) {
  EdgeContact nearest = cross_edges(pair, normal_w, 0, 0);
  for (int k = 0; k < 9; ++k) {
    const int i = k / 3, j = k % 3;
    const FarthestEdges first(pair.first, i, normal_w, pair.d_w, difference);
    const FarthestEdges second(pair.second, j, -normal_w, -pair.d_w, difference);
    for (std::size_t m = 0; m < first.count * second.count; ++m) {
      const EdgeContact other =
          cross(pair, i, first.edges[m / second.count], j, second.edges[m % second.count]);
      const bool longer = other.stretch_w.squaredNorm() > nearest.stretch_w.squaredNorm();
      const double near = tolerance::same_point * other.stretch_w.norm();
      const bool as_near = std::sqrt(other.apart2) <= std::sqrt(nearest.apart2) + near;
      if (longer ? as_near : other.apart2 < nearest.apart2) nearest = other;
    }
  }
  return nearest;
}

}  // namespace tumble
