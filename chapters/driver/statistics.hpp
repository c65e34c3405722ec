/// \file
/// \brief Confidence of numbers that were measured over random scenes.
#pragma once

#include "driver/figure.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tumble::chapters {

// How far a number is from what it should be [-], |found / wanted - 1|.
double relative_error(double found, double wanted);

// A share of independent trials, with Wilson's interval of 95 %.
//
// With p = hits / n and z = 1.96 the interval is
// \f$(p + \tfrac{z^2}{2n} \pm z \sqrt{p(1-p)/n + z^2/4n^2}) / (1 + z^2/n)\f$. It stays within 0 and 1,
// and is honest when there are no hits at all.
// \see Wilson, Journal of the American Statistical Association 22, 1927.
Quantity share_of_trials(std::string name, std::int64_t hits, std::int64_t trials);

// A number made of the results of several seeds, with an interval of 95 % over the seeds.
//
// The jackknife: the number is computed again without each of the seeds in turn, and the spread of
// these gives the standard error of the whole. Student's factor for the number of seeds makes it
// an interval. It serves for ratios of sums, whose parts vary together.
Quantity over_seeds(std::string name, std::string unit, int seeds,
                    const std::function<double(int left_out)>& estimate);

// The sum of what each seed gave.
double sum_without(std::span<const double> values, int left_out);

// The mean of what each seed gave.
Quantity mean_over_seeds(std::string name, std::string unit, std::span<const double> values);

// The ratio of two sums over the seeds; NaN or infinite where the second one is 0.
Quantity ratio_of_sums(std::string name, std::string unit, std::span<const double> above,
                       std::span<const double> below);

// A number of each seed.
template <class Seed, class Number>
std::vector<double> numbers_of(const std::vector<Seed>& seeds, const Number& number) {
  std::vector<double> values;
  for (const Seed& seed : seeds) values.push_back(static_cast<double>(std::invoke(number, seed)));
  return values;
}

// The largest of the numbers of some things; 0 if none is above it.
template <class List, class Number>
double largest_of(const List& list, const Number& number) {
  double most = 0.0;
  for (const auto& one : list) most = std::max(most, static_cast<double>(std::invoke(number, one)));
  return most;
}

// The same where a number belongs to two things, one in each of two lists, at the same place.
template <class First, class Second, class Number>
double largest_of(const First& first, const Second& second, const Number& number) {
  double most = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k)
    most = std::max(most, static_cast<double>(std::invoke(number, first[k], second[k])));
  return most;
}

// Its mean over the seeds.
template <class Seed, class Number>
Quantity mean_of(std::string name, std::string unit, const std::vector<Seed>& seeds,
                 const Number& number) {
  return mean_over_seeds(std::move(name), std::move(unit), numbers_of(seeds, number));
}

// The middle one of some numbers.
double median_of(std::vector<double> values);

// The order of an error: the slope of its logarithm against that of the step, by least squares.
// x: [any] above 0
// y: [any] above 0, as many, at least two
// Returns [-] the exponent of a power law
double fitted_order(std::span<const double> x, std::span<const double> y);

// A quantity as three cells of a row.
inline std::array<double, 3> with_interval(const Quantity& quantity) {
  return {quantity.value, quantity.low, quantity.high};
}

// The columns of with_interval(): the name, and with "_low" and "_high".
inline void add_interval_columns(const std::string& name, const std::string& unit,
                                 const std::string& meaning, Table& table) {
  for (const char* end : {"", "_low", "_high"})
    table.columns.push_back({name + end, unit, meaning});
}

}  // namespace tumble::chapters
