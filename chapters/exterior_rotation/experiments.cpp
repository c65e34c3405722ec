/// \file
/// \brief The figures of the chapter on exterior rotation, in the order of its page.
#include "exterior_rotation/experiments.hpp"

#include "exterior_rotation/cure_figures.hpp"
#include "exterior_rotation/errata_experiments.hpp"
#include "exterior_rotation/footnote_figures.hpp"
#include "exterior_rotation/order_figures.hpp"
#include "exterior_rotation/problem_figures.hpp"
#include "exterior_rotation/technique_figures.hpp"

namespace tumble::chapters {

std::vector<Figure> exterior_rotation_figures() {
  std::vector<Figure> list;
  for (auto part : {problem_figures, integration_order_figures, footnote_figures, cure_figures,
                    technique_figures, rotation_errata_figures}) {
    for (Figure& figure : part()) list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace tumble::chapters
