/// \file
/// \brief Lemke's method begun at other bases, for matrices for which a ray proves nothing.
#pragma once

#include "tumble/lcp_solvers/lemke.hpp"
#include "tumble/lcp_solvers/row_scaling.hpp"
#include "tumble/lcp_solvers/twins.hpp"

#include <array>

namespace tumble {

/// Tries Lemke's method on principal transforms of a problem.
///
/// A set of rows α whose A_αα has an inverse exchanges its forces and accelerations,
/// \f[ \begin{pmatrix} f_\alpha \\ a_\beta \end{pmatrix} = A' \begin{pmatrix} a_\alpha \\ f_\beta \end{pmatrix} + b', \f]
/// which has the same solutions and another path. In rows of unit diagonal (ScaledProblem) are tried: the
/// problem itself, with equalities as pairs of contacts (TwinProblem), also with slack for rows that nearly depend on each other; all single rows; and all
/// pairs, in their order, up to a number of attempts and of multiplications. So games of two players are solved, whose first path ends on a ray at once.
/// \see Cottle, Pang, Stone, "The linear complementarity problem", 1992, 2.3 and 4.4.
class LemkeRestarts {
 public:
  /// With solvers that differ in their slack.
  LemkeRestarts();

  /// Tries until an answer passes holds().
  /// \param result   the answer if there is one; else it is left as it is
  /// \return whether there is one
  bool solve(const LcpProblem& problem, LcpResult& result);

 private:
  bool attempt(std::span<const int> exchanged, LemkeSolver& solver, const LcpProblem& problem,
               LcpResult& result);
  bool exchange(std::span<const int> exchanged);

  std::array<LemkeSolver, 3> solvers_;  // without slack, and with two sizes of it
  ScaledProblem units_;
  TwinProblem twins_;
  LcpProblem scaled_;  // the twins'
  LcpProblem transformed_;
  LcpResult answer_;
};

}  // namespace tumble
