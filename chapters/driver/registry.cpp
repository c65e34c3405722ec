/// \file
/// \brief The figures of a program, each declared where it is measured.
#include "driver/registry.hpp"

#include <algorithm>
#include <iterator>

namespace tumble::chapters {
namespace {

using FigureMaker = std::function<std::vector<Figure>()>;

// Filled before main() begins, in an order that the linker chooses.
std::vector<FigureMaker>& figure_makers() {
  static std::vector<FigureMaker> makers;
  return makers;
}

}  // namespace

Registered::Registered(Figure figure) {
  figure_makers().push_back([figure = std::move(figure)] { return std::vector<Figure>{figure}; });
}

Registered::Registered(std::vector<Figure> (*figures)()) { figure_makers().emplace_back(figures); }

std::vector<Figure> registered_figures() {
  std::vector<Figure> figures;
  for (const FigureMaker& make : figure_makers()) {
    std::vector<Figure> more = make();
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  }
  std::ranges::sort(figures, [](const Figure& a, const Figure& b) { return a.name < b.name; });
  const auto twice =
      std::adjacent_find(figures.begin(), figures.end(),
                         [](const Figure& a, const Figure& b) { return a.name == b.name; });
  if (twice != figures.end())
    throw std::invalid_argument("figure " + twice->name + " is registered twice");
  return figures;
}

Figure registered_figure(std::string_view name) {
  for (const Figure& figure : registered_figures())
    if (figure.name == name) return figure;
  throw std::invalid_argument("no figure " + std::string(name));
}

}  // namespace tumble::chapters
