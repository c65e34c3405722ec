/// \file
/// \brief The figures of the chapter on contact forces, in the order of its page.
#include "analytic_lcp/experiments.hpp"

#include "analytic_lcp/work_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> analytic_lcp_figures() {
  std::vector<Figure> list;
  add_force_figures(list);
  add_solver_figures(list);
  add_work_figures(list);
  add_time_stepping_figures(list);
  add_joined_figures(list);
  return list;
}

}  // namespace tumble::chapters
