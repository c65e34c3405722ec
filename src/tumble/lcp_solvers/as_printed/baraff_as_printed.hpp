/// \file
/// \brief Baraff's pivoting the way the thesis describes its own program (thesis 3.3.1).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

namespace tumble {

/// Options of BaraffAsPrintedSolver.
struct BaraffAsPrintedOptions {
  double eps = tolerance::sinking;  ///< [m/s²] what sinks no faster is left alone; 0 or more
  bool clamp = true;                ///< whether negative forces are set to 0 in the end
  int pivots_per_row = 50;          ///< [-] give up after n + 1 times as many pivots; at least 1
};

/// Where a contact is while BaraffAsPrintedSolver is at work.
enum class BaraffSet : std::uint8_t {
  none,  ///< not looked at yet, or driven right now
  C,     ///< its force may grow and shrink, its acceleration is 0
  NC     ///< it separates, without a force
};

/// The state after a step of BaraffAsPrintedSolver, valid until the observer returns.
struct BaraffStep {
  int driven = 0;                   ///< the contact whose force grew
  int ended_by = 0;                 ///< the contact that ended the step and has just changed sets
  double length = 0.0;              ///< [N] by how much the force grew
  std::span<const BaraffSet> sets;  ///< (n) after the step
  std::span<const double> f;        ///< [N] (n) after the step
  std::span<const double> a;        ///< [m/s²] (n) after the step
};

/// Watches BaraffAsPrintedSolver.
class BaraffObserver {
 public:
  virtual ~BaraffObserver() = default;

  /// A step has ended.
  virtual void on_step(const BaraffStep& step) = 0;
};

/// Baraff's pivoting as in 1994, with the two changes that the thesis made, and Gaussian
/// elimination.
///
/// A force grows at a sinking contact until it sinks no more, while contacts that push stay at rest
/// (the set C) and those that have ceased to push go on separating (the set NC); where one of them
/// would break its condition, it moves to the other set. The changes: a contact d sinks if
/// \f$a_d < -\varepsilon\f$, not if \f$a_d < 0\f$; and in the end negative forces are set to 0,
/// whatever that does to the accelerations.
///
/// This is the form to look at, not to use: ComplementaritySolver and the solver "baraff" are the
/// same method with a tolerance that knows the size of the problem, with dependent contacts
/// recognised, and with nothing to clamp.
/// \par How it ends
/// `solved` when no contact sinks by more than eps; `infeasible` when a force may grow for ever;
/// `singular` when elimination meets a column of zeros, which rounding makes rare;
/// `cap_reached`, the usual end of eps = 0 with redundant contacts. Except when solved, forces are
/// as they were, not clamped.
/// \par Cost
/// O(|C|³) a pivot.
/// \see Baraff, "Fast contact force computation for nonpenetrating rigid bodies", SIGGRAPH 1994, 4.
/// \algorithm{Forces of resting contacts as the thesis's program found them: section 3.3.1}
class BaraffAsPrintedSolver final : public LcpSolver {
 public:
  /// Makes a solver.
  /// \throws std::invalid_argument for an option out of its range
  explicit BaraffAsPrintedSolver(const BaraffAsPrintedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "baraff_as_printed"; }

  /// \copydoc LcpSolver::solve
  /// \note Begins with no contact pushing: `start` is checked and not used. A must be symmetric.
  ///       The thesis's program has no equalities, and a problem with one is refused
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

  /// Shows every step to an observer.
  /// \param observer  must outlive the solver or be replaced; nullptr for none
  void observe(BaraffObserver* observer) { observer_ = observer; }

 private:
  using Set = BaraffSet;
  struct Step;

  LcpStatus drive_to_zero(const MatX& A, int d, LcpResult& result);
  bool fdirection(const MatX& A, int d, LcpResult& result);
  [[nodiscard]] Step maxstep(int d, const LcpResult& result) const;
  bool eliminate(LcpResult& result);

  BaraffAsPrintedOptions options_;
  BaraffObserver* observer_ = nullptr;
  std::vector<Set> set_;         // (n) where each contact is
  std::vector<int> C_;           // the contacts of C, ascending
  std::vector<double> df_, da_;  // (n) change of f and a per unit force at d
  MatX system_;                  // (|C|×|C|+1) A_CC and -A_Cd, then what elimination makes of them
};

}  // namespace tumble
