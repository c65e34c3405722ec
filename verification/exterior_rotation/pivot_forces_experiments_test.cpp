/// \file
/// \brief Forces in the joints of the falling column, and boxes that swing on an edge.
#include "driver/quick.hpp"
#include "exterior_rotation/box_pendulum.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

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
    CHECK(-contact.push_w.dot(across_w) == near(rows[k].shear).margin(1e-8));
    CHECK(contact.push_w.dot(along_w) == near(rows[k].normal).margin(1e-8));
    CHECK(0.5 - (contact.point_w - state.position_w).dot(across_w) ==
          near(rows[k].from_edge).margin(1e-9));
  }
}

TEST_CASE("The glue's centre of pressure leaves the area at the angle of the closed form",
          "[reference][exterior_rotation]") {
  // Just before the top joint would open it is inside, just after it is outside.
  for (const double share : {-1e-6, 1e-6}) {
    const double angle = opening_angle(3, 0.3) + share;
    World world = column_world(angle, column_rate_at(angle, 0.3));
    Glued glued;
    glued.step(world, 1e-10);
    const ContactRecord& top = glued.contacts()[3];
    const auto lower = static_cast<std::size_t>(world.index_of(top.first));
    const BodyState& state = world.states()[lower];
    const double from_edge =
        0.5 - (top.point_w - state.position_w).dot(state.orientation_wb * Vec3::UnitX());
    CHECK((from_edge > 1.0) == (share > 0.0));
    CHECK(from_edge == near(1.0).margin(1e-4));
  }
}

TEST_CASE("The force at the pivot is that of the closed form over the whole fall",
          "[reference][exterior_rotation]") {
  const FigureUnderTest figure("pivot_forces", {"time=1.25"});
  CHECK(figure.number("normal force at rest, over weight") == near(0.9345008556).margin(1e-9));
  CHECK(figure.number("tangential force at rest, over weight") == near(0.2117409275).margin(1e-9));
  CHECK(figure.number("coefficient of friction that rest takes") ==
        near(0.2265818445).margin(1e-9));
  CHECK(figure.number("largest error of a force over weight, Dormand-Prince 5") < 1e-11);
  // [-] measured 5.3e-8: that of the angle, about 1e-8, times the slope of the force
  CHECK(figure.number("largest error of a force over weight, Runge-Kutta 4") < 2e-7);
  CHECK(figure.number("largest error of a force over weight, semi-implicit Euler") > 1e-3);
}

TEST_CASE(
    "A glued column presses least where the cosine is a third of that at the start, and no "
    "usual friction holds it there",
    "[reference][exterior_rotation]") {
  const FigureUnderTest figure("pivot_forces", {"time=1.25", "rate=960"});
  const double least = std::acos(std::cos(0.3) / 3.0) * 180.0 / std::numbers::pi;
  // [degrees] a step of 1/960 s is a seventh of a degree
  CHECK(figure.number("angle of the centre at the lowest normal force") == near(least).margin(0.1));
  // A quarter of the square of sin 0.3
  CHECK(figure.number("lowest normal force in the fall, over weight") ==
        near(0.25 * std::sin(0.3) * std::sin(0.3)).margin(1e-5));
  CHECK(figure.number("largest coefficient of friction that a moment of the fall takes") > 30.0);
}

TEST_CASE("A box that swings on an edge has the periods of the compound pendulum",
          "[reference][exterior_rotation]") {
  // By elliptic integrals elsewhere; 12 digits were written down.
  struct Row {
    double degrees, cube, tall;
  };
  constexpr std::array<Row, 5> rows{{{1.0, 1.94789481907, 2.44934806301},
                                     {30.0, 1.98176759500, 2.49194082381},
                                     {90.0, 2.29913556450, 2.89100991818},
                                     {135.0, 2.97622452683, 3.74240421428},
                                     {170.0, 4.75153153946, 5.97473459991}}};
  for (const Row& row : rows) {
    const double amplitude = row.degrees * std::numbers::pi / 180.0;
    CHECK(exact_swing_period(1.0, 1.0, amplitude) == near(row.cube).margin(6e-12));
    CHECK(exact_swing_period(1.0, 2.0, amplitude) == near(row.tall).margin(6e-12));
    const MeasuredSwing cube = measure_swing(1.0, 1.0, amplitude, 1e-14);
    const MeasuredSwing tall = measure_swing(1.0, 2.0, amplitude, 1e-14);
    CHECK(cube.period == near(row.cube).margin(1e-11));
    CHECK(tall.period == near(row.tall).margin(1e-11));
    CHECK(cube.apart < 1e-12);
    CHECK(tall.apart < 1e-12);
  }
  CHECK(exact_swing_period(1.0, 1.0, 0.0) == near(1.947857734).margin(6e-10));
  CHECK(exact_swing_period(1.0, 2.0, 0.0) == near(2.449301431).margin(6e-10));
}

TEST_CASE(
    "The energy of a box that swings under Runge and Kutta's method drifts with the fourth "
    "power of the step",
    "[reference][exterior_rotation]") {
  const auto drift = [](int steps_a_second) {
    HungBox box(1.0, 1.0, 0.5 * std::numbers::pi, {});
    const double before = box.energy();
    double largest = 0.0;
    for (int k = 0; k < 10 * steps_a_second; ++k) {
      box.glued.step(box.world, 1.0 / steps_a_second);
      largest = std::max(largest, std::abs(box.energy() - before));
    }
    return largest;
  };
  const double usual = drift(60);
  // [J] of a swing of 6.9 J; measured 2.5e-4 in ten seconds
  CHECK(usual < 1e-3);
  CHECK(usual > 1e-5);
  CHECK(std::log2(usual / drift(120)) == near(4.0).margin(0.1));
}
