/// \file
/// \brief Orders of the glued column's integration and what one step does (claim 6.2b).
#include "driver/quick.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

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
    CHECK(run.angle_error == near(row.angle).margin(row.angle_margin));
    CHECK(run.gap == near(row.gap).margin(row.gap_margin));
  }
  const ColumnRun coarse = run_column(column_scheme("rk4"), 10);
  CHECK(coarse.angle_error == near(-8.06e-6).margin(6e-9));
  CHECK(coarse.gap == near(6.3e-6).margin(5e-8));
}

TEST_CASE("Runge and Kutta's method follows the glued column with a gap of its own order, four",
          "[claims][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2b_order");
  CHECK(figure.number("order of the gap in figure 6.1's column against the step, for the classical "
                      "method of Runge and Kutta with forces solved at each stage, joints held") ==
        near(4.0).margin(0.1));
  // [-] measured 5.66: the gap of the method of order 5 is not yet in its last regime
  CHECK(figure.number("order of the gap, Dormand-Prince 5") > 4.5);
}

TEST_CASE("Gap over step tends to the leading-order integrals of the first-order schemes",
          "[reference][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2b_order", {"doublings=7"});
  for (const std::string_view scheme : {"forward Euler", "semi-implicit Euler", "impulses"}) {
    CAPTURE(scheme);
    // [-] asked for is 1e-2; measured 7e-5 with steps down to 1/640 s
    CHECK(
        figure.number(std::string("limit of gap over step, over its integral, ").append(scheme)) ==
        near(1.0).margin(1e-3));
  }
}
