/// \file
/// \brief What the routines of narrow_phase.cpp have in common, and those of the installed engines.
#pragma once

#include "tumble/geometry/box.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace narrow_phase {

/// Two boxes to be tested against each other.
struct Pair {
  tumble::Box first;   ///< the one
  tumble::Box second;  ///< the other
};

/// What a routine says about one pair.
struct Answer {
  int points = 0;      ///< how many contact points
  double depth = 0.0;  ///< [m] of the deepest one; meaningless without points
};

/// A routine under test.
struct Routine {
  std::string name;                          ///< as printed
  std::function<double()> run;               ///< over all pairs; a sum that depends on each
  std::function<Answer(std::size_t k)> ask;  ///< about pair k, for the quality; not timed
  std::vector<double> ns;                    ///< [ns] per pair, one for each round
};

/// Makes a run over all pairs of a call on one pair.
/// \param count  how many pairs
/// \param call   takes the pair's number and returns a number that depends on its result
/// \return calls it for each pair and adds up
template <typename Call>
std::function<double()> over_all(std::size_t count, Call call) {
  return [count, call]() mutable {
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) sum += call(k);
    return sum;
  };
}

/// The box-box routines of the engines that were found at build time.
/// \param pairs the pairs, converted here to what each engine wants, so that this is not timed
/// \return a routine for each engine; they own their copies of the pairs
std::vector<Routine> peers(const std::vector<Pair>& pairs);

}  // namespace narrow_phase
