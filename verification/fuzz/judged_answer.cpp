/// \file
/// \brief The judge of answers to complementarity problems.
#include "fuzz/judged_answer.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/lcp_solvers/enumerate.hpp"
#include "tumble/lcp_solvers/gauss_seidel.hpp"
#include "tumble/lcp_solvers/safeguard.hpp"

#include "fuzz/promise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace tumble::fuzz {
namespace {

constexpr double kLargestResidual = 1e-6;  // [-] of what is called solved

// Sweeps that go to their cap and the cases of many rows would take most of a search. So there they are cut short but for
// one problem in 16. A test replays an input in full.
#ifdef TUMBLE_FUZZ_SEARCH
constexpr std::uint64_t kProblemsPerFull = 16;
#else
constexpr std::uint64_t kProblemsPerFull = 1;
#endif
constexpr int kFewSweeps = 300;
constexpr int kFewRows = 6;  // of which every case is tried

// What stands for A_ii in a row without a positive one, as lcp_residual() says.
double scale_of(const LcpProblem& problem, int i) {
  if (problem.A(i, i) > 0.0) return problem.A(i, i);
  const double largest = problem.A.row(i).cwiseAbs().maxCoeff();
  return largest > 0.0 ? largest : 1.0;
}

// [m/s²] The largest load that pushes in the rows which a row is joined with by entries of A, in units of that row.
double load_around(const LcpProblem& problem, const LcpResult& result, int row) {
  const int n = problem.size();
  std::vector<char> joined(idx(n), 0);
  std::vector<int> found = {row};
  joined[idx(row)] = 1;
  double load = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const int i = found[k];
    if (is_equality(problem, i) || problem.b[i] < 0.0 || result.f[idx(i)] != 0.0)
      load = std::max(load, std::abs(problem.b[i]) / std::sqrt(scale_of(problem, i)));
    for (int j = 0; j < n; ++j) {
      if (joined[idx(j)] != 0 || problem.A(j, i) == 0.0) continue;
      joined[idx(j)] = 1;
      found.push_back(j);
    }
  }
  return load * std::sqrt(scale_of(problem, row));
}

// By its numbers, so that a finding shows itself again.
bool is_tried_in_full(const LcpProblem& problem) {
  std::uint64_t mixed = 0;
  for (int i = 0; i < problem.size(); ++i)
    for (const double value : {problem.A(0, i), problem.b[i]})
      mixed = (mixed ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
  return (mixed >> 32U) % kProblemsPerFull == 0;
}

// nullptr: this solver is left out.
std::unique_ptr<LcpSolver> solver_for(const LcpProblem& problem, std::string_view name) {
  if (!is_tried_in_full(problem)) {
    if (name == EnumerationSolver().name() && problem.size() > kFewRows) return nullptr;
    if (name == GaussSeidelSolver().name()) {
      GaussSeidelOptions few;
      few.sweeps = kFewSweeps;
      return std::make_unique<SafeguardedSolver>(std::make_unique<GaussSeidelSolver>(few));
    }
  }
  return make_lcp_solver(name);
}

}  // namespace

void require_solved(const LcpProblem& problem, const LcpResult& result, std::string_view solver) {
  const int n = problem.size();
  const std::string name(solver);
  promise(static_cast<int>(result.f.size()) == n, name + ": solved, with another number of forces");
  const double loads =
      n > 0 && problem.b.cwiseAbs().maxCoeff() > 0.0 ? problem.b.cwiseAbs().maxCoeff() : 1.0;
  for (int i = 0; i < n; ++i) {
    const std::string row = name + ": solved, row " + std::to_string(i);
    const double f = result.f[idx(i)];
    promise(std::isfinite(f), row + ": f = " + shortest_text(f));
    double a = problem.b[i];
    double terms = std::abs(a);
    for (int k = 0; k < n; ++k) {
      a += problem.A(i, k) * result.f[idx(k)];
      terms += std::abs(problem.A(i, k) * result.f[idx(k)]);
    }
    const double rounding = 2.0 * n * std::numeric_limits<double>::epsilon() * terms / loads;
    const bool equality = is_equality(problem, i);
    const double wrong = equality ? a : std::min(scale_of(problem, i) * f, a);
    promise(std::abs(wrong) / loads <= kLargestResidual + rounding,
            row + ": residual = " + shortest_text(std::abs(wrong) / loads));
    promise(std::abs(wrong) <= kLargestResidual * terms ||
                std::abs(wrong) <= kLargestResidual * load_around(problem, result, i),
            row + ": breaks its conditions by " + shortest_text(std::abs(wrong)) + " of " +
                shortest_text(terms));
    promise(equality || f >= 0.0, row + ": f = " + shortest_text(f));
  }
}

void require_honest_solvers(const LcpProblem& problem) {
  for (const LcpRecipe& recipe : lcp_solvers()) {
    const std::unique_ptr<LcpSolver> solver = solver_for(problem, recipe.name);
    if (!solver) continue;
    LcpResult result;
    std::string why;
    const bool refused = refuses([&] { solver->solve(problem, result); }, &why);
    // The problem is finite, so a number that is none comes from a part of the solver.
    promise(why.find("= inf") == std::string::npos && why.find("= nan") == std::string::npos,
            std::string(recipe.name) + " refuses what was not given: " + why);
    if (!refused && result.status == LcpStatus::solved)
      require_solved(problem, result, recipe.name);
  }
}

}  // namespace tumble::fuzz
