/// \file
/// \brief The figures of the chapter on filtering, in the order of its page.
#include "filtering/experiments.hpp"

#include "filtering/adaptive_experiments.hpp"
#include "filtering/box_experiments.hpp"
#include "filtering/detector_experiments.hpp"
#include "filtering/envelope_experiments.hpp"
#include "filtering/live_experiments.hpp"
#include "filtering/technique_chatter_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> filtering_figures() {
  std::vector<Figure> list;
  for (auto part : {technique_chatter_figures, box_figures, envelope_figures, live_figures,
                    detector_figures, adaptive_figures}) {
    for (Figure& figure : part()) list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace tumble::chapters
