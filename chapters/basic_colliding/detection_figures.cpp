/// \file
/// \brief The figures of the claims on finding collisions: parameters, captions.
#include "basic_colliding/experiments.hpp"

namespace tumble::chapters {
namespace {

Figure missed_passes_figure() {
  Figure figure;
  figure.name = "claim_3_2a_missed";
  figure.section = "3.2";
  figure.title = "What a test at the end of each step misses";
  figure.caption =
      "A cube of 0.25 m tumbles past a hanging one of 1 m, along 20000 random lines for each "
      "speed, all equally likely, so that brushes come in their true share. Above, how many "
      "of the collisions a test at the end of each step finds. The conservative search tells "
      "the truth, the line at 1: dense sampling of every twentieth pass found no collision "
      "that it missed. At 4 thicknesses a step three in four are found, and less than nine in"
      " ten for cubes half and twice as thick as well; but a cube of 0.06 m, which at 4 of "
      "its thicknesses moves little against the large one, is found 93 times in 100. Below, "
      "the same cube: of the brushes, never deeper than a tenth of the thickness, some are "
      "missed at any speed; deeper collisions are safe up to half a thickness a step. Rings: "
      "when no overlap outlasts a step, the share is the mean length of the overlap over the "
      "way of a step, 4 V/S for the sum of both bodies, averaged over orientations.";
  figure.parameters
      .add_whole("passes", 20000, 100, 1000000, "random passes for each speed and size")
      .add_number("thickness", 0.25, 0.01, 1.0, "m",
                  "edge of the small cube; the large one has 1 m")
      .add_number("spin", 10.0, 0.0, 100.0, "rad/s", "largest spin of the small cube");
  figure.quick = {"passes=1000"};
  figure.experiment = measure_missed_passes;
  return figure;
}

Figure missed_visible_figure() {
  Figure figure;
  figure.name = "claim_3_2b_visible";
  figure.section = "3.2";
  figure.title = "Visible collisions that the end-of-step test misses in the thesis's scenes";
  figure.caption =
      "A projectile hits a pyramid of 28 cubes, and a clump of 64, at 20 m/s and 60 steps a "
      "second; 20 seeds vary its aim and orientation. The basic technique moves the bodies "
      "for the first second, with restitution 0.9 and at most 50 moments of impact in a step."
      " Before each step every pair that is apart is searched conservatively, in free flight:"
      " a collision is visible if the overlap exceeds 1 % of a cube before the end of the "
      "step, and missed if the two are apart again by then. Above, the share missed against "
      "the overlap that counts as visible, with intervals over the seeds: 0.3 % at 1 % of the"
      " size, so not every visible collision is caught, but very nearly. Below, the numbers: "
      "30 of 9000 are missed. None of them goes deeper than a tenth of a cube.";
  figure.parameters.add_whole("seeds", 20, 1, 1000, "runs of each scene")
      .add_whole("rows", 7, 1, 20, "rows of the pyramid")
      .add_whole("per_edge", 4, 1, 6, "cubes along each edge of the clump")
      .add_number("duration", 1.0, 0.1, 10.0, "s", "length of a run")
      .add_whole("event_cap", 50, 1, 100000, "moments of impact in a step");
  figure.quick = {"seeds=4"};
  figure.experiment = measure_missed_visible;
  return figure;
}

Figure restarts_figure() {
  Figure figure;
  figure.name = "claim_3_3_1c_restarts";
  figure.section = "3.3.1";
  figure.title = "The search for an impact starts again less often with smaller steps";
  figure.caption =
      "60 cubes in a cage without gravity, 2.5 m of edge for each, 10 s, 20 seeds. Blue: how "
      "often the search for an impact starts again because another pair collides earlier, per"
      " collision. It falls with the step, by a factor of 7 from 1/60 s to 1/480 s: "
      "confirmed. But most restarts are no surprise: the search takes any pair that overlaps "
      "at the end of the step, and another one that overlaps there met before. Orange: of the"
      " searches at the start of a step that take the earliest of those pairs, the share that"
      " still uncovers an earlier collision, of two bodies that are apart again at the end. "
      "That is the case that the thesis tells of, and it falls with the square of the step. "
      "Its last two marks are one or two events.";
  figure.parameters.add_whole("seeds", 20, 1, 1000, "runs for each step")
      .add_whole("varied", 4, 1, 1000, "runs with half and with twice as many cubes")
      .add_whole("duration", 10, 1, 100, "length of a run in seconds")
      .add_whole("count", 60, 2, 1000, "cubes")
      .add_number("room", 2.5, 1.8, 100.0, "m", "edge of the space that each cube has");
  figure.quick = {"seeds=2", "varied=2", "duration=5"};
  figure.experiment = measure_restarts;
  return figure;
}

Figure subdivision_figure() {
  Figure figure;
  figure.name = "claim_4_1a_subdivision";
  figure.section = "4.1";
  figure.title = "Tests of bounds with and without spatial subdivision";
  figure.caption =
      "Cubes of 1 m fly and tumble through a space of 2 m of edge for each, whatever their "
      "number. Above, how often two axis-aligned bounds are tested in a step; the tests of "
      "all pairs grow with the square of the number, those of the broad phases in proportion "
      "to it. Below, how many tests each saves: at 1000 bodies the best one needs 150 times "
      "fewer than all pairs, confirmed. All four find the same pairs. The other half of the "
      "claim, that few bodies do without, shows in the size of the numbers: the 55 boxes of "
      "the thesis's pyramid make 1500 tests of a few comparisons, and the tree pays from 4"
      " bodies on. Sorting bodies and dealing them to columns or cells is not counted "
      "here, so that the other two seem to save work for a handful of bodies already.";
  figure.parameters.add_whole("seeds", 20, 1, 1000, "runs for each number of bodies")
      .add_whole("steps", 30, 1, 1000, "of 1/60 s in a run")
      .add_number("spacing", 2.0, 1.0, 100.0, "m", "edge of the space that each cube has")
      .add_whole("most", 3000, 2, 3000, "most bodies");
  figure.quick = {"seeds=2", "most=1000"};
  figure.experiment = measure_subdivision;
  return figure;
}

Figure signed_distance_figure() {
  Figure figure;
  figure.name = "claim_3_3_2b_signed_distance";
  figure.section = "3.3.2";
  figure.title = "The signed distance of a box costs little more than its closest face";
  figure.caption =
      "Above, operations to get a normal for a point, over a million random boxes and points;"
      " the figure on each bar is arithmetic, grey are comparisons. Most of it is the change "
      "of frame that the closest face needs as well: the signed distance costs 1.25 times as "
      "much inside and twice outside. The counted functions give the same bits as the "
      "library's. In the middle, how far the thesis's substitute is off, the closest face of "
      "the frame before: a corner of a tumbling cube passes another one at 2 m/s, in frames "
      "of 1/60 s, within a tenth of an edge of the surface. Inside, where it is used, it is "
      "right or wrong by 90 degrees, in 7 % of the frames. Below, the share off by more than "
      "10 degrees grows with the way in a frame; outside, near edges, the closest face is no "
      "normal even without delay.";
  figure.parameters.add_whole("queries", 1000000, 100, 100000000, "random boxes and points")
      .add_whole("paths", 40000, 10, 1000000, "random paths of a corner past a box, per speed")
      .add_number("speed", 2.0, 0.0, 1000.0, "m/s", "of the corner in the histogram")
      .add_number("spin", 5.0, 0.0, 100.0, "rad/s", "largest spin of either body");
  figure.quick = {"queries=20000", "paths=1000"};
  figure.experiment = measure_signed_distance;
  return figure;
}

}  // namespace

void add_detection_figures(std::vector<Figure>& list) {
  list.push_back(missed_passes_figure());
  list.push_back(missed_visible_figure());
  list.push_back(restarts_figure());
  list.push_back(subdivision_figure());
  list.push_back(signed_distance_figure());
}

}  // namespace tumble::chapters
