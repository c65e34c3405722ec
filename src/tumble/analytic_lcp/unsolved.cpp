/// \file
/// \brief Files about a contact problem that was not solved.
#include "tumble/analytic_lcp/unsolved.hpp"

namespace tumble {

std::vector<Diagnostic> diagnostics_of(const LcpProblem* problem) {
  if (problem == nullptr) return {};
  return {{"unsolved_A.mtx", "A of the problem a = A f + b that ended the run", problem->A},
          {"unsolved_b.mtx", "b of the problem a = A f + b that ended the run", problem->b}};
}

}  // namespace tumble
