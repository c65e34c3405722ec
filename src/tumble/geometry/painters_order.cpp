/// \file
/// \brief The painter's order of boxes.
#include "tumble/geometry/painters_order.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/separation.hpp"

#include <limits>

namespace tumble {
namespace {

// Whether a plane through the viewer and an edge of one box has all of that box on one side and all
// of the other box on the other.
bool is_parted_by_edge_of(const Box& box, const Box& other, const ViewPoint& view) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 begin = corner_of(box, corner);
    const Vec3 sight = view.sight(begin);
    for (int k = 0; k < 3; ++k) {
      if ((corner >> k & 1) != 0) continue;  // the edge along axis k begins at its other end
      const Vec3 n = sight.cross(box.axes_w.col(k));
      if (n.norm() <= tolerance::seen_end_on * sight.norm()) continue;
      // From the edge, the box extends along its other two axes, inwards. If these are on different
      // sides of the plane, the edge is not part of the outline.
      const auto inwards = [&](int axis) {
        const double along = n.dot(box.axes_w.col(axis));
        return (corner >> axis & 1) != 0 ? -along : along;
      };
      const double along_l = inwards((k + 1) % 3);
      const double along_m = inwards((k + 2) % 3);
      if (along_l * along_m < 0.0) continue;
      const double middle = n.dot(other.center_w - begin);
      const double r = reach(other, n);
      if (along_l + along_m > 0.0 ? middle + r <= 0.0 : middle - r >= 0.0) return true;
    }
  }
  return false;
}

// Which of two boxes may cover the other one.
enum class Cover { none, first, second };

Cover which_covers(const Box& first, const Box& second, const ViewPoint& view) {
  SeparationOptions exact;
  exact.prefer_faces = false;
  exact.enough = std::numeric_limits<double>::infinity();
  // Along the normal: where the first box ends, and where the second one begins.
  const Vec3 n = separation(first, second, exact).normal_w;
  const double end = n.dot(first.center_w) + reach(first, n);
  const double begin = n.dot(second.center_w) - reach(second, n);
  const double side = view.side(n, 0.5 * (end + begin));
  if (side == 0.0) return Cover::none;
  return side < 0.0 ? Cover::first : Cover::second;
}

}  // namespace

ViewPoint ViewPoint::from_eye(const Vec3& eye_w) {
  require::finite(eye_w, "eye_w");
  return {true, eye_w};
}

ViewPoint ViewPoint::along(const Vec3& direction_w) {
  require::finite(direction_w, "direction_w");
  require::that(!direction_w.isZero(0.0), "direction_w = (0, 0, 0): give any other direction");
  return {false, direction_w.stableNormalized()};
}

Vec3 ViewPoint::sight(const Vec3& point_w) const {
  return perspective_ ? Vec3(point_w - vector_) : vector_;
}

double ViewPoint::side(const Vec3& normal_w, double offset) const {
  // From infinitely far away, only the direction matters.
  return perspective_ ? normal_w.dot(vector_) - offset : -normal_w.dot(vector_);
}

double ViewPoint::depth(const Vec3& point_w) const {
  return perspective_ ? (point_w - vector_).norm() : point_w.dot(vector_);
}

bool views_overlap(const Box& first, const Box& second, const ViewPoint& view) {
  return !is_parted_by_edge_of(first, second, view) && !is_parted_by_edge_of(second, first, view);
}

PaintersOrder painters_order(std::span<const Box> boxes, const ViewPoint& view,
                             const std::function<bool(int, int)>& meet) {
  // For every box: by which boxes it may be covered, how many unpainted ones it may cover itself,
  // and how far away it is.
  const int n = static_cast<int>(boxes.size());
  std::vector<std::vector<int>> covered_by(boxes.size());
  std::vector<int> covers(boxes.size(), 0);
  std::vector<double> depth(boxes.size());
  for (int a = 0; a < n; ++a) {
    depth[idx(a)] = view.depth(boxes[idx(a)].center_w);
    for (int b = a + 1; b < n; ++b) {
      if (!views_overlap(boxes[idx(a)], boxes[idx(b)], view)) continue;
      if (meet && !meet(a, b)) continue;
      const Cover cover = which_covers(boxes[idx(a)], boxes[idx(b)], view);
      if (cover == Cover::none) continue;
      const int front = cover == Cover::first ? a : b;
      const int back = cover == Cover::first ? b : a;
      covered_by[idx(back)].push_back(front);
      ++covers[idx(front)];
    }
  }

  PaintersOrder out;
  std::vector<bool> painted(boxes.size(), false);
  for (int count = 0; count < n; ++count) {
    // The farthest box that covers none of those left; failing that, the farthest of those left.
    int next = -1;
    bool next_is_free = false;
    for (int a = 0; a < n; ++a) {
      if (painted[idx(a)]) continue;
      const bool is_free = covers[idx(a)] == 0;
      if (next >= 0 && next_is_free && !is_free) continue;
      const bool freer = is_free && !next_is_free;
      if (next < 0 || freer || depth[idx(a)] > depth[idx(next)]) {
        next = a;
        next_is_free = is_free;
      }
    }
    if (!next_is_free) ++out.cycles;
    painted[idx(next)] = true;
    out.order.push_back(next);
    for (const int front : covered_by[idx(next)]) --covers[idx(front)];
  }
  return out;
}

}  // namespace tumble
