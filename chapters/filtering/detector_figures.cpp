/// \file
/// \brief The figures on the detector of chatter.
#include "filtering/detector_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure detector_figure() {
  Figure figure;
  figure.name = "claim_6_3_1c_detector";
  figure.section = "6.3.1";
  figure.title = "Do earlier frames tell who chatters?";
  figure.caption =
      "Bodies whose whole run says what they do, told by rules that see half a second of the past. "
      "Above, chatter found against false alarms; a curve ends where its rule's other conditions "
      "let nothing more through. The rule asks for three turns back and little drift. Path over "
      "way "
      "takes a tenth of rocking for chatter. Speed takes slow sliding first. Middle, who is told "
      "to "
      "chatter with the standard numbers (dots above). Below, other windows: half a second is "
      "best. "
      "Numbers were chosen on other seeds.";
  figure.parameters.add_whole("seeds", 20, 2, 1000, "clumps, and as many sets of single boxes")
      .add_whole("first_seed", 13, 1, 1000000,
                 "the rule's numbers were chosen on 1 to 4, the labels mended after 5 to 12")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of a clump's grid at the start")
      .add_whole("boxes", 4, 1, 1000, "of each kind, under each of two techniques");
  figure.quick = {"seeds=2", "first_seed=5", "per_edge=3", "boxes=1"};
  figure.experiment = measure_detector;
  return figure;
}

Figure freezing_figure() {
  Figure figure;
  figure.name = "freezing_clump";
  figure.section = "6.3.1";
  figure.title = "Can a heap that chatters be left alone?";
  figure.caption =
      "The clump of figure 6.7 under damped; a cube comes in at 12 s and hits it. With sleeping "
      "by speed hardly anybody ever sleeps: chatter is too fast. If bodies count as slow whose "
      "earlier frames tell that they rest or chatter, half sleep after two seconds, nearly all "
      "chatter ends and the work falls with it. The cube wakes whom it can reach through "
      "contacts, and they freeze again. Nothing jumps: poses stay as they are.";
  figure.parameters.add_whole("seeds", 4, 2, 1000, "clumps; the first is drawn")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("settling", 12.0, 4.0, 1000.0, "s", "before the cube comes in")
      .add_number("watched", 6.0, 2.0, 1000.0, "s", "after that")
      .add_number("speed", 15.0, 0.0, 100.0, "m/s", "of the cube");
  figure.quick = {"seeds=2", "per_edge=3", "settling=5", "watched=2"};
  figure.experiment = measure_freezing;
  return figure;
}

}  // namespace

std::vector<Figure> detector_figures() { return {detector_figure(), freezing_figure()}; }

}  // namespace tumble::chapters
