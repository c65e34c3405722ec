/// \file
/// \brief Medians over seeds with their intervals, and ranks that are shared where these overlap
///        (thesis 5.5).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A median of independent values and where that of the distribution lies.
struct MedianRange {
  double median = 0.0;  // of the values; NaN if there are none
  double low = 0.0;     // lower end of the interval
  double high = 0.0;    // upper end
};

// The median with an interval that holds the distribution's in at least 95 of 100 cases, whatever
// the distribution: the k-th smallest and the k-th largest value, where k is as large as
// \f$2^{1-n}\sum_{i<k}\binom{n}{i} \le 0.05\f$ lets it be. Of 8 values these are the smallest and the
// largest (99 of 100); of fewer than 6 they are too, and hold it less often.
inline MedianRange median_range(std::vector<double> values) {
  const std::size_t n = values.size();
  if (n == 0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const double median = median_of(values);
  std::sort(values.begin(), values.end());
  // The distribution's median is below the k-th smallest value with the probability that fewer than
  // k of n tosses of a coin show heads.
  double term = 1.0;  // binomial coefficient over 2^n
  for (std::size_t i = 0; i < n; ++i) term *= 0.5;
  double outside = 0.0;
  std::size_t k = 0;
  while (k < (n + 1) / 2) {
    outside += 2.0 * term;
    if (k > 0 && outside > 0.05) break;
    term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    ++k;
  }
  return {median, values[k - 1], values[n - k]};
}

// Ranks: 1, and one more for each range that lies wholly below.
//
// Items that share a rank overlap; the best that a range can be is its rank.
inline std::vector<int> shared_ranks(std::span<const MedianRange> ranges, double floor) {
  std::vector<int> ranks;
  for (const MedianRange& own : ranges) {
    const auto below = std::count_if(ranges.begin(), ranges.end(), [&](const MedianRange& other) {
      return std::max(other.high, floor) < std::max(own.low, floor);
    });
    ranks.push_back(1 + static_cast<int>(below));
  }
  return ranks;
}

}  // namespace tumble::chapters
