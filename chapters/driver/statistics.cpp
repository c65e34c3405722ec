/// \file
/// \brief Confidence of numbers that were measured over random scenes.
#include "driver/statistics.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tumble::chapters {

double relative_error(double found, double wanted) { return std::abs(found / wanted - 1.0); }

Quantity share_of_trials(std::string name, std::int64_t hits, std::int64_t trials) {
  constexpr double z = 1.959963984540054;  // 95 % of a normal distribution lie within ± z
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(hits) / n;
  const double middle = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double reach =
      z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  Quantity out{std::move(name), "-", share};
  // With no hit, or nothing but hits, an end lies exactly on 0 or 1, up to rounding.
  out.low = hits == 0 ? 0.0 : middle - reach;
  out.high = hits == trials ? 1.0 : middle + reach;
  out.seeds = static_cast<int>(trials);
  return out;
}

Quantity over_seeds(std::string name, std::string unit, int seeds,
                    const std::function<double(int left_out)>& estimate) {
  Quantity out{std::move(name), std::move(unit), estimate(-1)};
  out.seeds = seeds;
  if (seeds < 2) return out;
  std::vector<double> partial;
  double mean = 0.0;
  for (int k = 0; k < seeds; ++k) {
    partial.push_back(estimate(k));
    mean += partial.back() / seeds;
  }
  double squares = 0.0;
  for (const double value : partial) squares += (value - mean) * (value - mean);
  const double error = std::sqrt(squares * (seeds - 1) / seeds);
  const double reach = gsl_cdf_tdist_Pinv(0.975, seeds - 1) * error;
  out.low = out.value - reach;
  out.high = out.value + reach;
  return out;
}

double sum_without(std::span<const double> values, int left_out) {
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (static_cast<int>(k) != left_out) sum += values[k];
  return sum;
}

Quantity mean_over_seeds(std::string name, std::string unit, std::span<const double> values) {
  const int seeds = static_cast<int>(values.size());
  return over_seeds(std::move(name), std::move(unit), seeds, [&](int left_out) {
    return sum_without(values, left_out) / (left_out < 0 ? seeds : seeds - 1);
  });
}

Quantity ratio_of_sums(std::string name, std::string unit, std::span<const double> above,
                       std::span<const double> below) {
  return over_seeds(
      std::move(name), std::move(unit), static_cast<int>(above.size()),
      [&](int left_out) { return sum_without(above, left_out) / sum_without(below, left_out); });
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double fitted_order(std::span<const double> x, std::span<const double> y) {
  if (x.size() < 2 || x.size() != y.size())
    throw std::invalid_argument("an order needs two points or more");
  std::vector<double> log_x;
  std::vector<double> log_y;
  for (std::size_t k = 0; k < x.size(); ++k) {
    log_x.push_back(std::log(x[k]));
    log_y.push_back(std::log(y[k]));
  }
  double at_zero = 0.0;
  double slope = 0.0;
  double cov00 = 0.0;
  double cov01 = 0.0;
  double cov11 = 0.0;
  double squares = 0.0;
  gsl_fit_linear(log_x.data(), 1, log_y.data(), 1, log_x.size(), &at_zero, &slope, &cov00, &cov01,
                 &cov11, &squares);
  return slope;
}

}  // namespace tumble::chapters
