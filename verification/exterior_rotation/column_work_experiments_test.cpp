/// \file
/// \brief Cost of the glued column's accuracy, and the steps that hide its gap (claim 6.2e).
#include "driver/quick.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

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
  CHECK(ratio == near(0.310392 / 1e-4 / 60.0).margin(0.1));
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
