/// \file
/// \brief The errata P15 and P15b against closed forms.

#include "driver/quick.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("One force and one torque open a column along tangents and not along its twist",
          "[exact][exterior_rotation]") {
  const FigureUnderTest figure("errata_exterior_rotation");
  // Neighbours 1 m apart on arms that turn by a: their distance along the axis that has turned, too.
  const double a = 2.0 / 60.0;
  CHECK(figure.number(
            "P15: gap after a step with one force and torque, centres moved along tangents") ==
        near(std::cos(a) + a * std::sin(a) - 1.0).margin(1e-14));  // [m] rounding of coordinates
  CHECK(figure.number("the same, centres moved along parabolas") ==
        near((1.0 - 0.5 * a * a) * std::cos(a) + a * std::sin(a) - 1.0).margin(1e-13));
  CHECK(figure.number(
            "P15: gap after a step with one force and torque, bodies moved by their twist") <
        1e-14);  // [m] measured 4e-16
  const Table& gaps = figure.result.tables.front();
  REQUIRE(gaps.rows.size() == 5);
  for (const std::vector<double>& row : gaps.rows) {
    const double turn = row[0];
    CHECK(row[1] == near(std::cos(turn) + turn * std::sin(turn) - 1.0).margin(1e-13));
    CHECK(row[3] < 1e-14);
  }
}

TEST_CASE("Boxes that stay connected have to pull, and boxes that can come apart never do",
          "[exact][exterior_rotation]") {
  const FigureUnderTest figure("errata_exterior_rotation");
  // The glue's centre of pressure is off the area, 1 m wide, by some way: the other side pulls with the
  // normal force times that way over the width.
  const double angle = column_angle(1.0, 0.3);
  double pull = 0.0;
  for (int joint = 1; joint <= 3; ++joint) {
    const GlueForce glue = glue_force(joint, angle, 0.3);
    pull = std::max(pull, glue.normal * (glue.from_edge - 1.0));
  }
  CHECK(pull > 5.0);
  CHECK(figure.number(
            "P15b: largest pull in a joint while the column falls, boxes that stay connected") ==
        near(pull).margin(2e-6));  // [N] measured 8e-7: the angle is off by 8e-9 rad
  CHECK(figure.number(
            "P15b: largest pull in a joint while the column falls, boxes that can come apart") <
        1e-9);  // [N] measured 0; a joint opens as soon as its pressure leaves the area
  CHECK(figure.number("joints that hold an area at the end, boxes that can come apart") < 3.0);
}
