/// \file
/// \brief The closed forms of the falling column against tabulated numbers and integrations by GSL.
#include "exterior_rotation/column_reference.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

namespace {

constexpr double kWeight = 4.0 * 9.81;  // [N] of four cubes

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

}  // namespace

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
  for (const Row& row : rows) {
    CHECK(column_angle(row.time, row.phi0) == near(row.angle).margin(5e-12));
    CHECK(column_time(row.angle, row.phi0) == near(row.time).margin(1e-10));
  }
  CHECK(column_rate(1.0, 0.3) == near(1.69642937582).margin(5e-12));
  CHECK(column_rate_at(column_angle(1.0, 0.3), 0.3) == near(column_rate(1.0, 0.3)).margin(1e-13));
  CHECK(column_angle(0.0, 0.3) == near(0.3).margin(1e-15));
  CHECK_THROWS_AS(column_angle(1.0, 0.0), std::invalid_argument);
}

TEST_CASE("A pendulum and four glued cubes integrated by GSL fall as the elliptic function says",
          "[reference][exterior_rotation]") {
  for (const double time : {0.5, 1.0, 1.5}) {
    for (const ReferenceFall& fall :
         {integrated_pendulum(time, 0.3), integrated_column(time, 0.3)}) {
      CHECK(fall.angle == near(column_angle(time, 0.3)).margin(1e-13));
      CHECK(fall.rate == near(column_rate(time, 0.3)).margin(1e-13));
      CHECK(fall.gap < 1e-13);
    }
  }
  // One and two cubes are columns as well.
  for (const int count : {1, 2})
    CHECK(integrated_column(0.7, 0.2, count).angle ==
          near(column_angle(0.7, 0.2, count)).margin(1e-13));
}

TEST_CASE("The closed form of the pivot force has the tabulated values at rest and its known limit",
          "[reference][exterior_rotation]") {
  const PivotForce rest = pivot_force(0.3, 0.3);
  CHECK(rest.normal / kWeight == near(0.9345008556).margin(5e-11));
  CHECK(rest.tangential / kWeight == near(0.2117409275).margin(5e-11));
  CHECK(rest.tangential / rest.normal == near(0.2265818445).margin(5e-11));
  // From almost upright: a quarter of the weight times (1 - 3 cos)².
  for (const double angle : {0.5, 1.0, 1.2, 1.5}) {
    const double cube = 1.0 - 3.0 * std::cos(angle);
    CHECK(pivot_force(angle, 1e-7).normal == near(0.25 * kWeight * cube * cube).margin(1e-11));
  }
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

TEST_CASE("Joints without glue would open from the top down, at the tabulated angles",
          "[reference][exterior_rotation]") {
  constexpr std::array<double, 3> from_01{0.681721773, 0.7159189796, 0.7908252864};
  constexpr std::array<double, 3> from_03{0.719834032, 0.7501606332, 0.8223493187};
  for (std::size_t k = 0; k < 3; ++k) {
    const int joint = 3 - static_cast<int>(k);
    CHECK(opening_angle(joint, 0.1) == near(from_01[k]).margin(6e-10));
    CHECK(opening_angle(joint, 0.3) == near(from_03[k]).margin(6e-10));
  }
  // The first number is the angle of the centre of mass; the column leans more than that.
  CHECK(degrees(opening_angle(3, 0.1)) == near(39.05978).margin(5e-6));
  CHECK(degrees(opening_angle(3, 0.1) + column_tilt()) == near(53.10).margin(5e-3));
  CHECK(column_time(opening_angle(3, 0.1), 0.1) == near(1.386047114).margin(1e-9));
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
