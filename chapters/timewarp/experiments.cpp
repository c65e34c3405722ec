/// \file
/// \brief The figures of the chapter on timewarp, in the order of its page.
#include "timewarp/experiments.hpp"

#include "timewarp/crowd_experiments.hpp"
#include "timewarp/errata_experiments.hpp"
#include "timewarp/order_figures.hpp"
#include "timewarp/rewind_experiments.hpp"
#include "timewarp/tie_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> timewarp_figures() {
  std::vector<Figure> list;
  for (auto part : {order_figures, crowd_figures, tie_figures, rewind_figures, errata_figures}) {
    for (Figure& figure : part()) list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace tumble::chapters
