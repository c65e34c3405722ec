/// \file
/// \brief The normal of two boxes that touch edge on edge.
#include "tumble/geometry/edge_on_edge.hpp"

#include "tumble/base/index.hpp"
#include "tumble/geometry/broad_phase.hpp"
#include "tumble/geometry/edge_crossing.hpp"
#include "tumble/geometry/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tumble {
namespace {

// A box edge and the outward normals of the two faces beside it.
struct Ridge {
  Vec3 middle_w;
  Vec3 direction_w;
  double half;
  FeatureId number;
  std::array<Vec3, 2> normals_w;
};

// The edge of a box parallel to its axis, on the given sides of the next two axes.
Ridge ridge_of(const Box& box, int axis, const std::array<double, 2>& sides) {
  Ridge out{box.center_w,
            box.axes_w.col(axis),
            box.half[axis],
            edge_number(idx(axis), sides[0] > 0.0, sides[1] > 0.0),
            {}};
  for (int i = 0; i < 2; ++i) {
    const int k = (axis + 1 + i) % 3;
    out.normals_w[idx(i)] = sides[idx(i)] * box.axes_w.col(k);
    out.middle_w += box.half[k] * out.normals_w[idx(i)];
  }
  return out;
}

// The edge of a box parallel to its axis that passes within `near` of a point, if there is one.
std::optional<Ridge> ridge_at(const Box& box, int axis, const Vec3& point_w, double near) {
  std::array<double, 2> sides;
  for (int i = 0; i < 2; ++i) {
    const int k = (axis + 1 + i) % 3;
    const double at = box.axes_w.col(k).dot(point_w - box.center_w);
    if (std::abs(std::abs(at) - box.half[k]) > near) return {};
    sides[idx(i)] = std::copysign(1.0, at);
  }
  return ridge_of(box, axis, sides);
}

// Axes of the boxes that are parallel, if there are any and the faces beside them are not.
std::optional<IndexPair> parallel_axes(const BoxPair& pair) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (pair.abs_c[i][j] < 1.0 - tolerance::edge_on_edge_turn) continue;
      const Lanes& beside = pair.abs_c[kCycle[i + 1]];
      if (std::max(beside[kCycle[j + 1]], beside[kCycle[j + 2]]) > tolerance::edge_on_edge_aligned)
        return {};
      return IndexPair{static_cast<int>(i), static_cast<int>(j)};
    }
  return {};
}

// Whether a direction leaves an edge between the normals beside it.
bool leaves(const Ridge& ridge, const Vec3& direction_w) {
  return ridge.normals_w[0].dot(direction_w) >= 0.0 && ridge.normals_w[1].dot(direction_w) >= 0.0;
}

// The middle of the outermost common normals, those of each box's faces that leave the first and enter the second edge.
// There are two of them, or the boxes overlap by more than their edges; where they are nearly the same, one will do.
std::optional<Vec3> middle_of_outermost(const Ridge& first, const Ridge& second) {
  std::array<Vec3, 4> outermost_w;
  std::size_t count = 0;
  for (const Vec3& out_w : first.normals_w)
    if (leaves(second, -out_w)) outermost_w[count++] = out_w;
  for (const Vec3& back_w : second.normals_w)
    if (leaves(first, -back_w)) outermost_w[count++] = -back_w;
  if (count != 2 || outermost_w[0].dot(outermost_w[1]) > tolerance::edge_on_edge_same) return {};
  return (outermost_w[0] + outermost_w[1]).normalized();
}

// From the first to the second edge, at right angles to the first.
Vec3 between(const Ridge& first, const Ridge& second) {
  const Vec3 gap_w = second.middle_w - first.middle_w;
  return gap_w - first.direction_w.dot(gap_w) * first.direction_w;
}

using Ridges = std::pair<Ridge, Ridge>;

// The two edges that are the nearest of two boxes that are apart: the way from one to the other leaves the first
// and enters the second between the normals beside them.
std::optional<Ridges> nearest_ridges(const BoxPair& pair, const IndexPair& axes) {
  constexpr std::array<std::array<double, 2>, 4> kSides{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  const auto ridges_of = [&](const Box& box, int axis) {
    return std::array<Ridge, 4>{ridge_of(box, axis, kSides[0]), ridge_of(box, axis, kSides[1]),
                                ridge_of(box, axis, kSides[2]), ridge_of(box, axis, kSides[3])};
  };
  const std::array<Ridge, 4> seconds = ridges_of(pair.second, axes.second);
  for (const Ridge& first : ridges_of(pair.first, axes.first))
    for (const Ridge& second : seconds) {
      const Vec3 gap_w = between(first, second);
      if (leaves(first, gap_w) && leaves(second, -gap_w)) return Ridges(first, second);
    }
  return {};
}

// The two edges on which all points of a manifold lie, if there are such edges.
std::optional<Ridges> touching_ridges(const BoxPair& pair, const IndexPair& axes, double near,
                                      const Manifold& manifold) {
  std::optional<Ridges> out;
  for (int i = 0; i < manifold.count; ++i) {
    const Vec3& point_w = manifold.points[idx(i)].position_w;
    const auto first = ridge_at(pair.first, axes.first, point_w, near);
    if (!first) return {};
    const auto second = ridge_at(pair.second, axes.second, point_w, near);
    if (!second) return {};
    if (out && (out->first.number != first->number || out->second.number != second->number))
      return {};
    out = Ridges(*first, *second);
  }
  return out;
}

// Whether no edge of the first box along one of its axes can be within the margin of an edge of the second: along a normal
// across that axis the boxes are farther apart, and so are any two such edges.
bool out_of_reach(const BoxPair& pair, int axis, double distance, double margin,
                  const Vec3& normal_w) {
  const Vec3 apart_w = pair.second.center_w - pair.first.center_w;
  const double longest = apart_w.lpNorm<1>() + pair.first.half.sum() + pair.second.half.sum();
  const double along = std::abs(pair.first.axes_w.col(axis).dot(normal_w));
  return distance - longest * (along + tolerance::edge_on_edge_rounding) > margin;
}

bool farther_than(double near, const Manifold& manifold) {
  return std::all_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                     [near](const ManifoldPoint& p) { return p.distance > near; });
}

// Both ends of the stretch that the edges share, with their distance along a normal. A stretch no longer than the
// least is none: there corners lie on each other.
void write_ends(const Ridge& first, const Ridge& second, const Vec3& normal_w, double least,
                double margin, Manifold& out) {
  const FeatureId name = name_of(first.number, kEdgesOfSecond + second.number);
  const FeatureId names[] = {name, name | kOtherEnd};
  const double at = first.direction_w.dot(second.middle_w - first.middle_w);
  const double from = std::max(-first.half, at - second.half);
  const double to = std::min(first.half, at + second.half);
  if (!(to - from > least)) return;
  out.normal_w = normal_w;
  out.count = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 first_w = first.middle_w + (i == 0 ? from : to) * first.direction_w;
    const Vec3 gap_w = second.middle_w - first_w;
    const Vec3 second_w = first_w + gap_w - second.direction_w.dot(gap_w) * second.direction_w;
    const double distance = normal_w.dot(second_w - first_w);
    if (distance > margin) continue;
    out.points[idx(out.count++)] = {0.5 * (first_w + second_w), distance, names[i]};
  }
}

}  // namespace

void turn_to_edges(const BoxPair& pair, double distance, double margin, Manifold& manifold) {
  const std::optional<IndexPair> axes = parallel_axes(pair);
  if (!axes) return;
  if (manifold.count == 0 && out_of_reach(pair, axes->first, distance, margin, manifold.normal_w))
    return;
  const double longest = 2.0 * std::max(pair.first.half.maxCoeff(), pair.second.half.maxCoeff());
  const double shortest = 2.0 * std::min(pair.first.half.minCoeff(), pair.second.half.minCoeff());
  const double near =
      std::min(tolerance::edge_on_edge * longest, tolerance::edge_on_edge_of_shortest * shortest);
  std::optional<Ridges> edges = touching_ridges(pair, *axes, near, manifold);
  if (!edges && farther_than(near, manifold)) edges = nearest_ridges(pair, *axes);
  if (!edges) return;
  const auto& [first, second] = *edges;
  const std::optional<Vec3> middle_w = middle_of_outermost(first, second);
  if (!middle_w) return;
  const Vec3 gap_w = between(first, second);
  // Along the middle of the normals two edges look nearer than they are.
  if (manifold.count == 0 && gap_w.norm() > margin) return;
  const bool apart = gap_w.norm() > near && leaves(first, gap_w) && leaves(second, -gap_w);
  write_ends(first, second, apart ? gap_w.normalized() : *middle_w, near, margin, manifold);
}

}  // namespace tumble
