/// \file
/// \brief The figures on envelopes.
#include "filtering/envelope_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure corner_path() {
  Figure figure;
  figure.name = "corner_path";
  figure.section = "5.5";
  figure.title = "One corner of a cube that chatters, under five filters";
  figure.caption =
      "Two seconds of one corner of the orange cube, which chatters most of the settled clump and "
      "slides slowly; every dot is a frame, the ring the first. Seen across the two directions of "
      "most movement. A mean over 5 frames leaves wriggling, one over 15 less. The envelope of the "
      "thesis shows four places and jumps from one to the next; ours creeps, without the shaking "
      "and without the jumps. Envelopes and the one-euro filter show the cube some millimetres "
      "behind where it is.";
  figure.parameters.add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_whole("seed", 1, 1, 1000, "of their orientations")
      .add_number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest")
      .add_number("watched", 2.0, 0.5, 60.0, "s", "of the path");
  figure.quick = {"per_edge=4", "settling=6", "watched=1"};
  figure.experiment = draw_corner_path;
  return figure;
}

Figure envelope_sweep() {
  Figure figure;
  figure.name = "claim_5_5c_envelope";
  figure.section = "5.5";
  figure.title = "Does an envelope hide chatter, and does it pop?";
  figure.caption =
      "Settled clumps of eight seeds under envelopes from a millimetre to five centimetres; the "
      "dotted line is the claim's. From above, of cubes that chatter: frames in which they stand "
      "still, jumps by an envelope or more, longest step, mean speed; and the overlap that "
      "filtering makes. From 2 mm on the thesis's envelope holds them still in nine frames of ten, "
      "but what drifts pops. Ours is still less often, and shows no pop from 5 mm on. Both let "
      "cubes overlap, by up to two radii.";
  figure.parameters.add_whole("seeds", 8, 1, 100, "clumps")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest")
      .add_number("watched", 4.0, 0.5, 60.0, "s", "after that");
  figure.quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2"};
  figure.experiment = sweep_envelope;
  return figure;
}

Figure fast_bodies() {
  Figure figure;
  figure.name = "claim_5_5d_fast";
  figure.section = "5.5";
  figure.title = "Does an envelope leave fast bodies alone?";
  figure.caption =
      "Above, a tossed cube: what moves by more than the envelope in a frame is shown where it "
      "is, by both envelopes; the one-euro filter lags by half a centimetre to three. While it "
      "slows down, between the envelope's speed and half of it, the thesis's envelope shows "
      "every other frame: it stutters. Ours falls behind gradually, and keeps the larger offset "
      "at rest. Below, the same for bodies at constant speed: the share of frames that are "
      "shown as computed, and how far the others are off.";
  figure.parameters.add_whole("seeds", 20, 1, 100, "clumps, and tossed cubes")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the clump's grid")
      .add_number("duration", 3.0, 0.5, 60.0, "s", "of a clump, from its start");
  figure.quick = {"seeds=2", "per_edge=3", "duration=1"};
  figure.experiment = follow_fast_bodies;
  return figure;
}

}  // namespace

std::vector<Figure> envelope_figures() { return {corner_path(), envelope_sweep(), fast_bodies()}; }

}  // namespace tumble::chapters
