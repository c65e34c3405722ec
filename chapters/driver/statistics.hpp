/// \file
/// \brief Confidence of numbers that were measured over random scenes.
#pragma once

#include "driver/figure.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tumble::chapters {

/// How far a number is from what it should be.
/// \param found   it
/// \param wanted  what it should be, not 0
/// \return [-] |found / wanted - 1|
double relative_error(double found, double wanted);

/// A share of independent trials, with Wilson's interval of 95 %.
///
/// With p = hits / n and z = 1.96 the interval is
/// \f$(p + \tfrac{z^2}{2n} \pm z \sqrt{p(1-p)/n + z^2/4n^2}) / (1 + z^2/n)\f$. It stays within 0 and 1,
/// and is honest when there are no hits at all.
/// \param name    of the quantity
/// \param hits    trials that count
/// \param trials  all of them; they are its `seeds`
/// \return hits / trials; NaN if there was no trial
/// \see Wilson, Journal of the American Statistical Association 22, 1927.
Quantity share_of_trials(std::string name, std::int64_t hits, std::int64_t trials);

/// A number made of the results of several seeds, with an interval of 95 % over the seeds.
///
/// The jackknife: the number is computed again without each of the seeds in turn, and the spread of
/// these gives the standard error of the whole. Student's factor for the number of seeds makes it
/// an interval. It serves for ratios of sums, whose parts vary together.
/// \param name      of the quantity
/// \param unit      of the quantity
/// \param seeds     how many; the interval needs two
/// \param estimate  the number without the seed of this index; -1 leaves out none
/// \return the number and its interval
Quantity over_seeds(std::string name, std::string unit, int seeds,
                    const std::function<double(int left_out)>& estimate);

/// The sum of what each seed gave.
/// \param values    by seed
/// \param left_out  index of a seed that is not counted; -1: all are
/// \return the sum
double sum_without(std::span<const double> values, int left_out);

/// The mean of what each seed gave.
/// \param name    of the quantity
/// \param unit    of the quantity
/// \param values  one for each seed
/// \return with the interval of over_seeds(), here Student's
Quantity mean_over_seeds(std::string name, std::string unit, std::span<const double> values);

/// The middle one of some numbers.
/// \param values at least one; their order does not matter
/// \return the mean of the middle two if there is an even number of them
double median_of(std::vector<double> values);

/// The order of an error: the slope of its logarithm against that of the step, by least squares.
/// \param x  [any] above 0
/// \param y  [any] above 0, as many, at least two
/// \return [-] the exponent of a power law
/// \throws std::invalid_argument for fewer than two points, or lengths that differ
double fitted_order(std::span<const double> x, std::span<const double> y);

}  // namespace tumble::chapters
