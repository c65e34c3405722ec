/// \file
/// \brief The binary space partition of faces.
#include "tumble/pictures/back_to_front.hpp"

#include "tumble/pictures/tolerances.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tumble {
namespace {

constexpr std::size_t kCandidates =
    8;  // faces of which the one that cuts fewest divides the others

// Sorts parts of faces by recursion.
class Partition {
 public:
  explicit Partition(double slack) : slack_(slack) {}
  void sort(std::vector<FacePart> parts);
  std::vector<FacePart> take() { return std::move(sorted_); }

 private:
  struct Range {
    double low, high;  // [m] of the corners along the normal of a plane, 0 in it
  };

  [[nodiscard]] Range range_of(const FacePart& part, const FacePart& plane) const;
  [[nodiscard]] std::size_t fewest_cuts(const std::vector<FacePart>& parts) const;

  double slack_;  // [m] corners nearer to a plane are in it
  std::vector<FacePart> sorted_;
};

double height_over(const FacePart& plane, const Vec3& point_w) {
  return plane.normal_w.dot(point_w - plane.corners_w.front());
}

Partition::Range Partition::range_of(const FacePart& part, const FacePart& plane) const {
  Range range{0.0, 0.0};
  for (const Vec3& corner_w : part.corners_w) {
    const double height = height_over(plane, corner_w);
    if (height < -slack_) range.low = std::min(range.low, height);
    if (height > slack_) range.high = std::max(range.high, height);
  }
  return range;
}

// The side of a part in front of a plane (sign 1) or behind it (-1).
FacePart side_of(const FacePart& part, const FacePart& plane, double sign) {
  FacePart out{.normal_w = part.normal_w, .face = part.face, .cut = true};
  for (std::size_t k = 0; k < part.corners_w.size(); ++k) {
    const Vec3& a = part.corners_w[k];
    const Vec3& b = part.corners_w[(k + 1) % part.corners_w.size()];
    const double at_a = sign * height_over(plane, a);
    const double at_b = sign * height_over(plane, b);
    if (at_a >= 0.0) out.corners_w.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
      out.corners_w.emplace_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return out;
}

std::size_t Partition::fewest_cuts(const std::vector<FacePart>& parts) const {
  std::size_t best = 0;
  auto fewest = std::numeric_limits<std::ptrdiff_t>::max();
  const std::size_t step = (parts.size() + kCandidates - 1) / kCandidates;
  for (std::size_t k = 0; k < parts.size(); k += step) {
    const auto cuts = std::count_if(parts.begin(), parts.end(), [&](const FacePart& part) {
      const Range range = range_of(part, parts[k]);
      return range.low < 0.0 && range.high > 0.0;
    });
    if (cuts >= fewest) continue;
    fewest = cuts;
    best = k;
  }
  return best;
}

void Partition::sort(std::vector<FacePart> parts) {
  if (parts.empty()) return;
  const std::size_t chosen = fewest_cuts(parts);
  std::swap(parts[chosen], parts.back());
  FacePart plane = std::move(parts.back());
  parts.pop_back();
  std::vector<FacePart> behind, in_front;
  for (FacePart& part : parts) {
    const Range range = range_of(part, plane);
    if (range.low < 0.0 && range.high > 0.0) {
      behind.push_back(side_of(part, plane, -1.0));
      in_front.push_back(side_of(part, plane, 1.0));
    } else {
      (range.low < 0.0 ? behind : in_front).push_back(std::move(part));
    }
  }
  parts = {};
  sort(std::move(behind));
  sorted_.push_back(std::move(plane));
  sort(std::move(in_front));
}

}  // namespace

std::vector<FacePart> back_to_front(std::vector<FacePart> faces) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const FacePart& face : faces) {
    for (const Vec3& corner_w : face.corners_w) {
      low = low.cwiseMin(corner_w);
      high = high.cwiseMax(corner_w);
    }
  }
  Partition partition(faces.empty() ? 0.0 : tolerance::in_plane * (high - low).norm());
  partition.sort(std::move(faces));
  return partition.take();
}

}  // namespace tumble
