/// \file
/// \brief The claims of 4.4 on the pass that ends overlap by moving bodies.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE(
    "Pushes out of overlap add no kinetic energy, but bodies fall into the gaps that they leave",
    "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_4_4a_push_energy");
  CHECK(figure.number("kinetic energy just after the pass") == 0.0);
  CHECK(figure.number("potential energy that the pass adds to a stack, mean") > 0.1);  // [J]
  const double share = figure.number(
      "kinetic energy that appears within a second because of the pass, over the potential energy "
      "that it adds");
  // [-] measured 0.055 over 20 stacks, three here
  CHECK(share > 0.02);
  CHECK(share < 0.15);
  CHECK(figure.number("the same with our repair, which leaves no gap") == 0.0);
  // Stopping velocities adds none at all, and moves no body.
  CHECK(figure.number("kinetic energy if velocities are stopped in place of the pass") == 0.0);

  // Gaps are up to a millimetre however deep the overlap: the share goes down with depth.
  const std::vector<std::vector<double>>& depths = figure.result.tables[1].rows;
  CHECK(depths.front()[1] > 0.1);
  CHECK(depths.back()[1] < 0.01);
}

TEST_CASE("Impulses leave little overlap for the pushes", "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_4_4b_overlap_left");
  // [-] measured 0.025 over ten heaps, two here
  CHECK(figure.number("overlap that the pass removes, over all overlap that would be there without "
                      "any response") < 0.1);
  CHECK(figure.number("the same without damping") < 0.1);
  // The measurement itself: a pass taken out of the step does the same, to the last bit.
  CHECK(
      figure.number("how far cubes are in a second from those of the method with its pass inside, "
                    "without damping") == 0.0);
  // A stack keeps its place by what is stable; without that, pushes do a seventh of the work.
  CHECK(figure.number("the same for a stack of five at rest") == 0.0);
  CHECK(figure.number("the same for that stack without damping") > 0.1);  // measured 0.147
}
