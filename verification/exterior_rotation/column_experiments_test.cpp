/// \file
/// \brief The column that falls: its reference, orders, work, forces and errata.
#include "driver/quick.hpp"
#include "exterior_rotation/column_reference.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE("The falling column's angle has the tabulated values of its elliptic function",
          "[reference][exterior_rotation]") {
  CHECK(column_radius() == near(2.06155281281, 5e-12));
  CHECK(column_tilt() == near(0.244978663127, 5e-13));
  CHECK(column_frequency() == near(1.88915635203, 5e-12));
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
  for (const Row& row : rows) CHECK(column_angle(row.time, row.phi0) == near(row.angle, 5e-12));
  CHECK(column_rate(1.0, 0.3) == near(1.69642937582, 5e-12));
  CHECK(column_angle(0.0, 0.3) == near(0.3, 1e-15));
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
    CHECK(force.shear == near(row.shear, 5e-10));
    CHECK(force.normal == near(row.normal, 6e-9));
    CHECK(force.from_edge == near(row.from_edge, 5e-11));
  }
  CHECK_THROWS_AS(glue_force(4, 0.3, 0.3), std::invalid_argument);
}

TEST_CASE("The leading-order gaps are the three integrals that were evaluated elsewhere",
          "[reference][exterior_rotation]") {
  const GapConstants constants = gap_constants(1.0, 0.3);
  CHECK(constants.impulse == near(0.331748, 5e-7));
  CHECK(constants.semi_implicit == near(0.310392, 5e-7));
  CHECK(constants.forward_euler == near(0.663496, 5e-7));
}

TEST_CASE("The world of the column begins at the angle and the spin that were asked for",
          "[exact][exterior_rotation]") {
  for (const int count : {2, 4, 7}) {
    const World world = column_world(0.25, 1.5, count);
    CHECK(centre_angle(world) == near(0.25, 1e-14));
    CHECK(column_gap(world) == near(0.0, 1e-14));
    const int first = world.index_of(*world.find("box1"));
    const BodyState& state = world.states()[idx(first)];
    // The lowest cube turns about its edge, half a diagonal from its centre.
    CHECK((state.position_w - column_pivot()).norm() == near(std::sqrt(0.5), 1e-14));
    CHECK(state.linear_momentum_w.norm() == near(1.5 * std::sqrt(0.5), 1e-14));
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
  CHECK(std::abs(column_gap(world)) == near(1e-3, 1e-14));
  const auto box4 = static_cast<std::size_t>(world.index_of(*world.find("box4")));
  world.states()[box4].position_w += 2e-3 * axis_w;  // 1 mm above the third, 2 mm too high
  state.position_w -= 2e-3 * axis_w;                 // now 1 mm below its place
  CHECK(column_gap(world) == near(3e-3, 1e-14));
  world.states()[box4].position_w -= 6e-3 * axis_w;
  CHECK(column_gap(world) == near(-3e-3, 1e-14));
}

TEST_CASE("At 60 steps a second the glued column is off by what was tabulated for each scheme",
          "[reference][exterior_rotation]") {
  // Found by an independent program; five digits were written down, and it took the exact angle with
  // twelve decimals.
  struct Row {
    std::string_view scheme;
    double angle, angle_margin, gap, gap_margin;
  };
  constexpr std::array<Row, 7> rows{{{"forward_euler", -2.8388e-2, 5e-7, 1.0170e-2, 6e-7},
                                     {"semi_implicit", 1.1521e-2, 6e-7, 5.337e-3, 5e-7},
                                     {"impulse", 1.1431e-2, 6e-7, 5.681e-3, 5e-7},
                                     {"midpoint", -2.7004e-4, 6e-9, 2.840e-4, 6e-8},
                                     {"rk4", -7.9098e-9, 6e-13, 4.351e-9, 1e-12},
                                     {"impulse_exp", 1.2980e-2, 6e-7, 0.0, 1e-14},
                                     {"leapfrog_exp", -6.6931e-5, 6e-9, 0.0, 1e-14}}};
  for (const Row& row : rows) {
    CAPTURE(row.scheme);
    const ColumnRun run = run_column(column_scheme(row.scheme), 60);
    CHECK(run.angle_error == near(row.angle, row.angle_margin));
    CHECK(run.gap == near(row.gap, row.gap_margin));
  }
  const ColumnRun coarse = run_column(column_scheme("rk4"), 10);
  CHECK(coarse.angle_error == near(-8.06e-6, 6e-9));
  CHECK(coarse.gap == near(6.3e-6, 5e-8));
}

TEST_CASE("Each scheme solves for joint forces as often as it has stages, and no more",
          "[exact][exterior_rotation]") {
  for (const auto schemes : {separate_schemes(), exponential_schemes()})
    for (const ColumnScheme& scheme : schemes) {
      CAPTURE(scheme.words);
      CHECK(run_column(scheme, 12).solves == 12 * scheme.stages);
    }
}

TEST_CASE(
    "Adaptive steps of Dormand and Prince beat fixed ones of Runge and Kutta for as much work",
    "[reference][exterior_rotation]") {
  const ColumnRun fixed = run_column(column_scheme("rk4"), 80);
  const ColumnRun adaptive = run_column_accurately(1e-9);
  CHECK(adaptive.solves <= fixed.solves);
  // [-] measured 12
  CHECK(5.0 * std::abs(adaptive.angle_error) < std::abs(fixed.angle_error));
  // A stricter accuracy costs more and gains: errors fall by 10 per digit, work by 10^(1/5).
  const ColumnRun strict = run_column_accurately(1e-11);
  CHECK(std::abs(strict.angle_error) < 0.05 * std::abs(adaptive.angle_error));
  CHECK(strict.solves < 3 * adaptive.solves);
}

TEST_CASE("Semi-implicit Euler needs fifty times the usual steps to hide the column's gap",
          "[claims][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2e_steps", {"gap=1e-4"});
  const double ratio = figure.number(
      "steps a second that keep the gap of figure 6.1's column below a tenth of a "
      "millimetre in a second of its fall, semi-implicit Euler, over 60");
  // The leading-order integral says 0.310392 / 1e-4 / 60 = 51.73; the next order adds 0.07 %.
  CHECK(ratio == near(0.310392 / 1e-4 / 60.0, 0.1));
  CHECK(figure.number("the same if every glued point counts, in every direction") > ratio);
  CHECK(figure.number("steps a second that keep the gap small, Runge-Kutta 4") < 60.0);
  CHECK(figure.number("most steps a second that any exponential scheme needs") == 1.0);
}

TEST_CASE("The number of steps that keeps a gap small is the first whole one that does",
          "[exact][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2e_steps", {"gap=2e-3"});
  const Table& table = figure.result.tables.front();
  const auto schemes = separate_schemes();
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    CAPTURE(schemes[k].words);
    const int steps = static_cast<int>(table.rows[k][1]);
    CHECK(run_column(schemes[k], steps).largest_gap < 2e-3);
    CHECK(run_column(schemes[k], steps + 1).largest_gap < 2e-3);
    if (steps > 1) CHECK(run_column(schemes[k], steps - 1).largest_gap >= 2e-3);
    CHECK(table.rows[k][2] == static_cast<double>(steps * schemes[k].stages));
  }
}

TEST_CASE("Glue forces at release are those of the closed form, centre of pressure included",
          "[reference][exterior_rotation]") {
  World world = column_world(0.3);
  Glued glued;
  glued.step(world, 1e-9);  // nothing has moved by more than rounding
  struct Row {
    double shear, normal, from_edge;
  };
  constexpr std::array<Row, 3> rows{{{7.346365955, 26.74874999, 0.1866083421},
                                     {3.842891773, 17.8325, 0.3337873452},
                                     {1.394103122, 8.91625, 0.4415370095}}};
  REQUIRE(glued.contacts().size() == 4);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ContactRecord& contact = glued.contacts()[k + 1];
    const auto lower = static_cast<std::size_t>(world.index_of(contact.first));
    const BodyState& state = world.states()[lower];
    const Vec3 across_w = state.orientation_wb * Vec3::UnitX();
    const Vec3 along_w = state.orientation_wb * Vec3::UnitY();
    CHECK(-contact.push_w.dot(across_w) == near(rows[k].shear, 1e-8));
    CHECK(contact.push_w.dot(along_w) == near(rows[k].normal, 1e-8));
    CHECK(0.5 - (contact.point_w - state.position_w).dot(across_w) ==
          near(rows[k].from_edge, 1e-9));
  }
}
