/// \file
/// \brief The painter's order of boxes.
#include "tumble/pictures/painters_order.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/pictures/tolerances.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

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
enum class Cover { none, first, second, both };

Cover which_covers(const Box& first, const Box& second, const ViewPoint& view) {
  SeparationOptions exact{.prefer_faces = false, .enough = std::numeric_limits<double>::infinity()};
  const Separation apart = separation(first, second, exact);
  const double shortest = std::min(first.half.minCoeff(), second.half.minCoeff());
  if (apart.distance < -2.0 * tolerance::painted_whole * shortest) return Cover::both;
  // Along the normal: where the first box ends, and where the second one begins.
  const Vec3 n = apart.normal_w;
  const double end = n.dot(first.center_w) + reach(first, n);
  const double begin = n.dot(second.center_w) - reach(second, n);
  const double side = view.side(n, 0.5 * (end + begin));
  if (side == 0.0) return Cover::none;
  return side < 0.0 ? Cover::first : Cover::second;
}

// The boxes left that must be painted before a box or with it: those it covers, those they cover, and so on.
std::vector<int> needed_for(int box, const std::vector<std::vector<int>>& covers,
                            const std::vector<bool>& painted) {
  std::vector<int> found = {box};
  std::vector<bool> known = painted;
  known[idx(box)] = true;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const int other : covers[idx(found[k])]) {
      if (known[idx(other)]) continue;
      known[idx(other)] = true;
      found.push_back(other);
    }
  }
  return found;
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

PaintersOrder painters_order(std::span<const Box> boxes, const ViewPoint& view) {
  const int n = static_cast<int>(boxes.size());
  std::vector<std::vector<int>> covers(boxes.size());
  std::vector<int> farthest_first(boxes.size());
  std::iota(farthest_first.begin(), farthest_first.end(), 0);
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (!views_overlap(boxes[idx(a)], boxes[idx(b)], view)) continue;
      const Cover cover = which_covers(boxes[idx(a)], boxes[idx(b)], view);
      if (cover == Cover::first || cover == Cover::both) covers[idx(a)].push_back(b);
      if (cover == Cover::second || cover == Cover::both) covers[idx(b)].push_back(a);
    }
  }
  std::stable_sort(farthest_first.begin(), farthest_first.end(), [&](int a, int b) {
    return view.depth(boxes[idx(a)].center_w) > view.depth(boxes[idx(b)].center_w);
  });

  // Next comes the farthest box that covers none of those left. If there is none: the smallest set that covers no
  // other one. In that each box covers each other, directly or not, or a part of it would be smaller.
  PaintersOrder order;
  std::vector<bool> painted(boxes.size(), false);
  const auto is_free = [&](int box) {
    return std::all_of(covers[idx(box)].begin(), covers[idx(box)].end(),
                       [&](int other) { return painted[idx(other)]; });
  };
  while (!farthest_first.empty()) {
    const auto free = std::find_if(farthest_first.begin(), farthest_first.end(), is_free);
    std::vector<int> next;
    if (free != farthest_first.end()) {
      next = {*free};
    } else {
      for (const int box : farthest_first) {
        std::vector<int> needed = needed_for(box, covers, painted);
        if (next.empty() || needed.size() < next.size()) next = std::move(needed);
      }
    }
    for (const int box : next) painted[idx(box)] = true;
    std::erase_if(farthest_first, [&](int box) { return painted[idx(box)]; });
    order.push_back(std::move(next));
  }
  return order;
}

}  // namespace tumble
