/// \file
/// \brief kd-tree and octree.
#include "tumble/geometry/cell_trees.hpp"

#include <algorithm>

namespace tumble {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kFew = 4;    // bodies that are tested without a cut
constexpr std::size_t kSaved = 4;  // a cut saves at least one pair in so many
constexpr std::size_t kParts = 8;  // of a cell, at most

std::size_t pairs_of(std::size_t count) { return count * (count - 1) / 2; }

// Whether a body reaches into one of the parts of a cut: bit k of the number says upper along axis k.
bool reaches(const Bounds& body, const std::array<bool, 3>& axes, const Vec3& at,
             std::size_t part) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const bool upper = (part >> k & 1U) != 0;
    if (!axes[k] && upper) return false;
    if (axes[k] && (upper ? body.high[axis] < at[axis] : body.low[axis] >= at[axis])) return false;
  }
  return true;
}

// What the finite bodies cover.
Bounds covered(std::span<const Bounds> bounds) {
  Bounds all{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Bounds& b : bounds) {
    if (!b.low.allFinite() || !b.high.allFinite()) continue;
    all.low = all.low.cwiseMin(b.low);
    all.high = all.high.cwiseMax(b.high);
  }
  return all;
}

}  // namespace

void CellTree::search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  bodies_.clear();
  for (std::size_t k = 0; k < bounds.size(); ++k) bodies_.push_back(static_cast<int>(k));
  const Bounds everything{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
  search_cell(bounds, {everything, covered(bounds), 0, bodies_.size(), 0}, out);
}

// [S4.1:cells]
// Cuts a cell if that saves tests, and looks into its parts. The bodies of each part are listed behind those of the cell.
void CellTree::search_cell(std::span<const Bounds> bounds, const Cell& cell,
                           std::vector<IndexPair>& out) {
  const std::size_t count = cell.end - cell.begin;
  if (count <= kFew || cell.level == kMostLevels) return test_all(bounds, cell, out);
  const Cut cut = cut_of(bounds, {bodies_.data() + cell.begin, count}, cell.extent);
  if (!cut.axes[0] && !cut.axes[1] && !cut.axes[2]) return test_all(bounds, cell, out);

  std::array<std::size_t, kParts + 1> begins{};
  std::size_t left = 0, filled = 0;  // pairs, and parts that have a body
  for (std::size_t part = 0; part < kParts; ++part) {
    begins[part] = bodies_.size();
    for (std::size_t k = cell.begin; k < cell.end; ++k) {
      const int body = bodies_[k];
      if (reaches(bounds[static_cast<std::size_t>(body)], cut.axes, cut.at, part))
        bodies_.push_back(body);
    }
    const std::size_t in_it = bodies_.size() - begins[part];
    if (in_it > 0) left += pairs_of(in_it);
    filled += in_it > 0 ? 1 : 0;
  }
  begins[kParts] = bodies_.size();
  for (std::size_t k = 0; k < count; ++k) count_test();
  const bool saves = filled == 1 || left <= pairs_of(count) - pairs_of(count) / kSaved;
  for (std::size_t part = 0; saves && part < kParts; ++part) {
    if (begins[part] == begins[part + 1]) continue;
    Cell inner{cell.owned, cell.extent, begins[part], begins[part + 1], cell.level + 1};
    for (std::size_t k = 0; k < cut.axes.size(); ++k) {
      if (!cut.axes[k]) continue;
      const auto axis = static_cast<Eigen::Index>(k);
      const bool upper = (part >> k & 1U) != 0;
      // A plane outside of the cell would make it larger.
      for (Bounds* own : {&inner.owned, &inner.extent}) {
        if (upper)
          own->low[axis] = std::max(own->low[axis], cut.at[axis]);
        else
          own->high[axis] = std::min(own->high[axis], cut.at[axis]);
      }
    }
    search_cell(bounds, inner, out);
  }
  bodies_.resize(begins[0]);
  if (!saves) test_all(bounds, cell, out);
}

// All pairs whose overlap has its low corner in this cell.
void CellTree::test_all(std::span<const Bounds> bounds, const Cell& cell,
                        std::vector<IndexPair>& out) {
  for (std::size_t i = cell.begin; i < cell.end; ++i) {
    const Bounds& first = bounds[static_cast<std::size_t>(bodies_[i])];
    for (std::size_t k = i + 1; k < cell.end; ++k) {
      const Vec3 corner = first.low.cwiseMax(bounds[static_cast<std::size_t>(bodies_[k])].low);
      const bool here = (corner.array() >= cell.owned.low.array()).all() &&
                        (corner.array() < cell.owned.high.array()).all();
      if (here)
        test(bounds, bodies_[i], bodies_[k], out);
      else
        count_test();
    }
  }
}
// [S4.1:cells]

// Of the bodies that begin within the cell: others are in both halves of any cut.
CellTree::Cut KdTree::cut_of(std::span<const Bounds> bounds, std::span<const int> bodies,
                             const Bounds& extent) {
  Cut cut;
  double widest = 0.0;
  Eigen::Index axis = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    double most = extent.low[k];
    for (const int body : bodies)
      most = std::max(most, bounds[static_cast<std::size_t>(body)].low[k]);
    if (!(most - extent.low[k] > widest)) continue;
    widest = most - extent.low[k];
    axis = k;
  }
  if (!(widest > 0.0)) return cut;
  lows_.clear();
  for (const int body : bodies) {
    const double low = bounds[static_cast<std::size_t>(body)].low[axis];
    if (low > extent.low[axis]) lows_.push_back(low);
  }
  const auto middle = lows_.begin() + static_cast<std::ptrdiff_t>(lows_.size() / 2);
  std::nth_element(lows_.begin(), middle, lows_.end());
  cut.axes[static_cast<std::size_t>(axis)] = true;
  cut.at[axis] = *middle;
  return cut;
}

CellTree::Cut Octree::cut_of(std::span<const Bounds> /*bounds*/, std::span<const int> /*bodies*/,
                             const Bounds& extent) {
  Cut cut;
  if (!extent.low.allFinite() || !extent.high.allFinite()) return cut;
  cut.at = 0.5 * extent.low + 0.5 * extent.high;
  for (std::size_t k = 0; k < cut.axes.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    cut.axes[k] = extent.low[axis] < cut.at[axis] && cut.at[axis] < extent.high[axis];
  }
  return cut;
}

}  // namespace tumble
