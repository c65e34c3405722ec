/// \file
/// \brief The experiments about fracture, small.
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE("Cracks need several times the steps, and stability those of the Courant limit",
          "[claims][fracture]") {
  const FigureUnderTest figure("claim_2_4_1a_fracture_steps");
  CHECK(figure.number("longest stable step over the Courant step, at least") > 0.85);
  CHECK(figure.number("longest stable step over the Courant step, at most") < 1.0);
  CHECK(figure.number("longest stable step found by runs, beside two over the highest frequency") <
        0.03);
  CHECK(figure.number("how many times more steps cracks need, at most") > 1.2);
  CHECK(figure.number("steps per second that stability needs, geometric mean over six runs") >
        figure.number("the same before the first crack"));
}

TEST_CASE("A plank of elements and one of glued boxes break where a beam does",
          "[claims][fracture]") {
  const FigureUnderTest figure("fracture_breaking");
  CHECK(figure.number("load that breaks elements, 2 through the thickness, over the beam's") <
        0.6 * figure.number("load that breaks elements, 1 through the thickness, over the beam's"));
  CHECK(figure.number("place where the finest break, from the middle over the length") < 0.03);
  CHECK(figure.number("load that breaks glued boxes by their stress, over the beam's") ==
        near(1.0, 0.02));
  CHECK(figure.number("load that breaks glued boxes by their force, over the beam's") ==
        near(60.0, 1.0));  // 3 L / h
  CHECK(figure.number("the same at 960 over that at 60") ==
        near(1.0 / 16.0, 0.006));  // in proportion to the step
}

TEST_CASE("Films of a plank and a wall that break keep the mass and are pictures",
          "[claims][fracture]") {
  for (const char* name : {"fracture_plank", "fracture_wall"}) {
    const FigureUnderTest figure(name);
    CHECK(std::abs(figure.number("change of the mass")) < 1e-12);
    CHECK(figure.number("nodes that cracked") > 0.0);
    CHECK(figure.number("substeps") > 100.0);
    CHECK(figure.number("pieces of more than a hundredth of the mass") >= 1.0);
    CHECK(figure.number("share of the mass of the largest piece") <= 1.0);
    CHECK(figure.result.drawings.size() == 4);
    CHECK(figure.result.film().substr(0, 6) == "GIF89a");
  }
}
