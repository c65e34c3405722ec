/// \file
/// \brief A solver whose answers are judged, and a second attempt where they fail.
#pragma once

#include "tumble/lcp_solvers/least_violation.hpp"
#include "tumble/lcp_solvers/lemke_restarts.hpp"

#include <memory>

namespace tumble {

/// Runs a solver and keeps its answer bit by bit if that passes holds(), with forces that are not
/// suspiciously large. Else tries again:
///
/// - a symmetric positive semidefinite problem by LeastViolation;
/// - of other problems, those of few rows by trying every case, in scaled rows;
/// - larger ones by Lemke's method from other bases (LemkeRestarts).
///
/// The thesis's own form is judged but not helped, and neither are sweeps that end at their cap before a
/// solution: their failures are what they are known for. Nothing is `solved` that does not pass holds(),
/// or that pulls: a force below 0 by rounding becomes 0.
/// \verified{Of 8000 semidefinite problems in any units no solver calls a wrong answer solved}
class SafeguardedSolver final : public LcpSolver {
 public:
  /// \param core  the solver; not nullptr
  explicit SafeguardedSolver(std::unique_ptr<LcpSolver> core) : core_(std::move(core)) {}

  [[nodiscard]] std::string_view name() const override { return core_->name(); }

  /// \copydoc LcpSolver::solve
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  [[nodiscard]] bool sweeps() const { return core_->name() == "gauss_seidel"; }
  [[nodiscard]] bool needs_help(const LcpProblem& problem, const LcpResult& result) const;
  void try_again(const LcpProblem& problem, LcpResult& result);
  void try_any_matrix(const LcpProblem& problem, LcpResult& result);

  std::unique_ptr<LcpSolver> core_;
  LeastViolation least_violation_;
  LemkeRestarts restarts_;
  LcpResult second_;
};

}  // namespace tumble
