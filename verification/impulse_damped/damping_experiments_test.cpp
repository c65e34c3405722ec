/// \file
/// \brief Claims 5.3a, 5.3b and 5.3e: energy, chatter and the alignment test of the damping.
#include "tumble/impulse_damped/tolerances.hpp"

#include "driver/quick.hpp"
#include "impulse_damped/settled_boxes.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("The closed form of a shrunk component agrees with the worst of random states",
          "[claims][impulse_damped]") {
  const FigureUnderTest energy("claim_5_3a_energy");
  const double found = energy.number("largest factor, slow components, brick of 4 x 1 x 1");
  const double shrunk = energy.number("the same in closed form, one component shrunk");
  const double ended = energy.number("the same in closed form, one component ended");
  CHECK(std::abs(ended - 361.0 / 136.0) < 1e-12);  // moments 2 and 17
  // [-] eigenvalues of A⁻¹ D A D for A = (17 + 2, 17 - 2), D = diag(1, 1/2)
  CHECK(std::abs(shrunk - 1.496552316) < 1e-9);
  CHECK(found < ended);
  CHECK(found > 0.75 * shrunk);  // 4000 states are few; measured above 0.8 of it
}

TEST_CASE("Pushes add up to a push more than the end of an overlap takes",
          "[claims][impulse_damped]") {
  const FigureUnderTest energy("claim_5_3a_energy");
  const double extra =
      energy.number("potential energy that pushes add beyond the end of the overlap, over m g L");
  CHECK(extra <= tolerance::damped_push);
  CHECK(extra > 0.95 * tolerance::damped_push);
  const std::string share = "energy that pushes add over what damping takes, heap of 27 ";
  CHECK(energy.number(share + "cubes") > 0.02);  // measured 0.10 over three seconds
  CHECK(energy.number("steps in which damping adds energy, over all, heap of 27 cubes") == 0.0);
}

TEST_CASE("Planks that are propped up stay where they are with all of the damping",
          "[reference][impulse_damped]") {
  const World world = propped_planks(1);
  for (const BoxEnd& end : settle(world, DampedOptions{}, 1.5)) {
    CHECK(end.rests);
    CHECK(end.on_face == end.aligned);
  }
}
