/// \file
/// \brief The figures of the errata of DAMPENOBJECTS, FIXCONTACTCONSTRAINTS and
///        SETGEOMETRICALLYSTABLE.

#include "tumble/impulse_damped/tolerances.hpp"

#include "impulse_damped/errata_damping_experiments.hpp"

namespace tumble::chapters {

void add_damping_errata_figures(std::vector<Figure>& list) {
  Figure damping;
  damping.name = "errata_damping";
  damping.section = "4.4, 5.3, A.2";
  damping.title = "Where damping and the ending of overlap fail, and the same mended";
  damping.caption =
      "Left: as printed. Right: mended, or a cure where the author meant it. DM7: damped in the "
      "world, "
      "two cubes that touch while they fall come to a final speed. DM9: a component of the spin "
      "set "
      "to 0 leaves a long box with up to 2.65 times the energy, at a tilt of 45°; a cube would "
      "lose "
      "some always. DM10: components that end one by one bend a slide towards an axis, here by "
      "30°. "
      "DM11: what gravity gives in a step is small enough to be set to 0, and a cube that touches "
      "a "
      "wall hangs there. DM12: moves below ε10 are undone but their momentum is kept; a cube hangs "
      "at "
      "the top of its throw (grey: its flight). DM14: turned about its centre, a cube that lay on "
      "an edge floats. X3: pushes leave a gap of up to 1 mm; our repair leaves an overlap of up to "
      "as much. X6: without damping, pushes lift a stack of five again and again; not so if its "
      "boxes are found to be geometrically stable (5.4), and not at all if velocities are stopped "
      "from the ground up, which is what the pushes took the place of. With damping nothing is "
      "lifted either: it ends what the contact passes leave of each step's gravity.";
  damping.parameters
      .add_number("k1", tolerance::damped_momentum_factor, 0.0, 1.0, "-",
                  "what a step in contact leaves of momentum")
      .add_number("eps10", 5e-3, 1e-9, 1.0, "m", "a move in a step that is undone")
      .add_whole("cap", 100000, 100, 10000000, "pushes after which an endless loop is left")
      .add_number("duration", 10.0, 0.1, 600.0, "s", "of the stack's rest");
  damping.quick = {"cap=1000", "duration=1"};
  damping.experiment = measure_damping_errata;
  list.push_back(damping);

  Figure stability;
  stability.name = "errata_stability";
  stability.section = "5.4, A.2";
  stability.title = "Where the test of geometric stability fails, and the same mended";
  stability.caption =
      "Side views of what the listing calls stable (blue), left as printed and right mended. G2: "
      "of two "
      "cubes that touch only the upper one, here the second, loses its mark; both should. G3: an "
      "unstable support counts if it is listed last, not if first. G4: a fixed wall with a cube at "
      "its "
      "side loses the mark that immovable bodies have. G5: corners stay marked from the step "
      "before. "
      "G6: the text asks for four corners, its footnote for all supports. G7: a cube that is going "
      "up "
      "is called stable. G8: directions are compared exactly; a block leans by a millionth.";
  stability.experiment = measure_stability_errata;
  list.push_back(stability);
}

}  // namespace tumble::chapters
