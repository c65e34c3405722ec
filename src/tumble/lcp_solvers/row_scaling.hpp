/// \file
/// \brief Rows of a problem in units of their own.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble {

/// The problem D A D, D b with a diagonal D that makes the diagonal of A about 1.
///
/// D is made of powers of two, so that no digit is lost. Where A_ii is not positive, the largest |A_ij| of
/// row and column stands for it. Solutions are f = D f', a = D⁻¹ a'. All numbers stay finite: an A_ii that is much too
/// small beside its row is taken for larger, and loads that would overflow are all divided by a power of two.
class ScaledProblem {
 public:
  /// Takes over a problem.
  /// \param problem a valid one
  void assign(const LcpProblem& problem);

  /// \return the scaled problem, without factors
  [[nodiscard]] const LcpProblem& problem() const { return scaled_; }

  /// Translates forces back.
  /// \param scaled [any] (n) forces of problem()
  /// \param f      [N] (n) forces of the problem
  void forces(std::span<const double> scaled, std::vector<double>& f) const;

 private:
  LcpProblem scaled_;
  std::vector<double> unit_;  // (n) the diagonal of D
  int lift_ = 0;              // b is divided by two as often
};

}  // namespace tumble
