/// \file
/// \brief A judge of answers to complementarity problems that uses nothing of the solvers.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <string_view>

namespace tumble::fuzz {

// Breaks the promise if an answer that is called solved is none: f finite, f >= 0 but in equalities, and a
// residual of at most 1e-6, computed here, plus the rounding of the sums in A f + b; in each row also of its own terms, or
// of the loads that push in rows joined with it.
void require_solved(const LcpProblem& problem, const LcpResult& result, std::string_view solver);

// Gives the problem to every solver of lcp_solvers(), each with its safeguards, and judges what is called solved, and
// what is refused: a problem of finite numbers has no others.
void require_honest_solvers(const LcpProblem& problem);

}  // namespace tumble::fuzz
