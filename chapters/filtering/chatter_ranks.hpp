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
MedianRange median_range(std::vector<double> values);

// Ranks: 1, and one more for each range that lies wholly below.
//
// Items that share a rank overlap; the best that a range can be is its rank.
std::vector<int> shared_ranks(std::span<const MedianRange> ranges, double floor);

}  // namespace tumble::chapters
