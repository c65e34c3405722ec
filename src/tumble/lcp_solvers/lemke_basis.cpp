/// \file
/// \brief The linear algebra of Lemke's method.
#include "tumble/lcp_solvers/lemke_basis.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace tumble {
namespace {

// What is smaller has rounding errors that no number can hold.
constexpr double underflow =
    std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();

// y += s |x|
void add_sizes(double s, const double* x, std::vector<double>& y) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += s * std::abs(x[i]);
}

// y += f(M) c for a function of each entry, and how many columns of M were read: those for which c is not 0. Four at a time, so
// that y is read and written a quarter as often; the sum of each row is made in the order of the columns all the same.
template <class Entry>
int add_columns(const MatX& M, std::span<const double> c, std::span<double> y, const Entry& f) {
  int read = 0;
  std::array<const double*, 4> x{};
  std::array<double, 4> s{};
  std::size_t held = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    if (c[j] == 0.0) continue;
    x[held] = M.col(static_cast<Eigen::Index>(j)).data();
    s[held] = c[j];
    ++read;
    if (++held < 4) continue;
    held = 0;
    const auto [x0, x1, x2, x3] = x;
    const auto [s0, s1, s2, s3] = s;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = (((y[i] + s0 * f(x0[i])) + s1 * f(x1[i])) + s2 * f(x2[i])) + s3 * f(x3[i]);
  }
  for (std::size_t k = 0; k < held; ++k)
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += s[k] * f(x[k][i]);
  return read;
}

}  // namespace

void LemkeBasis::begin(const LcpProblem& problem) {
  problem_ = &problem;
  multiplications_ = 0;
  const int n = problem.size();
  if (inverse_.rows() < n) inverse_.resize(n, n);
  unknowns_.resize(idx(n));
  start_with_accelerations();
}

void LemkeBasis::start_with_accelerations() {
  const int n = static_cast<int>(unknowns_.size());
  for (int j = 0; j < n; ++j) {
    unknowns_[idx(j)] = j;
    for (int i = 0; i < n; ++i) inverse_(i, j) = i == j ? 1.0 : 0.0;
  }
}

void LemkeBasis::values(Rounded& values) { solve_or_invert(-1, values); }

void LemkeBasis::answer_to(int unknown, Rounded& answer) { solve_or_invert(unknown, answer); }

// Solves B x = c with the column of an unknown, or b for -1. If the inverse is no longer good enough,
// it is made anew first.
void LemkeBasis::solve_or_invert(int unknown, Rounded& out) {
  set_column(unknown, right_);
  if (solve(out)) return;
  invert();
  set_column(unknown, right_);
  solve(out);
}

// x = B⁻¹ c, corrected by B⁻¹ (c - B x). The correction squares the relative error of the inverse;
// returns whether that error was at most the square root of rounding. What does not stand out of its
// bound is 0: left in, such dust would multiply with itself and blur ties that are exact.
bool LemkeBasis::solve(Rounded& out) {
  const std::size_t n = unknowns_.size();
  out.x.assign(n, 0.0);
  add_inverse_times(right_, out.x);
  rest_.assign(right_.begin(), right_.end());
  sizes_.assign(n, 0.0);
  add_sizes(1.0, right_.data(), sizes_);
  subtract_product(out.x, rest_, &sizes_);
  correction_.assign(n, 0.0);
  add_inverse_times(rest_, correction_);
  out.bound.assign(n, 0.0);
  add_inverse_sizes_times(sizes_, out.bound);

  bool good = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(std::abs(correction_[i]) <= tolerance::lost_digits * out.bound[i])) good = false;
    out.x[i] += correction_[i];
    out.bound[i] = tolerance::rounding * out.bound[i] + underflow;
    if (std::abs(out.x[i]) <= out.bound[i]) out.x[i] = 0.0;
  }
  return good;
}

// Gauss and Jordan: from the basis of accelerations every other unknown enters in the row of an
// acceleration that is not wanted, where its answer is largest. Then the rows are put back in order.
void LemkeBasis::invert() {
  const int n = static_cast<int>(unknowns_.size());
  wanted_ = unknowns_;
  is_wanted_.assign(idx(n), 0);
  for (const int unknown : wanted_)
    if (unknown < n) is_wanted_[idx(unknown)] = 1;
  start_with_accelerations();
  for (const int unknown : wanted_) {
    if (unknown < n) continue;
    set_column(unknown, right_);
    solve(entering_);
    int row = -1;
    double best = 0.0;
    for (int i = 0; i < n; ++i) {
      if (unknowns_[idx(i)] >= n || is_wanted_[idx(unknowns_[idx(i)])] != 0) continue;
      if (row >= 0 && std::abs(entering_.x[idx(i)]) <= best) continue;
      row = i;
      best = std::abs(entering_.x[idx(i)]);
    }
    if (best > 0.0) exchange(row, unknown, entering_);
    unknowns_[idx(row)] = unknown;  // a singular basis has no answers that hold
  }
  // Back to the rows of before.
  for (int i = 0; i < n; ++i) {
    int from = i;
    while (unknowns_[idx(from)] != wanted_[idx(i)]) ++from;
    if (from == i) continue;
    std::swap(unknowns_[idx(from)], unknowns_[idx(i)]);
    for (int j = 0; j < n; ++j) std::swap(inverse_(from, j), inverse_(i, j));
  }
}

// The row of B⁻¹ is divided by its entry in the answer u, and subtracted from each other row u_i times:
// u becomes a column of the unit matrix.
void LemkeBasis::exchange(int row, int entering, const Rounded& answer) {
  const int n = static_cast<int>(unknowns_.size());
  const double pivot = answer.x[idx(row)];
  assert(pivot != 0.0);
  for (int j = 0; j < n; ++j) {
    double* column = inverse_.col(j).data();
    if (column[row] == 0.0) continue;
    const double share = column[row] / pivot;
    for (int i = 0; i < n; ++i) column[i] -= share * answer.x[idx(i)];
    column[row] = share;
    multiplications_ += n;
  }
  unknowns_[idx(row)] = entering;
}

// The coefficients of an unknown in a - A f - z 1 = b.
void LemkeBasis::set_column(int unknown, std::vector<double>& column) const {
  const int n = problem_->size();
  column.assign(idx(n), 0.0);
  if (unknown < 0) {
    column.assign(problem_->b.data(), problem_->b.data() + n);
  } else if (unknown < n) {
    column[idx(unknown)] = 1.0;
  } else if (unknown < 2 * n) {
    for (int i = 0; i < n; ++i) column[idx(i)] = -problem_->A(i, unknown - n);
  } else {
    for (int i = 0; i < n; ++i) column[idx(i)] = is_equality(*problem_, i) ? 0.0 : -1.0;
  }
}

// rest -= B x, and sizes += |B| |x| if wanted. Columns of accelerations have one entry only.
void LemkeBasis::subtract_product(std::span<const double> x, std::vector<double>& rest,
                                  std::vector<double>* sizes) {
  const int n = problem_->size();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const int unknown = unknowns_[k];
    if (x[k] == 0.0) continue;
    if (unknown < n) {
      rest[idx(unknown)] -= x[k];
      if (sizes != nullptr) (*sizes)[idx(unknown)] += std::abs(x[k]);
    } else if (unknown < 2 * n) {
      add_column(x[k], problem_->A, unknown - n, rest);
      if (sizes != nullptr) add_sizes(std::abs(x[k]), problem_->A.col(unknown - n).data(), *sizes);
      multiplications_ += sizes != nullptr ? 2 * n : n;
    } else {
      for (int i = 0; i < n; ++i) {
        if (is_equality(*problem_, i)) continue;
        rest[idx(i)] += x[k];
        if (sizes != nullptr) (*sizes)[idx(i)] += std::abs(x[k]);
      }
    }
  }
}

// y += B⁻¹ c
void LemkeBasis::add_inverse_times(std::span<const double> c, std::vector<double>& y) {
  const int read = add_columns(inverse_, c, y, [](double x) { return x; });
  multiplications_ += static_cast<std::int64_t>(y.size()) * read;
}

// y += |B⁻¹| c for c >= 0
void LemkeBasis::add_inverse_sizes_times(std::span<const double> c, std::vector<double>& y) {
  const int read = add_columns(inverse_, c, y, [](double x) { return std::abs(x); });
  multiplications_ += static_cast<std::int64_t>(y.size()) * read;
}

}  // namespace tumble
