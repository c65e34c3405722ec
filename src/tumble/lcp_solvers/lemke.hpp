/// \file
/// \brief Lemke's method: a path of pivots for any matrix (thesis 3.3.1, 2.6.3).
#pragma once

#include "tumble/lcp_solvers/block_rows.hpp"
#include "tumble/lcp_solvers/lemke_basis.hpp"

namespace tumble {

/// What can be chosen of Lemke's method.
struct LemkeOptions {
  int pivot_cap = 10000;  ///< pivots allowed; contacts take about 2n, the worst problems 2ⁿ
  /// [-] How far unknowns may fall below 0, as a share of max |b|. Above 0, of all rows that may leave the
  /// largest pivot does (Harris's rule) in place of the lexicographic one: rows that nearly depend on each
  /// other, as those of boxes that have turned by 1e-9, are then no danger, but circles are
  double slack = 0.0;
};

/// Lifts all contacts alike until none sinks, and then lowers the lift along a path of pivots.
///
/// With an additional unknown, the lift z >= 0,
/// \f[ a = A f + b + z\,\mathbf{1}, \qquad f \ge 0,\ a \ge 0,\ f_i a_i = 0 \f]
/// has a solution that needs no thought: f = 0 and z large. The least such z makes one a_i vanish. From
/// there on f_i grows in place of a_i, and whenever another unknown reaches 0 its partner, a_j for
/// f_j, f_j for a_j, grows next. Each move is a pivot, and each but the first has no choice. When z
/// itself reaches 0 the problem is solved.
///
/// Of unknowns that reach 0 together the lexicographic rule takes one: as if b_i were raised by
/// \f$\varepsilon^{i+1}\f$ with \f$\varepsilon \to 0\f$. Contacts of boxes tie all the time, and
/// without such a rule the path can run in circles. The lift goes first in a tie.
///
/// Equalities come first: their forces are solved for with complete pivoting and take no more part in
/// ties; a row that depends on others of them keeps the force 0, and must come out right by itself.
/// \par How it ends
/// `solved`; `ray` if an unknown grows for ever and nothing reaches 0; `singular`; `cap_reached`. If A is
/// copositive-plus, as every positive semidefinite matrix is, symmetric or not, then a ray proves that
/// there is no solution: where the symmetric part of A is found to be semidefinite the status is
/// `infeasible`. For a copositive A (contacts with friction) a ray does not happen if
/// \f$b \cdot f \ge 0\f$ for all solutions f of the problem with b = 0. For any other matrix nothing follows: the
/// method has failed, and there may or may not be a solution. So too, as `singular`, if the equalities'
/// own part of A has no inverse, unless A is symmetric and semidefinite.
/// \par Rounding
/// LemkeBasis gives each number with the bound of its rounding error, and no number is trusted below
/// it; so a matrix may be singular, and its rows in any units. Rows that depend on each other but for
/// a few digits can still mislead the path: an answer whose residual is above
/// `tolerance::usable_residual` ends as `singular`, never as `solved`.
/// \par Cost and determinism
/// O(n²) a pivot and O(n³) for a refinement. No allocation for a problem no larger than one before.
/// \see Lemke, "Bimatrix equilibrium points and mathematical programming", Management Science 11,
///      1965; Cottle, Pang, Stone, "The linear complementarity problem", 1992, 4.4 and 4.9.
/// \algorithm{Forces of contacts for any matrix, by Lemke: section 3.3.1}
/// \verified{All exact solvers find one motion in 10000 contact problems with redundant contacts}
class LemkeSolver : public LcpSolver {
 public:
  /// \throws std::invalid_argument if the cap or the slack is negative
  explicit LemkeSolver(const LemkeOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "lemke"; }

  /// Solves one problem.
  /// \param problem  any square matrix
  /// \param result   the answer. `pivots` counts every exchange of two unknowns, the first one of the
  ///                 lift and those of equalities included. Unless solved, f is the state reached
  /// \param start    is ignored
  /// \throws std::invalid_argument as require_valid() and require_valid_start()
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  [[nodiscard]] bool is_signed(int unknown) const;
  [[nodiscard]] bool is_lift(int unknown) const { return unknown == 2 * problem_->size(); }
  void solve_equalities(LcpResult& result);
  LcpStatus follow_path(LcpResult& result);
  int most_negative_row();
  int row_to_leave();
  void keep_first(const Rounded& numbers, double slack);
  [[nodiscard]] bool lift_is_zero() const;
  [[nodiscard]] bool left_over_equalities_hold() const;
  bool proves_infeasible();
  void set_forces(LcpResult& result);

  LemkeOptions options_;
  const LcpProblem* problem_ = nullptr;  // valid during solve()
  LemkeBasis basis_;
  Rounded values_;              // of the unknowns of the basis
  Rounded answer_;              // of the basis to the entering unknown
  Rounded column_;              // of the inverse, to break ties
  double slack_ = 0.0;          // the option times max |b|
  std::vector<int> ties_;       // rows that would leave together
  std::vector<int> open_rows_;  // equalities without a force in the basis
  LcpProblem symmetric_;        // the symmetric part of A
  BlockRows rows_;              // of it
};

}  // namespace tumble
