/// \file
/// \brief Anderson acceleration of a fixed-point iteration.
#include "tumble/math/anderson.hpp"

#include "tumble/base/tolerances.hpp"

#include <algorithm>

namespace tumble {

void AndersonAcceleration::extrapolate(const VecX& change, VecX& x) {
  const double length = change.norm();
  if (length > tolerance::anderson_growth * length_) count_ = 0;
  length_ = length;
  const auto before = static_cast<int>(std::min(count_, kDepth));
  differences_.resize(change.size(), before);
  factor_.clear(static_cast<int>(change.size()), before);
  for (int j = 0; j < before; ++j) {
    differences_.col(j) = change - changes_[static_cast<std::size_t>(j)];
    factor_.append(differences_, j);  // unless it depends on those before
  }
  std::array<double, kDepth> y{};
  const std::vector<int>& used = factor_.indices();
  factor_.solve(change, std::span(y).first(used.size()));
  step_.setZero(x.size());
  for (std::size_t j = 0; j < used.size(); ++j)
    step_ += y[j] * (x - results_[static_cast<std::size_t>(used[j])]);
  changes_[count_ % kDepth] = change;
  results_[count_ % kDepth] = x;
  ++count_;
  x -= step_;
}

}  // namespace tumble
