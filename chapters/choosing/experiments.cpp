/// \file
/// \brief The figures of the page on choosing a technique, in its order.
#include "choosing/experiments.hpp"

#include "choosing/cost_experiments.hpp"
#include "choosing/rest_experiments.hpp"
#include "choosing/work_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> choosing_figures() {
  std::vector<Figure> list;
  for (auto part : {work_against_error_figures, rest_and_tip_figures, cost_figures}) {
    for (Figure& figure : part()) list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace tumble::chapters
