/// \file
/// \brief Lemke's method: a path of pivots for any matrix.
#include "tumble/lcp_solvers/lemke.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {

LemkeSolver::LemkeSolver(const LemkeOptions& options) : options_(options) {
  if (options.pivot_cap < 0)
    refuse("pivot_cap = " + std::to_string(options.pivot_cap) + ": give at least 0");
  require::not_negative(options.slack, "slack");
}

void LemkeSolver::solve(const LcpProblem& problem, LcpResult& result, std::span<const int> start) {
  require_valid(problem, LcpMatrix::any);
  require_valid_start(problem.size(), start);
  problem_ = &problem;
  result.pivots = 0;
  basis_.begin(problem);
  slack_ = 0.0;
  for (int i = 0; i < problem.size(); ++i)
    slack_ = std::max(slack_, options_.slack * std::abs(problem.b[i]));
  solve_equalities(result);
  result.status = follow_path(result);
  set_forces(result);
  if (result.status == LcpStatus::solved && !left_over_equalities_hold())
    result.status = LcpStatus::singular;
  if ((result.status == LcpStatus::ray || result.status == LcpStatus::singular) &&
      proves_infeasible())
    result.status = LcpStatus::infeasible;
  // A basis that was singular but for rounding may have been taken for regular: no answer is better
  // than a wrong one.
  conclude(problem, result);
  result.multiplications = basis_.multiplications();
  problem_ = nullptr;
}

// Whether an unknown has to be >= 0: the lift, and all forces and accelerations but those of
// equalities.
bool LemkeSolver::is_signed(int unknown) const {
  return is_lift(unknown) || !is_equality(*problem_, unknown % problem_->size());
}

// The force of each equality enters the basis in place of an acceleration of an equality, which is
// then 0 for good. Of all such pairs that are left, the one goes first whose entry stands highest
// above its rounding error; when none stands out of it, the rows left over depend on the others.
void LemkeSolver::solve_equalities(LcpResult& result) {
  const int n = problem_->size();
  open_rows_.clear();
  open_rows_.reserve(idx(n));
  ties_.clear();  // here: equalities whose forces are not in the basis
  ties_.reserve(idx(n));
  column_.x.reserve(idx(n));
  column_.bound.reserve(idx(n));
  for (int i = 0; i < n; ++i)
    if (is_equality(*problem_, i)) open_rows_.push_back(i);
  ties_.assign(open_rows_.begin(), open_rows_.end());

  while (!open_rows_.empty()) {
    double best = 0.0;
    int row = -1;
    int force = -1;
    for (const int j : ties_) {
      basis_.answer_to(n + j, answer_);
      for (const int i : open_rows_) {
        const double size = std::abs(answer_.x[idx(i)]);
        if (size <= best * answer_.bound[idx(i)]) continue;
        best = size / answer_.bound[idx(i)];
        row = i;
        force = j;
      }
    }
    if (row < 0) return;
    basis_.answer_to(n + force, answer_);
    basis_.exchange(row, n + force, answer_);
    ++result.pivots;
    open_rows_.erase(std::find(open_rows_.begin(), open_rows_.end(), row));
    ties_.erase(std::find(ties_.begin(), ties_.end(), force));
  }
}

LcpStatus LemkeSolver::follow_path(LcpResult& result) {
  const int n = problem_->size();
  const int lift = 2 * n;
  basis_.values(values_);
  int row = most_negative_row();
  if (row < 0) return LcpStatus::solved;

  // [S3.3.1:path]
  // The lift is as large as it must be: it takes the place of the acceleration that sinks fastest.
  int entering = lift;
  basis_.answer_to(lift, answer_);
  while (true) {
    if (result.pivots >= options_.pivot_cap) return LcpStatus::cap_reached;
    const int leaving = basis_.unknowns()[idx(row)];
    basis_.exchange(row, entering, answer_);
    ++result.pivots;
    if (is_lift(leaving)) return LcpStatus::solved;

    // What left has become 0, so its partner may grow; the others of the basis answer to it.
    entering = leaving < n ? leaving + n : leaving - n;
    basis_.values(values_);
    if (lift_is_zero()) return LcpStatus::solved;
    basis_.answer_to(entering, answer_);
    row = row_to_leave();
    if (row < 0) return LcpStatus::ray;
  }
  // [S3.3.1:path]
}

// The row that has to be lifted most; the last of equal ones, which is what the lexicographic rule
// asks for: the others get a first entry +1 in their row of the inverse. -1 if none is negative.
int LemkeSolver::most_negative_row() {
  int row = -1;
  double least = 0.0;
  for (int i = 0; i < problem_->size(); ++i) {
    const double value = values_.x[idx(i)];
    if (!is_signed(basis_.unknowns()[idx(i)]) || value >= 0.0 || value > least) continue;
    least = value;
    row = i;
  }
  return row;
}

// Whose unknown reaches 0 first as the entering one grows: the least values[i] / answer[i] over positive
// answers. Ties go to the lift, then to the row whose numbers (values, B⁻¹) / answer come first in the
// order of a dictionary. -1 if no unknown falls: the path ends on a ray.
int LemkeSolver::row_to_leave() {
  ties_.clear();
  for (int i = 0; i < problem_->size(); ++i)
    if (is_signed(basis_.unknowns()[idx(i)]) && answer_.x[idx(i)] > 0.0) ties_.push_back(i);
  if (ties_.empty()) return -1;
  keep_first(values_, slack_);
  for (const int i : ties_)
    if (is_lift(basis_.unknowns()[idx(i)])) return i;
  if (slack_ > 0.0)
    return *std::max_element(ties_.begin(), ties_.end(), [this](int i, int j) {
      return answer_.x[idx(i)] < answer_.x[idx(j)];
    });
  for (int j = 0; j < problem_->size() && ties_.size() > 1; ++j) {
    if (is_equality(*problem_, j)) continue;
    basis_.answer_to(j, column_);
    keep_first(column_, 0.0);
  }

  // In exact numbers one row is left. If rounding hides which, the surest pivot is taken.
  return *std::max_element(ties_.begin(), ties_.end(), [this](int i, int j) {
    return answer_.x[idx(i)] * answer_.bound[idx(j)] < answer_.x[idx(j)] * answer_.bound[idx(i)];
  });
}

// Of the tied rows, keeps those whose numbers[i] / answer[i] may be the least: they differ from the
// least by no more than rounding of both sides of both fractions.
void LemkeSolver::keep_first(const Rounded& numbers, double slack) {
  const auto ratio = [&](int i) { return numbers.x[idx(i)] / answer_.x[idx(i)]; };
  const auto rounding = [&](int i) {
    return (slack + numbers.bound[idx(i)] + std::abs(ratio(i)) * answer_.bound[idx(i)]) /
           answer_.x[idx(i)];
  };
  double limit = std::numeric_limits<double>::infinity();
  for (const int i : ties_) limit = std::min(limit, ratio(i) + rounding(i));
  const auto beyond = [&](int i) { return ratio(i) - rounding(i) > limit; };
  ties_.erase(std::remove_if(ties_.begin(), ties_.end(), beyond), ties_.end());
}

// With a lift of 0 the unknowns solve the problem, even if the lift is still in the basis.
bool LemkeSolver::lift_is_zero() const {
  for (int i = 0; i < problem_->size(); ++i)
    if (is_lift(basis_.unknowns()[idx(i)])) return values_.x[idx(i)] <= slack_;
  return false;
}

// Whether accelerations of equalities that are still in the basis are 0.
bool LemkeSolver::left_over_equalities_hold() const {
  double largest = 0.0;
  for (int i = 0; i < problem_->size(); ++i) largest = std::max(largest, std::abs(problem_->b[i]));
  for (int i = 0; i < problem_->size(); ++i) {
    const int unknown = basis_.unknowns()[idx(i)];
    if (is_signed(unknown) || unknown >= problem_->size()) continue;
    const double slack = tolerance::complementarity * largest + values_.bound[idx(i)];
    if (std::abs(values_.x[idx(i)]) > slack) return false;
  }
  return true;
}

// Whether a path that ended without an answer is a proof that there is none: the symmetric part of A is
// positive semidefinite, by Cholesky's method with the largest pivots, in rows of unit diagonal. An equality that is
// left over proves it for a symmetric A only.
bool LemkeSolver::proves_infeasible() {
  const int n = problem_->size();
  const MatX& A = problem_->A;
  bool symmetric = true;
  symmetric_.A.resize(n, n);
  symmetric_.b.resize(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      symmetric_.A(i, j) = 0.5 * A(i, j) + 0.5 * A(j, i);
      const double scale = std::sqrt(std::abs(A(i, i))) * std::sqrt(std::abs(A(j, j)));
      if (std::abs(A(i, j) - A(j, i)) > tolerance::symmetry * scale) symmetric = false;
    }
  const bool left_over = !open_rows_.empty();
  return (symmetric || !left_over) && rows_.take(symmetric_);
}

// Forces of the basis get their values, the others are 0.
void LemkeSolver::set_forces(LcpResult& result) {
  const int n = problem_->size();
  result.f.assign(idx(n), 0.0);
  basis_.values(values_);
  for (int i = 0; i < n; ++i) {
    const int unknown = basis_.unknowns()[idx(i)];
    if (unknown < n || is_lift(unknown)) continue;
    result.f[idx(unknown - n)] = values_.x[idx(i)];
  }
}

}  // namespace tumble
