/// \file
/// \brief Orders of the glued column's integration, and the gap of one step.
#include "exterior_rotation/order_experiments.hpp"

#include "driver/statistics.hpp"
#include "exterior_rotation/column_reference.hpp"
#include "exterior_rotation/column_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

constexpr int kFirstSteps = 5;  // in the whole fall: the coarsest
constexpr int kFitted = 4;      // steps that an order is told from

// What of a scheme was measured at one step.
struct Error {
  double step = 0.0;   // [s]
  double angle = 0.0;  // [rad] magnitude
  double gap = 0.0;    // [m] magnitude
};

struct Orders {
  double angle = 0.0;
  double gap = 0.0;
  double longest = 0.0;   // [s] step of the range
  double shortest = 0.0;  // [s]
};

// Of the shortest steps that are not yet disturbed by rounding.
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
  return {fitted_order(step, angle), fitted_order(step, gap), step.back(), step.front()};
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
               {"gap_order", "-", "slope of the gap"},
               {"longest_s", "s", "longest step of the fit"},
               {"shortest_s", "s", "shortest step of the fit"}}};
  for (std::size_t k = 0; k < orders.size(); ++k)
    table.rows.push_back({static_cast<double>(k), orders[k].angle, orders[k].gap, orders[k].longest,
                          orders[k].shortest});
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
    table.rows.push_back({k < steps.size() ? steps[k] : 0.0});
    for (const Tendency& tendency : tendencies) {
      table.rows.back().push_back(k < steps.size() ? tendency.measured[k]
                                                   : tendency.extrapolated());
      table.rows.back().push_back(tendency.predicted);
    }
  }
  return table;
}

}  // namespace

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
    table.rows.push_back({static_cast<double>(count), step});
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const ColumnRun run = run_column(schemes[s], count, fall);
      errors[s].push_back({step, std::abs(run.angle_error), run.largest_gap});
      table.rows.back().push_back(errors[s].back().angle);
      table.rows.back().push_back(errors[s].back().gap);
      for (Tendency& tendency : tendencies)
        if (tendency.column == schemes[s].column) tendency.measured.push_back(run.gap / step);
    }
  }

  std::vector<Orders> orders;
  double worst = 0.0;  // of the angle's orders
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    orders.push_back(orders_of(errors[s], settings.number("floor")));
    worst = std::max(worst, std::abs(orders.back().angle - schemes[s].order));
  }
  const auto order_of = [&](std::string_view column) {
    for (std::size_t s = 0; s < schemes.size(); ++s)
      if (schemes[s].column == column) return orders[s];
    return Orders{};
  };

  Result result;
  std::vector<Quantity>& out = result.quantities;
  out.push_back(
      {"order of the gap in figure 6.1's column against the step, for the classical "
       "method of Runge and Kutta with forces solved at each stage, joints held",
       "-", order_of("rk4").gap});
  for (const ColumnScheme& scheme : schemes)
    if (scheme.column != "rk4")
      out.push_back({"order of the gap, " + scheme.words, "-", order_of(scheme.column).gap});
  out.push_back(
      {"order of the angle's error, Dormand-Prince 5", "-", order_of("dormand_prince").angle});
  out.push_back({"largest difference of an angle's order from 1, 1, 1, 2, 2, 4, 5", "-", worst});
  for (const Tendency& tendency : tendencies)
    out.push_back(
        {"limit of gap over step, over its integral, " + column_scheme(tendency.column).words, "-",
         tendency.extrapolated() / tendency.predicted});
  result.tables = {table, order_table(orders), constants_table(tendencies, steps)};
  return result;
}

Result measure_one_step_gap(const Parameters& settings) {
  const double spin = settings.number("spin");
  const std::span<const ColumnScheme> schemes = separate_schemes();
  Table table{"",
              {{"step_s", "s", "length of the only step"},
               {"predicted", "m", "half of the square of the angle turned, times a metre"}}};
  for (const ColumnScheme& scheme : schemes)
    table.columns.push_back({scheme.column, "m", "gap after the step, " + scheme.words});
  const auto row_of = [&](double step) {
    std::vector<double> row{step, 0.5 * spin * spin * step * step};
    for (const ColumnScheme& scheme : schemes) {
      World world = column_world(settings.number("angle"), spin);
      GluedOptions options;
      options.scheme = scheme.scheme;
      options.accuracy = 1.0;
      Glued(options).step(world, step);
      row.push_back(column_gap(world));
    }
    return row;
  };
  // Around 1/60 s by factors of two; orders are told from the four about it, the shortest 1/120 s.
  for (int k = -2; k <= settings.count("doublings"); ++k)
    table.rows.push_back(row_of(std::ldexp(1.0 / 60.0, -k)));

  Result result;
  std::vector<Quantity>& out = result.quantities;
  const std::vector<double>& usual = table.rows[2];
  const auto order_of = [&](std::size_t column) {
    std::vector<double> step;
    std::vector<double> gap;
    for (std::size_t k = 0; k < kFitted; ++k) {
      step.push_back(table.rows[k][0]);
      gap.push_back(std::abs(table.rows[k][column]));
    }
    return fitted_order(step, gap);
  };
  out.push_back({"half of the square of the angle turned in 1/60 s, times a metre", "m", usual[1]});
  for (std::size_t s = 0; s < schemes.size(); ++s)
    if (schemes[s].column != "dormand_prince")
      out.push_back({"gap after 1/60 s, " + schemes[s].words, "m", usual[2 + s]});
  for (std::size_t s = 0; s < schemes.size(); ++s)
    if (schemes[s].column == "forward_euler" || schemes[s].column == "midpoint" ||
        schemes[s].column == "rk4")
      out.push_back({"order of the gap of one step, " + schemes[s].words, "-", order_of(2 + s)});
  result.tables = {table};
  return result;
}

}  // namespace tumble::chapters
