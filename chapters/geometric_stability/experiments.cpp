/// \file
/// \brief The figures of the chapter on geometric stability, in the order of its page.
#include "geometric_stability/experiments.hpp"

#include "geometric_stability/balance_figures.hpp"
#include "geometric_stability/excluded_experiments.hpp"
#include "geometric_stability/pile_experiments.hpp"
#include "geometric_stability/sliding_experiments.hpp"
#include "geometric_stability/support_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> geometric_stability_figures() {
  std::vector<Figure> list;
  for (auto part :
       {support_figures, excluded_figures, pile_figures, sliding_figures, balance_figures}) {
    for (Figure& figure : part()) list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace tumble::chapters
