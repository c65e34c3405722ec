/// \file
/// \brief The linear complementarity problem of contact forces, and the interface of its solvers
///        (thesis 2.6, 3.3.1).
///
/// **Another solver** is a class of its own file that implements LcpSolver, and one line in lcp_solvers() in lcp.cpp. With
/// it `tumble lcp`, the technique `analytic`, the fuzz targets and the tests over all solvers know it.
#pragma once

#include "tumble/lcp_solvers/factors.hpp"
#include "tumble/math/dense.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// Find f with a = A f + b such that in each row either \f$f_i \ge 0, a_i \ge 0, f_i a_i = 0\f$ (a
/// contact pushes or separates), or \f$a_i = 0\f$ with f_i of any sign (an equality: glue, a hinge).
struct LcpProblem {
  MatX A;                      ///< [1/kg] (n×n)
  VecX b;                      ///< [m/s²] (n) what a would be without forces
  std::vector<char> equality;  ///< (n) or empty: not 0 for a row whose force has any sign
  LcpFactors factors = {};     ///< of A; may be empty, since few solvers need them
  /// \return n
  [[nodiscard]] int size() const { return static_cast<int>(b.size()); }
};

/// How a solver ended.
enum class LcpStatus : std::uint8_t {
  solved,                     ///< f holds a solution to the solver's tolerance
  infeasible,                 ///< there is none
  not_positive_semidefinite,  ///< A is found not to be positive semidefinite, which the solver needs
  cycling,                    ///< an index set was reached a second time
  singular,                   ///< a linear system had no solution, or the answer fails holds()
  cap_reached,                ///< the cap on pivots or sweeps was reached; f is the state then
  least_violation,            ///< there is none; f has the least violation, `residual`
  ray                         ///< Lemke's path ended on a ray: there may be a solution or not
};

/// The name of a status in files, for example "solved".
std::string_view name_of(LcpStatus status);

/// An answer. Used again for the next problem, it allocates nothing.
struct LcpResult {
  LcpStatus status = LcpStatus::solved;  ///< how the solver ended
  std::vector<double> f;                 ///< [N] (n) forces
  std::vector<double> a;                 ///< [m/s²] (n) A f + b, computed from f
  std::vector<int> pushing;          ///< rows with a force, ascending: a start for the next solve
  int pivots = 0;                    ///< changes of the index sets; sweeps for an iteration
  double residual = 0.0;             ///< [-] see lcp_residual()
  std::int64_t multiplications = 0;  ///< work of the solver, counted

  /// Whether it is solved to an accuracy.
  /// \param most  [-] largest residual accepted
  /// \return false for every other status
  [[nodiscard]] bool solved_within(double most) const {
    return status == LcpStatus::solved && residual <= most;
  }
};

/// Residual of an answer, the same for all solvers.
/// \return [-] \f$\max_i |\min(A_{ii} f_i, a_i)| / \max_i |b_i|\f$, with |a_i| for equalities; the
///         numerator if b = 0; 0 for n = 0. Where A_ii is not positive, which no contact has but a
///         row of friction may, the largest |A_ij| of the row stands for it, or 1 if all are 0
/// \throws std::invalid_argument if the sizes differ
double lcp_residual(const LcpProblem& problem, std::span<const double> f);

/// Matrices that a solver takes.
enum class LcpMatrix : std::uint8_t {
  any,                    ///< any square matrix
  positive_diagonal,      ///< A_ii > 0
  symmetric_semidefinite  ///< symmetric and positive semidefinite
};

/// Refuses an invalid problem.
/// \param needs   matrices that the solver takes
/// \throws std::invalid_argument naming the row and the value: sizes that differ, a number that is
///         not finite, an asymmetric A for a solver that needs a symmetric one
void require_valid(const LcpProblem& problem, LcpMatrix needs);

/// Refuses an invalid list of rows to start with.
/// \throws std::invalid_argument naming a row that is out of range or given twice
void require_valid_start(int size, std::span<const int> start);

/// Whether a row is an equality; true if its force may have any sign and its acceleration has to be 0.
inline bool is_equality(const LcpProblem& problem, int row) {
  return !problem.equality.empty() && problem.equality[static_cast<std::size_t>(row)] != 0;
}

/// Computes a, `pushing` and the residual from the forces.
/// \param result  f of length n, given
void complete(const LcpProblem& problem, LcpResult& result);

/// complete(); then the status `solved` becomes `singular` unless the answer passes holds().
/// \param result  f of length n and a status, given
void conclude(const LcpProblem& problem, LcpResult& result);

/// Residual after each row is divided by the root of its A_ii, so that it does not depend on the rows' units.
/// \param result   after complete()
/// \return [-] as lcp_residual(), each row and each b_i over the root of A_ii or what stands for it; infinite if
///         a number of f or a is not finite
double scaled_residual(const LcpProblem& problem, const LcpResult& result);

/// Whether an answer may be called solved: its residual, its scaled residual and its row residual (judge.hpp) are at
/// most `tolerance::usable_residual`.
/// \param result   after complete()
/// \return false also if a number in it is not finite
bool holds(const LcpProblem& problem, const LcpResult& result);

/// A solver of the problem.
class LcpSolver {
 public:
  virtual ~LcpSolver() = default;

  /// The name in commands and files, for example "lemke".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Solves one problem.
  /// \param problem  n = 0 gives `solved`
  /// \param result   the answer; all of it is overwritten
  /// \param start    rows that are taken as pushing at first, for example `pushing` of a similar problem. It may save
  ///                 work, and any answer is still checked; some solvers ignore it. May be `result.pushing` itself
  /// \throws std::invalid_argument as require_valid(), or for a row of start that is out of range or
  ///         given twice
  virtual void solve(const LcpProblem& problem, LcpResult& result,
                     std::span<const int> start = {}) = 0;
};

/// A solver that a user can name.
struct LcpRecipe {
  std::string_view name;                 ///< what a user calls it
  std::string_view section;              ///< thesis section
  std::string_view summary;              ///< one line
  std::unique_ptr<LcpSolver> (*make)();  ///< with its defaults
};

/// All solvers, in the order in which `tumble lcp --list` shows them.
const std::vector<LcpRecipe>& lcp_solvers();

/// Makes a solver, with the safeguards of SafeguardedSolver.
/// \throws std::invalid_argument listing the names if there is none of this name
std::unique_ptr<LcpSolver> make_lcp_solver(std::string_view name);

}  // namespace tumble
