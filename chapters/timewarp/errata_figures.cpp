/// \file
/// \brief The figures of the errata of SIMPLESYNCTIMEWARP and SAFERSYNCTIMEWARP (thesis 5.1, A.1).
#include "timewarp/errata_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure errata_figure(const std::string& name) {
  Figure figure;
  figure.name = name;
  figure.section = "5.1, A.1";
  figure.parameters.add_whole("cap", 1000, 1, 1000000,
                              "passes of the main loop after which an endless run is left");
  figure.quick = {"cap=50"};
  return figure;
}

}  // namespace

std::vector<Figure> errata_figures() {
  Figure simple = errata_figure("errata_timewarp_simple");
  simple.title = "Where the simple timewarp fails as printed, and the same mended";
  simple.caption =
      "Left: one misprint of SIMPLESYNCTIMEWARP left in, the others mended (T2 with T1, T7 with "
      "T6). "
      "Right: mended, too; for the choices T5 and T9 swept volumes, and collisions at one stroke. "
      "Lines are the ways of cubes, dots collisions. T1, T2: the second cube collides before it "
      "has "
      "flown. T3: the pair is found again, at the end; dotted: the valid time. T4: the third event "
      "comes before the others (lines join collisions as they are resolved). T6, T7: no end but a "
      "cap; of T6 the first bounces. T8, grey: the true fall. T10 does no "
      "harm.";
  simple.experiment = measure_simple_errata;

  Figure safer = errata_figure("errata_timewarp_safer");
  safer.title = "Where the safer timewarp fails as printed, and the same mended";
  safer.caption =
      "As the figure before, for SAFERSYNCTIMEWARP (F6 with T7). F1: two cubes collide four times, "
      "and the first is back at its start. F3, F4: a neighbour stays where it was at the "
      "collision. "
      "F5: a collision that waits is gone. F6: the pair is its own neighbour, for ever. "
      "F7: a "
      "cube flies over another. F8, figure 5.1 laid out anew: A flies over B, as the thesis says; "
      "not so with swept volumes, right. F9: arrows show whom D is said to meet, and whom it does.";
  safer.experiment = measure_safer_errata;
  return {simple, safer};
}

}  // namespace tumble::chapters
