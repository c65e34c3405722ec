/// \file
/// \brief Twenty measured tosses of a real cube, as the experiments need them.
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The quartiles of twenty measured tosses.
//
// Of ContactNets' data (Pfrommer, Halm, Posa: ContactNets, CoRL 2020), the first twenty tosses; a test
// computes them again where the data are.
struct MeasuredQuartiles {
  std::array<double, 3> travel;        // [m] along the table, from start to end
  std::array<double, 3> time_to_rest;  // [s] until the cube moves no more, see `toss_still`
};

// The measurements.
inline constexpr MeasuredQuartiles measured_tosses{{0.37300048, 0.40627362, 0.45103770},
                                                   {0.61993243, 0.65202703, 0.66891892}};

// [s] That are simulated; the measured cubes rest after 0.7.
inline constexpr double toss_seconds = 2.0;

// [m/s] A cube that is slower moves no more, if it turns slower than ten times this in rad/s,
// which is about the same speed at its corners. Five times the noise of the measured speed at
// rest.
inline constexpr double toss_still = 0.02;

// A quantile, with straight lines between the sorted numbers.
// share: [-] 0 to 1; 0.5 is the median
inline double quantile_of(std::vector<double> numbers, double share) {
  std::ranges::sort(numbers);
  const double place = share * static_cast<double>(numbers.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, numbers.size() - 1);
  return numbers[below] + (place - static_cast<double>(below)) * (numbers[above] - numbers[below]);
}

}  // namespace tumble::chapters
