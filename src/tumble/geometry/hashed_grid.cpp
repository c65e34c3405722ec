/// \file
/// \brief A hashed grid.
#include "tumble/geometry/hashed_grid.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// A body that reaches more cells than this is big. An extent up to the edge of a cell reaches two
// cells in each direction at most.
constexpr int kMostCells = 8;

// Cells are counted in 32 bits; whatever lies farther out than this is tested against all.
constexpr double kFarthestCell = 0x1p30;

}  // namespace

void HashedGrid::search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  enter(bounds, cell_edge(bounds));
  for (std::size_t bucket = 0; bucket + 2 < begin_.size(); ++bucket)
    search_bucket(bounds, bucket, out);
  // Big bodies against all; of two big ones the one with the lower index tests.
  const int n = static_cast<int>(bounds.size());
  for (const int a : big_) {
    for (int b = 0; b < n; ++b) {
      const bool done_by_other = ranges_[static_cast<std::size_t>(b)].big && b <= a;
      if (!done_by_other) test(bounds, a, b, out);
    }
  }
}

double HashedGrid::cell_edge(std::span<const Bounds> bounds) {
  // Twice the median of the bodies' longest extents. If it is no use, because all bounds are points
  // or infinite, any edge will do.
  extents_.clear();
  for (const Bounds& b : bounds) {
    const double extent = (b.high - b.low).maxCoeff();
    if (std::isfinite(extent)) extents_.push_back(extent);
  }
  if (extents_.empty()) return 1.0;
  const auto median = extents_.begin() + static_cast<std::ptrdiff_t>(extents_.size() / 2);
  std::nth_element(extents_.begin(), median, extents_.end());
  const double edge = 2.0 * *median;
  return edge > 0.0 && std::isfinite(edge) ? edge : 1.0;
}

void HashedGrid::enter(std::span<const Bounds> bounds, double edge) {
  // The cells of every body. A division that overflows makes a body far out.
  ranges_.resize(bounds.size());
  big_.clear();
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    Range& range = ranges_[body];
    const Vec3 from = (bounds[body].low / edge).array().floor();
    const Vec3 to = (bounds[body].high / edge).array().floor();
    range.big = (from.array() < -kFarthestCell).any() || (to.array() > kFarthestCell).any() ||
                (to - from + Vec3::Ones()).prod() > kMostCells;
    if (range.big) {
      big_.push_back(static_cast<int>(body));
      continue;
    }
    range.from = from.cast<int>();
    range.to = to.cast<int>();
  }

  // A counting sort into at least two buckets per body. First pass: the size of every bucket, two
  // places late.
  std::size_t buckets = 16;
  while (buckets < 2 * bounds.size()) buckets *= 2;
  begin_.assign(buckets + 2, 0);
  for (const Range& range : ranges_) {
    for_each_cell(range, [&](const Cell& cell) { ++begin_[bucket_of(cell) + 2]; });
  }
  // Sums of these are where the buckets begin, one place late; entering a body moves the begin of
  // its bucket on, so that in the end each is where the next one was.
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  entries_.reserve(static_cast<std::size_t>(kMostCells) * bounds.size());
  entries_.resize(begin_.back());
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    for_each_cell(ranges_[body], [&](const Cell& cell) {
      entries_[begin_[bucket_of(cell) + 1]++] = Entry{static_cast<int>(body), cell};
    });
  }
}

void HashedGrid::search_bucket(std::span<const Bounds> bounds, std::size_t bucket,
                               std::vector<IndexPair>& out) {
  for (std::size_t i = begin_[bucket]; i < begin_[bucket + 1]; ++i) {
    const Entry& a = entries_[i];
    const Cell& from_a = ranges_[static_cast<std::size_t>(a.body)].from;
    for (std::size_t j = i + 1; j < begin_[bucket + 1]; ++j) {
      const Entry& b = entries_[j];
      if (a.cell != b.cell) continue;
      // Two bodies can share several cells. They are tested in the first one only.
      const Cell& from_b = ranges_[static_cast<std::size_t>(b.body)].from;
      if (a.cell == from_a.cwiseMax(from_b)) test(bounds, a.body, b.body, out);
    }
  }
}

std::size_t HashedGrid::bucket_of(const Cell& cell) const {
  // Mixes one number after the other: multiplying carries low bits up, folding brings them down.
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    hash = (hash ^ static_cast<std::uint32_t>(cell[k])) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32U;
  }
  const std::size_t buckets = begin_.size() - 2;
  return static_cast<std::size_t>(hash) & (buckets - 1);  // their number is a power of two
}

template <class Visit>
void HashedGrid::for_each_cell(const Range& range, const Visit& visit) const {
  if (range.big) return;
  for (int x = range.from[0]; x <= range.to[0]; ++x) {
    for (int y = range.from[1]; y <= range.to[1]; ++y) {
      for (int z = range.from[2]; z <= range.to[2]; ++z) visit(Cell{x, y, z});
    }
  }
}

}  // namespace tumble
