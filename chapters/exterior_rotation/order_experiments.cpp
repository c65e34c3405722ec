/// \file
/// \brief Orders of the glued column's integration (claim 6.2b).
#include "exterior_rotation/column_reference.hpp"
#include "exterior_rotation/column_runs.hpp"

namespace tumble::chapters {
namespace {

constexpr int kFirstSteps = 5;  // in the whole fall: the coarsest
constexpr int kFitted = 4;      // steps that an order is fitted to

// Errors of a scheme with one length of step.
struct Error {
  double step = 0.0;   // [s]
  double angle = 0.0;  // [rad] magnitude
  double gap = 0.0;    // [m] magnitude
};

struct Orders {
  double angle = 0.0;
  double gap = 0.0;
};

// Slopes of straight lines, by least squares in logarithms, through the four shortest steps at which both
// errors are above `floor`: twenty times what rounding leaves.
Orders orders_of(const std::vector<Error>& errors, double floor) {
  std::vector<double> step;
  std::vector<double> angle;
  std::vector<double> gap;
  for (auto error = errors.rbegin(); error != errors.rend() && step.size() < kFitted; ++error) {
    if (error->angle < floor || error->gap < floor) continue;
    step.push_back(error->step);
    angle.push_back(error->angle);
    gap.push_back(error->gap);
  }
  if (step.size() < 2) throw std::runtime_error("no two errors are above the floor");
  return {fitted_order(step, angle), fitted_order(step, gap)};
}

std::vector<Column> error_columns() {
  std::vector<Column> columns{{"steps", "-", "in the whole fall"}, {"step_s", "s", "its length"}};
  for (const ColumnScheme& scheme : separate_schemes()) {
    columns.push_back({scheme.column + "_angle", "rad",
                       "magnitude of the angle's error at the end, " + scheme.words});
    columns.push_back({scheme.column + "_gap", "m", "largest gap or overlap, " + scheme.words});
  }
  return columns;
}

Table order_table(const std::vector<Orders>& orders) {
  Table table{"orders",
              {{"scheme", "-", "its place in the other table, from 0"},
               {"angle_order", "-", "slope of the angle's error"},
               {"gap_order", "-", "slope of the gap"}}};
  for (std::size_t k = 0; k < orders.size(); ++k) table.add(k, orders[k].angle, orders[k].gap);
  return table;
}

// Gap over step of a method of first order, with what it tends to.
struct Tendency {
  std::string column;
  double predicted = 0.0;             // [1/s] of neighbours a metre apart
  std::vector<double> measured = {};  // [1/s] by step, each half as long as the one before

  // Two steps in a row cancel the error that is in proportion to the step.
  [[nodiscard]] double extrapolated() const {
    return 2.0 * measured.back() - measured[measured.size() - 2];
  }
};

Table constants_table(const std::vector<Tendency>& tendencies, const std::vector<double>& steps) {
  Table table{"constants", {{"step_s", "s", "length of the steps; 0: extrapolated"}}};
  for (const Tendency& tendency : tendencies) {
    table.columns.push_back(
        {tendency.column, "1/s", "gap over step and distance of neighbouring centres"});
    table.columns.push_back({tendency.column + "_exact", "1/s", "its limit by quadrature"});
  }
  for (std::size_t k = 0; k <= steps.size(); ++k) {
    const bool limit = k == steps.size();
    std::vector<double> row;
    for (const Tendency& tendency : tendencies)
      row.insert(row.end(),
                 {limit ? tendency.extrapolated() : tendency.measured[k], tendency.predicted});
    table.add(limit ? 0.0 : steps[k], row);
  }
  return table;
}

Result measure_glued_order(const Parameters& settings) {
  const ColumnFall fall{settings.number("phi0"), settings.number("time")};
  const std::span<const ColumnScheme> schemes = separate_schemes();
  const GapConstants constants = gap_constants(fall.time, fall.phi0);
  std::vector<Tendency> tendencies{{"forward_euler", constants.forward_euler},
                                   {"semi_implicit", constants.semi_implicit},
                                   {"impulse", constants.impulse}};
  Table table{"", error_columns()};
  std::vector<std::vector<Error>> errors(schemes.size());
  std::vector<double> steps;
  for (int k = 0; k <= settings.count("doublings"); ++k) {
    const int count = kFirstSteps << k;
    const double step = fall.time / count;
    steps.push_back(step);
    std::vector<double> row;
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const ColumnRun run = run_column(schemes[s], count, fall);
      errors[s].push_back({step, std::abs(run.angle_error), run.largest_gap});
      row.insert(row.end(), {errors[s].back().angle, errors[s].back().gap});
      for (Tendency& tendency : tendencies)
        if (tendency.column == schemes[s].column) tendency.measured.push_back(run.gap / step);
    }
    table.add(count, step, row);
  }

  std::vector<Orders> orders;
  double worst = 0.0;  // of the angle's orders
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    orders.push_back(orders_of(errors[s], settings.number("floor")));
    worst = std::max(worst, std::abs(orders.back().angle - schemes[s].order));
  }
  const Orders& classical = orders[5];
  const Orders& dormand_prince = orders[6];

  Result result;
  std::vector<Quantity>& out = result.quantities;
  out = {{"order of the gap in figure 6.1's column against the step, for the classical method of "
          "Runge and Kutta with forces solved at each stage, joints held",
          "-", classical.gap},
         {"order of the gap, Dormand-Prince 5", "-", dormand_prince.gap},
         {"order of the angle's error, Dormand-Prince 5", "-", dormand_prince.angle},
         {"largest difference of an angle's order from 1, 1, 1, 2, 2, 4, 5", "-", worst}};
  for (const Tendency& tendency : tendencies)
    out.push_back(
        {"limit of gap over step, over its integral, " + column_scheme(tendency.column).words, "-",
         tendency.extrapolated() / tendency.predicted});
  result.tables = {table, order_table(orders), constants_table(tendencies, steps)};
  return result;
}

const Registered claim_6_2b_order_figure{
    {.name = "claim_6_2b_order",
     .parameters = fall_parameters(1.0)
                       .add(whole("doublings", 9, 4, 12, "of 5 steps in the whole fall"))
                       .add(number("floor", 2e-13, 1e-14, 1e-6, "m or rad",
                                   "errors below it are not fitted")),
     .quick = {"doublings=6"},
     .experiment = measure_glued_order}};

}  // namespace
}  // namespace tumble::chapters
