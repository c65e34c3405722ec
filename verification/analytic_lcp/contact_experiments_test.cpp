/// \file
/// \brief Joined collisions, Painlevé's rod and time stepping, run small.
#include "analytic_lcp/painleve_rod.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

TEST_CASE("A box bounces, sticks, rests, slides and topples in one run of the joined simulator",
          "[claims][analytic_lcp]") {
  // Also with a step of another length: what is measured is physics, not the step.
  for (const std::string& step :
       std::vector<std::string>{"step=0.016666666666666666", "step=0.01"}) {
    const FigureUnderTest figure("claim_3_3_1d_joined", {step});
    CHECK(figure.number("of five phases (bounce, sticky collision, rest, slide, topple), those "
                        "that the joined simulator passes") == 5.0);
    // Five resolutions of 1 ns for each of six impacts; measured 4.5e-9 s.
    CHECK(figure.number("bounce: largest error of six impact times") < 3e-8);
    CHECK(figure.number("sticky collision: impacts until the cube rests") == 7.0);
    // [J] rounding of 40 J; measured 2.5e-14.
    CHECK(figure.number("largest gain of energy in a step that is not booked") < 1e-10);
  }
}

TEST_CASE("Painlevé's rod has one force below a friction of 4/3, and none or two above the curve",
          "[exact][analytic_lcp]") {
  const auto critical = [](double degrees) { return critical_friction(degrees * kDegree); };
  // Twelve digits were written down.
  CHECK(critical(30.0) == Approx(2.50185116649).epsilon(1e-11));
  CHECK(critical(45.0) == Approx(1.66666666667).epsilon(1e-11));
  CHECK(critical(60.0) == Approx(1.34715062811).epsilon(1e-11));
  CHECK(critical(75.0) == Approx(1.60128252576).epsilon(1e-11));
  CHECK(critical(63.4349488229) == Approx(4.0 / 3.0).epsilon(1e-11));

  const double angle = 60.0 * kDegree;
  CHECK(push_response({angle, 1.0, 0.0}) == Approx(0.450961894323).epsilon(1e-11));
  REQUIRE(possible_forces({angle, 1.0, 0.0}).size() == 1);
  CHECK(possible_forces({angle, 1.0, 0.0})[0] == Approx(21.7535009576).epsilon(1e-11));

  CHECK(push_response({angle, 1.5, 0.0}) == Approx(-0.198557158515).epsilon(1e-11));
  CHECK(free_acceleration({angle, 1.5, 0.0}) == -9.81);
  CHECK(possible_forces({angle, 1.5, 0.0}).empty());

  CHECK(free_acceleration({angle, 1.5, 5.0}) == Approx(11.8406350946).epsilon(1e-11));
  const std::vector<double> two = possible_forces({angle, 1.5, 5.0});
  REQUIRE(two.size() == 2);
  CHECK(two[0] == 0.0);
  CHECK(two[1] == Approx(59.633383068).epsilon(1e-11));
  CHECK(std::abs(free_acceleration({angle, 1.5, 3.36565183605})) < 1e-10);  // [m/s²] measured 5e-12
}

TEST_CASE("A time step of Painlevé's rod has an answer where no force exists",
          "[exact][analytic_lcp]") {
  const double angle = 60.0 * kDegree;
  for (const int directions : {4, 8}) {
    // Nine digits were written down. The thickness of the rod changes its moment of inertia by 2.5e-11.
    const RodStep jams = step_rod({angle, 1.5, 0.0}, 1.0 / 60.0, directions);
    REQUIRE(jams.solved);
    CHECK(jams.normal_impulse == Approx(0.457603276).epsilon(2e-9));
    CHECK(jams.friction_impulse == Approx(0.490598183).epsilon(2e-9));
    CHECK(std::abs(jams.slip) < 1e-12);
    CHECK(std::abs(jams.lift) < 1e-12);
    CHECK(jams.spin == Approx(0.588206553).epsilon(2e-9));

    const RodStep slides = step_rod({angle, 1.0, 0.0}, 1.0 / 60.0, directions);
    CHECK(slides.normal_impulse == Approx(0.362558349).epsilon(2e-9));
    CHECK(slides.friction_impulse == Approx(0.362558349).epsilon(2e-9));
    CHECK(slides.slip == Approx(-0.292662476).epsilon(2e-9));

    // However short the step, the impulse stays: 3 sin cos / 4 and 7/16, and a force of some N times the step.
    const RodStep limit = step_rod({angle, 1.5, 0.0}, 1e-6, directions);
    CHECK(limit.normal_impulse == Approx(3.0 * std::sqrt(3.0) / 16.0).epsilon(1e-4));
    CHECK(limit.friction_impulse == Approx(0.4375).epsilon(1e-4));
  }
}

TEST_CASE("The map of Painlevé's rod has its edge on the closed form, and every step is solved",
          "[claims][analytic_lcp]") {
  const FigureUnderTest figure("painleve_map");
  // Half a cell of 3/30: measured 0.049.
  CHECK(figure.number("largest distance of the map's edge from the closed form") < 0.05);
  CHECK(figure.result.tables.front().rows.size() == 224);
  // Rods that a step leaves sliding are all below the curve.
  Failures wrong;
  for (const std::vector<double>& row : figure.result.tables.front().rows) {
    if (row[2] == 1.0 && row[1] > critical_friction(row[0] * kDegree)) ++wrong["beyond"];
    if (row[2] == 0.0) ++wrong["lifted"];  // a step from contact knows no centrifugal force
  }
  CHECK(wrong == Failures{});
}

TEST_CASE(
    "Every rod of Painlevé is solved, and random contacts with friction but for one in a thousand",
    "[claims][analytic_lcp]") {
  const FigureUnderTest figure("claim_2_6_3b_always_solved");
  // Each answer is in a class of errors.
  double points = 0.0;
  double rods = 0.0;
  for (const std::vector<double>& row : figure.result.tables.front().rows) {
    points += row[1];
    rods += row[3];
  }
  CHECK(std::abs(points - 100.0) < 1e-9);
  CHECK(std::abs(rods - 100.0) < 1e-9);
  // Seeds on which nothing was tuned leave 1 or 2 of 3000 problems of bricks.
  CHECK(figure.number("problems that were not solved over all problems") < 0.001);
}
