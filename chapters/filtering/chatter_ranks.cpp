/// \file
/// \brief Medians over seeds and ranks with ties.
#include "filtering/chatter_ranks.hpp"

namespace tumble::chapters {

MedianRange median_range(std::vector<double> values) {
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

std::vector<int> shared_ranks(std::span<const MedianRange> ranges, double floor) {
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
