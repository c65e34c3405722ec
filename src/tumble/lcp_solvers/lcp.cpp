/// \file
/// \brief Checks and residuals common to all solvers of the complementarity problem, and their list.
#include "tumble/lcp_solvers/lcp.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"
#include "tumble/lcp_solvers/augmented_lagrangian.hpp"
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/enumerate.hpp"
#include "tumble/lcp_solvers/gauss_seidel.hpp"
#include "tumble/lcp_solvers/judge.hpp"
#include "tumble/lcp_solvers/least_constraint.hpp"
#include "tumble/lcp_solvers/lemke.hpp"
#include "tumble/lcp_solvers/safeguard.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

// "A(2, 0)"
std::string entry(int row, int column) {
  return "A(" + std::to_string(row) + ", " + std::to_string(column) + ")";
}

void require_sizes(const LcpProblem& problem) {
  const auto n = problem.b.size();
  const std::string rows = std::to_string(n);
  if (problem.A.rows() != n || problem.A.cols() != n)
    refuse("A is " + std::to_string(problem.A.rows()) + " by " + std::to_string(problem.A.cols()) +
           ": b has " + rows + " entries, give " + rows + " by " + rows);
  const std::size_t flags = problem.equality.size();
  if (flags != 0 && flags != static_cast<std::size_t>(n))
    refuse("equality has " + std::to_string(flags) + " entries: give none or " + rows);
}

// The name of a number is only put together once it is known to be wrong.
void require_finite(const LcpProblem& problem) {
  for (int j = 0; j < problem.size(); ++j) {
    if (!std::isfinite(problem.b[j])) require::finite(problem.b[j], "b[" + std::to_string(j) + "]");
    for (int i = 0; i < problem.size(); ++i)
      if (!std::isfinite(problem.A(i, j))) require::finite(problem.A(i, j), entry(i, j));
  }
}

void require_symmetric(const MatX& A) {
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < j; ++i) {
      // Equal entries are symmetric even without a diagonal to compare with.
      if (A(i, j) == A(j, i)) continue;
      const double scale = std::sqrt(std::abs(A(i, i))) * std::sqrt(std::abs(A(j, j)));
      if (std::abs(A(i, j) - A(j, i)) <= tolerance::symmetry * scale) continue;
      refuse(entry(i, j) + " = " + shortest_text(A(i, j)) + " but " + entry(j, i) + " = " +
             shortest_text(A(j, i)) + ": give a symmetric matrix");
    }
}

void require_positive_diagonal(const MatX& A) {
  for (int i = 0; i < A.cols(); ++i)
    if (!(A(i, i) > 0.0)) require::positive(A(i, i), entry(i, i));
}

// The sizes must be right. Each row is judged by the smaller of what its force and its
// acceleration would have to change by: one of them has to be 0, and neither may be negative.
double residual_of(const LcpProblem& problem, std::span<const double> f,
                   std::span<const double> a) {
  double worst = 0.0;
  double largest = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const double wrong = is_equality(problem, i)
                             ? a[idx(i)]
                             : std::min(row_yield(problem.A, i) * f[idx(i)], a[idx(i)]);
    if (std::isnan(wrong) || std::isnan(f[idx(i)]) || std::isnan(a[idx(i)]))
      return std::numeric_limits<double>::quiet_NaN();
    worst = std::max(worst, std::abs(wrong));
    largest = std::max(largest, std::abs(problem.b[i]));
  }
  return largest > 0.0 ? worst / largest : worst;
}

void accelerations(const LcpProblem& problem, std::span<const double> f, std::vector<double>& a) {
  a.resize(f.size());
  multiply(problem.A, f, a);
  for (int i = 0; i < problem.size(); ++i) a[idx(i)] += problem.b[i];
}

template <class Solver>
std::unique_ptr<LcpSolver> make() {
  return std::make_unique<Solver>();
}

}  // namespace

std::string_view name_of(LcpStatus status) {
  switch (status) {
    case LcpStatus::solved: return "solved";
    case LcpStatus::infeasible: return "infeasible";
    case LcpStatus::not_positive_semidefinite: return "not_positive_semidefinite";
    case LcpStatus::singular: return "singular";
    case LcpStatus::cycling: return "cycling";
    case LcpStatus::cap_reached: return "cap_reached";
    case LcpStatus::least_violation: return "least_violation";
    case LcpStatus::ray: return "ray";
  }
  refuse("status = " + std::to_string(static_cast<int>(status)) + ": give one of LcpStatus");
}

double lcp_residual(const LcpProblem& problem, std::span<const double> f) {
  require_sizes(problem);
  if (f.size() != idx(problem.size()))
    refuse("f has " + std::to_string(f.size()) + " entries: give " +
           std::to_string(problem.size()));
  std::vector<double> a;
  accelerations(problem, f, a);
  return residual_of(problem, f, a);
}

void require_valid(const LcpProblem& problem, LcpMatrix needs) {
  require_sizes(problem);
  require_finite(problem);
  if (needs == LcpMatrix::symmetric_semidefinite) require_symmetric(problem.A);
  if (needs == LcpMatrix::positive_diagonal) require_positive_diagonal(problem.A);
}

void require_valid_start(int size, std::span<const int> start) {
  for (std::size_t k = 0; k < start.size(); ++k) {
    const int row = start[k];
    if (row < 0 || row >= size)
      refuse("start[" + std::to_string(k) + "] = " + std::to_string(row) +
             ": give a row from 0 to " + std::to_string(size - 1));
    const auto before = start.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::find(start.begin(), before, row) != before)
      refuse("start has row " + std::to_string(row) + " twice: give it once");
  }
}

void complete(const LcpProblem& problem, LcpResult& result) {
  assert(result.f.size() == idx(problem.size()));
  accelerations(problem, result.f, result.a);
  result.residual = residual_of(problem, result.f, result.a);
  result.pushing.reserve(result.f.size());
  result.pushing.clear();
  for (int i = 0; i < problem.size(); ++i)
    if (result.f[idx(i)] != 0.0) result.pushing.push_back(i);
}

void conclude(const LcpProblem& problem, LcpResult& result) {
  complete(problem, result);
  if (result.status == LcpStatus::solved && !holds(problem, result))
    result.status = LcpStatus::singular;
}

const std::vector<LcpRecipe>& lcp_solvers() {
  static const std::vector<LcpRecipe> solvers = {
      {"baraff", "3.3.1", "one contact after the other, for symmetric semidefinite matrices",
       make<BaraffSolver>},
      {"lemke", "3.3.1", "a path of pivots for any matrix, friction included", make<LemkeSolver>},
      {"gauss_seidel", "3.3.1", "projected sweeps, for a positive diagonal; slow on tall stacks",
       make<GaussSeidelSolver>},
      {"least_constraint", "2.6.2", "Gauss' principle, sure where bodies are known",
       make<LeastConstraintSolver>},
      {"augmented_lagrangian", "2.6.2",
       "springs whose preload grows; sparse and fastest where bodies are known",
       make<AugmentedLagrangianSolver>},
      {"baraff_as_printed", "3.3.1",
       "baraff as the thesis's program had it, absolute tolerance and all",
       make<BaraffAsPrintedSolver>},
      {"enumeration", "3.3.1", "every case there is, for any matrix of at most 8 rows",
       make<EnumerationSolver>},
  };
  return solvers;
}

std::unique_ptr<LcpSolver> make_lcp_solver(std::string_view name) {
  std::vector<std::string_view> names;
  for (const LcpRecipe& recipe : lcp_solvers()) {
    if (recipe.name == name) return std::make_unique<SafeguardedSolver>(recipe.make());
    names.push_back(recipe.name);
  }
  refuse("unknown solver " + std::string(name) + ": " + expected_names(name, names));
}

}  // namespace tumble
