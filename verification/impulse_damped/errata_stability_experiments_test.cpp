/// \file
/// \brief Errata G2 to G8 of the listing SETGEOMETRICALLYSTABLE.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

namespace {

double number(std::string_view quantity) {
  return FigureUnderTest("errata_stability").number(quantity);
}

}  // namespace

TEST_CASE("Of cubes that stand side by side the listing clears one",
          "[exact][geometric_stability]") {
  CHECK(number("G2: cubes side by side called stable, upper one cleared") == 1.0);
  CHECK(number("G2: cubes side by side called stable, both cleared") == 0.0);
}

TEST_CASE("The place of a contact in the list decides whether it counts, unless vetoes do",
          "[exact][geometric_stability]") {
  const std::string plank = "G3: plank with an unstable support called stable, ";
  CHECK(number(plank + "its contact is listed first") == 1.0);
  CHECK(number(plank + "its contact is listed last") == 0.0);
  CHECK(number(plank + "vetoes count, its contact is listed first") == 0.0);
  CHECK(number(plank + "vetoes count, its contact is listed last") == 0.0);
}

TEST_CASE("A fixed wall with a cube at its side carries nothing stable as printed",
          "[exact][geometric_stability]") {
  CHECK(number("G4: cube on a fixed wall called stable, the wall can lose its flag") == 0.0);
  CHECK(number("G4: cube on a fixed wall called stable, the wall cannot") == 1.0);
}

TEST_CASE("Corners that were marked in the step before hold up a cube that has slid off",
          "[exact][geometric_stability]") {
  CHECK(number("G5: cube half off its support called stable, marks of the step before") == 1.0);
  CHECK(number("G5: cube half off its support called stable, marks of this step") == 0.0);
}

TEST_CASE("The text and its footnote disagree about an unstable support between stable ones",
          "[exact][geometric_stability]") {
  const std::string plank = "G6: plank with an unstable support called stable, ";
  CHECK(number(plank + "four corners held, as the text asks") == 1.0);
  CHECK(number(plank + "all supports stable, as the footnote asks") == 0.0);
}

TEST_CASE("A cube that goes up is called stable as printed", "[exact][geometric_stability]") {
  CHECK(number("G7: cube that rises at 1 m/s called stable, speed not looked at") == 1.0);
  CHECK(number("G7: cube that rises at 1 m/s called stable, speed looked at") == 0.0);
}

TEST_CASE("Without tolerances a millionth of a tilt ends all stability",
          "[exact][geometric_stability]") {
  const std::string cube = "G8: cube on a block that leans by 1e-6 rad called stable, ";
  CHECK(number(cube + "no tolerance") == 0.0);
  CHECK(number(cube + "with tolerances") == 1.0);
}
