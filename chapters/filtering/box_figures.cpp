/// \file
/// \brief The figures on the box filter.
#include "filtering/box_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure response_figure() {
  Figure figure;
  figure.name = "box_response";
  figure.section = "5.5";
  figure.title = "What does a box filter over five frames let through?";
  figure.caption =
      "Gain of the filter, measured by filtering a body that moves and one that turns as a cosine, "
      "on its closed form. Below 0 (shaded) motion is shown inverted. Only two frequencies are "
      "removed; a body that is elsewhere in every other frame keeps a fifth of its way, and slow "
      "motion passes. Below, the error in any frame over the amplitude, far under what is asked.";
  figure.parameters.add_whole("frames", 5, 3, 15, "in the window, odd")
      .add_whole("frequencies", 200, 2, 10000, "from 0 to half a cycle a frame, less one")
      .add_number("rate", 60.0, 1.0, 1e4, "1/s", "frames a second");
  figure.quick = {"frequencies=40"};
  figure.experiment = measure_box_response;
  return figure;
}

void add_clump(Figure& figure, int seeds) {
  figure.parameters.add_whole("seeds", seeds, 2, 1000, "clumps")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("settling", 10.0, 1.0, 1000.0, "s", "before bodies should rest")
      .add_number("watched", 4.0, 0.5, 1000.0, "s", "after that, a multiple of 0.5");
}

Figure spectra_figure() {
  Figure figure;
  figure.name = "claim_5_5a_spectra";
  figure.section = "5.5";
  figure.title = "What is left of chatter after a box filter?";
  figure.caption =
      "Corners of the cubes that chatter in the settled clump of figure 6.7, under damped. Above, "
      "their spectrum: computed, chatter is as strong at every frequency. Five frames cut away "
      "what is fast, and the slow part stays: that is the squirming. Below, amplitude and squirm "
      "over those computed, medians of the bodies, with intervals over seeds.";
  add_clump(figure, 8);
  figure.quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2"};
  figure.experiment = measure_box_spectra;
  return figure;
}

Figure width_figure() {
  Figure figure;
  figure.name = "claim_5_5b_width";
  figure.section = "5.5";
  figure.title = "What does a wider box filter cost?";
  figure.caption =
      "Widths from 1 to 15 frames. From the top: amplitude and squirm of the settled clump, "
      "medians "
      "of the bodies that chatter, beside white noise; sharpness, the largest change of speed of a "
      "cube that lands; overlap while the clump flies together; the landing. Wide windows remove "
      "squirm and blunt impacts. They push bodies into each other by centimetres, but the deepest "
      "overlap of a run grows no deeper: the computed one is averaged away, too.";
  add_clump(figure, 8);
  figure.parameters.add_number("flying", 3.0, 0.1, 1000.0, "s", "in which overlap is looked for")
      .add_whole("piles", 24, 2, 1000, "clumps in which overlap is looked for");
  figure.quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2", "piles=2"};
  figure.experiment = measure_box_widths;
  return figure;
}

Figure components_figure() {
  Figure figure;
  figure.name = "errata_filtering";
  figure.section = "5.5";
  figure.title = "Can the components of quaternions be averaged?";
  figure.caption =
      "A body turns past half a turn, where its stored quaternion changes sign; q and -q are one "
      "orientation. The mean of components over five frames jumps back by up to six times the "
      "turn in a frame; the mean of rotation vectors stays on the path. Below, errors against "
      "speed: with one sign the mean of components is nearly right, and too short.";
  figure.parameters.add_number("speed", 5.0, 0.01, 60.0, "rad/s", "of the body above")
      .add_whole("speeds", 40, 2, 10000, "in the sweep, less one")
      .add_number("fastest", 60.0, 1.0, 90.0, "rad/s", "of the sweep")
      .add_number("rate", 60.0, 60.0, 1e4, "1/s", "frames a second");
  figure.experiment = measure_component_means;
  return figure;
}

}  // namespace

std::vector<Figure> box_figures() {
  return {response_figure(), spectra_figure(), width_figure(), components_figure()};
}

}  // namespace tumble::chapters
