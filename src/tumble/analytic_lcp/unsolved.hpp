/// \file
/// \brief Files about a contact problem that was not solved.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble {

/// The files from which `tumble lcp` reads the problem again.
/// \param problem  a = A f + b; nullptr: none
/// \return unsolved_A.mtx and unsolved_b.mtx; empty for no problem
inline std::vector<Diagnostic> diagnostics_of(const LcpProblem* problem) {
  if (problem == nullptr) return {};
  return {{"unsolved_A.mtx", "A of the problem a = A f + b that ended the run", problem->A},
          {"unsolved_b.mtx", "b of the problem a = A f + b that ended the run", problem->b}};
}

}  // namespace tumble
