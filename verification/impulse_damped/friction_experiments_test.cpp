/// \file
/// \brief The claims of 5.3 on friction: the faster body, chains of bodies, what a viewer sees.
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE(
    "Damping brakes the upper block of figure 5.2 about as friction does, and never moves the "
    "lower one",
    "[claims][impulse_damped]") {
  const FigureUnderTest figure("fig5_2_friction");
  // [N] μ m g = 4.905; the slide ends within a step of 1/60 s, which is 6 % of it.
  CHECK(figure.number("mean braking force on A until then, Coulomb") == near(4.905, 0.3));
  CHECK(figure.number("mean force on B until then, Coulomb") == near(4.905, 0.3));
  // [N] measured 5.3: a speed that falls by 8 % in each step.
  CHECK(figure.number("mean braking force on A until then, damped") == near(5.4, 0.3));
  CHECK(figure.number("mean force on B until then, damped") == 0.0);
  // [m/s] momentum is kept; measured 0.0044 apart.
  CHECK(figure.number("speed of A at the end, Coulomb") ==
        near(figure.number("common speed if momentum is kept"), 0.02));
  CHECK(figure.number("speed of A at the end, damped") == 0.0);
  CHECK(figure.number("momentum at the end over that at the start, damped") == 0.0);
}

TEST_CASE(
    "The upper block stops under damping where friction would let it go on with the lower one",
    "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_5_3c_friction");
  const std::string decides =
      "largest difference between the speeds of the upper block, damped and with Coulomb's "
      "friction, until it stops, over its speed at the start";
  // [-] the common speed, 1/3 of that at the start, against 0; whatever the constants are.
  CHECK(figure.number(decides) == near(1.0 / 3.0, 0.01));
  for (const char* variant : {"half the epsilons", "twice the epsilons", "half the damping"})
    CHECK(figure.number(std::string("the same, ") + variant) == near(1.0 / 3.0, 0.01));
  CHECK(figure.number("the same, twice the damping") > figure.number(decides));
  CHECK(figure.number("the same, half the friction") > figure.number(decides));
  CHECK(figure.number("the same, twice the friction") == near(1.0 / 3.0, 0.01));
  // [-] While there is friction it is closer: measured 0.16; 0.16 at the best too.
  const double sliding =
      figure.number("the same, only while it slides on the lower block with Coulomb's friction");
  CHECK(sliding > 0.1);
  CHECK(sliding < 0.2);
  CHECK(figure.number("least difference over all frictions, the lower block being held") > 0.1);
  CHECK(figure.number("speed given to the lower block, damped over Coulomb") == 0.0);
}

TEST_CASE("Damping gives nothing to boxes on a sled, and friction takes them along",
          "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_5_3f_chain");
  const std::string decides =
      "speed that friction gives to the upper box of a stack on a sled, damped, over that with "
      "Coulomb's friction";
  CHECK(figure.number(decides) == 0.0);
  for (const char* variant : {"half the epsilons", "twice the epsilons", "half the damping",
                              "twice the damping", "half the friction", "twice the friction"})
    CHECK(figure.number(std::string("the same, ") + variant) == 0.0);
  CHECK(figure.number("the same of the lower box") == 0.0);
  // [m/s] momentum is kept: 4 kg at 1 m/s become 6 kg.
  CHECK(figure.number("speed of the upper box at the end, Coulomb") == near(2.0 / 3.0, 0.02));
  CHECK(figure.number("speed of the sled at the end, damped") == 0.0);
}

TEST_CASE(
    "Boxes that are shot at go less far under damping than with friction, more so the more it "
    "damps",
    "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_5_3g_seen");
  const double friction = figure.number("median travel, shot, Coulomb");
  CHECK(figure.number("median travel, shot, damped") < friction);
  // [-] measured over 24 seeds 0.45, with half the damping 0.08, with twice 0.71; here four seeds
  const double half = figure.number("the same, half the damping");
  const double twice = figure.number("the same, twice the damping");
  CHECK(half < twice);
  CHECK(twice > 0.4);
  CHECK(twice < 1.0);
}
