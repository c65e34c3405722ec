/// \file
/// \brief Numbers of several random scenes: means and ratios with their intervals.
#pragma once

#include "driver/intervals.hpp"
#include "driver/statistics.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tumble::chapters {

// A number of each seed.
template <class Seed, class Number>
std::vector<double> numbers_of(const std::vector<Seed>& seeds, const Number& number) {
  std::vector<double> values;
  for (const Seed& seed : seeds) values.push_back(static_cast<double>(std::invoke(number, seed)));
  return values;
}

// The mean over the seeds.
template <class Seed, class Number>
Quantity mean_of(std::string name, std::string unit, const std::vector<Seed>& seeds,
                 const Number& number) {
  return mean_over_seeds(std::move(name), std::move(unit), numbers_of(seeds, number));
}

// The ratio of two sums over the seeds.
inline Quantity ratio_of_sums(std::string name, std::string unit, const std::vector<double>& above,
                              const std::vector<double>& below) {
  if (!(sum_without(below, -1) > 0.0)) throw std::runtime_error("nothing to compare: " + name);
  return over_seeds(
      std::move(name), std::move(unit), static_cast<int>(above.size()),
      [&](int left_out) { return sum_without(above, left_out) / sum_without(below, left_out); });
}

}  // namespace tumble::chapters
