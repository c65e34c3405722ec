/// \file
/// \brief Sweep and prune, in columns.
#include "tumble/geometry/sweep_and_prune.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// Insertion sort may move this many places per body before std::sort takes over: more is not the
// work of one step but a new scene, and would cost n²/4 moves.
constexpr std::int64_t kMovesPerBody = 32;

}  // namespace

int SweepAndPrune::Cut::column(double coordinate) const {
  if (count == 1) return 0;
  // Clamped before it becomes an int; infinities end in the outer columns. All that correctness
  // needs is that it never decreases with the coordinate.
  const double k = std::floor((coordinate - low) / width);
  return static_cast<int>(std::min(std::max(k, 0.0), count - 1.0));
}

void SweepAndPrune::search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  choose_axes(bounds);
  sort(bounds);
  deal(bounds);
  const int columns = cuts_[0].count * cuts_[1].count;
  for (int column = 0; column < columns; ++column) sweep_column(bounds, column, out);
}

void SweepAndPrune::choose_axes(std::span<const Bounds> bounds) {
  // Where the bodies' middles begin and end along each axis, and their mean square extent. Bounds
  // that reach to infinity have no say.
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  Vec3 mean_square = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    int counted = 0;
    for (const Bounds& b : bounds) {
      const double square = (b.high[k] - b.low[k]) * (b.high[k] - b.low[k]);
      if (!std::isfinite(square)) continue;
      const double middle = 0.5 * b.low[k] + 0.5 * b.high[k];
      low[k] = counted == 0 ? middle : std::min(low[k], middle);
      high[k] = counted == 0 ? middle : std::max(high[k], middle);
      ++counted;
      mean_square[k] += (square - mean_square[k]) / counted;  // cannot overflow, as a sum could
    }
  }

  // Sweep along the axis of largest spread and cut the other two.
  const Vec3 spread = high - low;
  spread.maxCoeff(&sweep_axis_);
  const double most = std::max(1.0, std::floor(std::sqrt(static_cast<double>(bounds.size()))));
  for (int c = 0; c < 2; ++c) {
    const int k = (sweep_axis_ + 1 + c) % 3;
    const double width = std::max(std::sqrt(mean_square[k]), spread[k] / most);
    const bool cuttable = width > 0.0 && std::isfinite(width);
    const double count = cuttable ? std::min(most, std::floor(spread[k] / width) + 1.0) : 1.0;
    cuts_[idx(c)] = Cut{k, low[k], width, static_cast<int>(count)};
  }
}

void SweepAndPrune::sort(std::span<const Bounds> bounds) {
  // The kept order is that of other bodies if some were added or removed; any order will do.
  const int n = static_cast<int>(bounds.size());
  std::erase_if(order_, [n](int body) { return body >= n; });
  while (static_cast<int>(order_.size()) < n) order_.push_back(static_cast<int>(order_.size()));

  // Equal begins are ordered by index, so there is one right order, however it is found.
  const auto begins_before = [&](int a, int b) {
    const double low_a = bounds[idx(a)].low[sweep_axis_];
    const double low_b = bounds[idx(b)].low[sweep_axis_];
    return low_a != low_b ? low_a < low_b : a < b;
  };
  std::int64_t moves = kMovesPerBody * n;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const int body = order_[i];
    std::size_t place = i;
    for (; place > 0 && begins_before(body, order_[place - 1]); --place) {
      order_[place] = order_[place - 1];
      --moves;
    }
    order_[place] = body;
    if (moves < 0) return std::sort(order_.begin(), order_.end(), begins_before);
  }
}

void SweepAndPrune::deal(std::span<const Bounds> bounds) {
  // A counting sort. First pass: how many bodies each column gets, one place late.
  const int columns = cuts_[0].count * cuts_[1].count;
  columns_.resize(bounds.size());
  begin_.assign(idx(columns) + 2, 0);
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    Columns& mine = columns_[body];
    for (std::size_t c = 0; c < 2; ++c) {
      mine.from[c] = cuts_[c].column(bounds[body].low[cuts_[c].axis]);
      mine.to[c] = cuts_[c].column(bounds[body].high[cuts_[c].axis]);
    }
    for_each_column(mine, [&](int column) { ++begin_[idx(column) + 2]; });
  }
  // Sums of these are where the columns begin, still one place late; dealing a body moves the
  // begin of its column on, so that in the end each is where the next one was.
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  // Room for some more, so that moving bodies do not make it grow step by step.
  const auto total = idx(begin_.back());
  if (dealt_.capacity() < total) dealt_.reserve(2 * total);
  dealt_.resize(total);
  for (const int body : order_) {
    for_each_column(columns_[idx(body)],
                    [&](int column) { dealt_[idx(begin_[idx(column) + 1]++)] = body; });
  }
}

void SweepAndPrune::sweep_column(std::span<const Bounds> bounds, int column,
                                 std::vector<IndexPair>& out) {
  const int end = begin_[idx(column) + 1];
  for (int i = begin_[idx(column)]; i < end; ++i) {
    const int a = dealt_[idx(i)];
    const double a_ends = bounds[idx(a)].high[sweep_axis_];
    const Columns& of_a = columns_[idx(a)];
    for (int j = i + 1; j < end; ++j) {
      const int b = dealt_[idx(j)];
      if (bounds[idx(b)].low[sweep_axis_] > a_ends) break;
      // Two bodies can share several columns. They are tested in the first one only.
      const Columns& of_b = columns_[idx(b)];
      const int shared = std::max(of_a.from[0], of_b.from[0]) * cuts_[1].count +
                         std::max(of_a.from[1], of_b.from[1]);
      if (shared == column) test(bounds, a, b, out);
    }
  }
}

template <class Visit>
void SweepAndPrune::for_each_column(const Columns& columns, const Visit& visit) const {
  for (int p = columns.from[0]; p <= columns.to[0]; ++p) {
    for (int q = columns.from[1]; q <= columns.to[1]; ++q) visit(p * cuts_[1].count + q);
  }
}

}  // namespace tumble
