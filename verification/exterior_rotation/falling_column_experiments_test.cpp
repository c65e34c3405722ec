/// \file
/// \brief The closed forms of the falling column against tabulated numbers.
#include "exterior_rotation/column_reference.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("The falling column's angle has the tabulated values of its elliptic function",
          "[reference][exterior_rotation]") {
  CHECK(column_radius() == near(2.06155281281).margin(5e-12));
  CHECK(column_tilt() == near(0.244978663127).margin(5e-13));
  CHECK(column_frequency() == near(1.88915635203).margin(5e-12));
  // Evaluated apart from this code; 12 digits were written down.
  struct Row {
    double phi0, time, angle;
  };
  constexpr std::array<Row, 8> rows{{{0.1, 0.25, 0.111341682593},
                                     {0.1, 0.5, 0.147927530540},
                                     {0.1, 1.0, 0.337137488410},
                                     {0.1, 1.5, 0.839507332025},
                                     {0.3, 0.25, 0.333547131928},
                                     {0.3, 0.5, 0.441380063385},
                                     {0.3, 1.0, 0.985855331068},
                                     {0.3, 1.5, 2.25110854938}}};
  for (const Row& row : rows)
    CHECK(column_angle(row.time, row.phi0) == near(row.angle).margin(5e-12));
  CHECK(column_rate(1.0, 0.3) == near(1.69642937582).margin(5e-12));
  CHECK(column_angle(0.0, 0.3) == near(0.3).margin(1e-15));
  CHECK_THROWS_AS(column_angle(1.0, 0.0), std::invalid_argument);
}

TEST_CASE("The closed form of the glue forces has the tabulated values at release",
          "[reference][exterior_rotation]") {
  struct Row {
    int joint;
    double shear, normal, from_edge;
  };
  constexpr std::array<Row, 3> rows{{{1, 7.346365955, 26.74874999, 0.1866083421},
                                     {2, 3.842891773, 17.8325, 0.3337873452},
                                     {3, 1.394103122, 8.91625, 0.4415370095}}};
  for (const Row& row : rows) {
    const GlueForce force = glue_force(row.joint, 0.3, 0.3);
    CHECK(force.shear == near(row.shear).margin(5e-10));
    CHECK(force.normal == near(row.normal).margin(6e-9));
    CHECK(force.from_edge == near(row.from_edge).margin(5e-11));
  }
  CHECK_THROWS_AS(glue_force(4, 0.3, 0.3), std::invalid_argument);
}

TEST_CASE("The leading-order gaps are the three integrals that were evaluated elsewhere",
          "[reference][exterior_rotation]") {
  const GapConstants constants = gap_constants(1.0, 0.3);
  CHECK(constants.impulse == near(0.331748).margin(5e-7));
  CHECK(constants.semi_implicit == near(0.310392).margin(5e-7));
  CHECK(constants.forward_euler == near(0.663496).margin(5e-7));
}

TEST_CASE("The world of the column begins at the angle and the spin that were asked for",
          "[exact][exterior_rotation]") {
  for (const int count : {2, 4, 7}) {
    const World world = column_world(0.25, 1.5, count);
    CHECK(centre_angle(world) == near(0.25).margin(1e-14));
    CHECK(column_gap(world) == near(0.0).margin(1e-14));
    const int first = world.index_of(*world.find("box1"));
    const BodyState& state = world.states()[static_cast<std::size_t>(first)];
    // The lowest cube turns about its edge, half a diagonal from its centre.
    CHECK((state.position_w - column_pivot()).norm() == near(std::sqrt(0.5)).margin(1e-14));
    CHECK(state.linear_momentum_w.norm() == near(1.5 * std::sqrt(0.5)).margin(1e-14));
  }
}

TEST_CASE("The gap of a column is what its cubes were moved along its axis, sign included",
          "[exact][exterior_rotation]") {
  World world = column_world(0.25);
  const auto box3 = static_cast<std::size_t>(world.index_of(*world.find("box3")));
  BodyState& state = world.states()[box3];
  const Vec3 axis_w = state.orientation_wb * Vec3::UnitY();
  const Vec3 across_w = state.orientation_wb * Vec3::UnitX();
  state.position_w += 1e-3 * axis_w + 1e-2 * across_w;
  CHECK(std::abs(column_gap(world)) == near(1e-3).margin(1e-14));
  const auto box4 = static_cast<std::size_t>(world.index_of(*world.find("box4")));
  world.states()[box4].position_w += 2e-3 * axis_w;  // 1 mm above the third, 2 mm too high
  state.position_w -= 2e-3 * axis_w;                 // now 1 mm below its place
  CHECK(column_gap(world) == near(3e-3).margin(1e-14));
  world.states()[box4].position_w -= 6e-3 * axis_w;
  CHECK(column_gap(world) == near(-3e-3).margin(1e-14));
}
