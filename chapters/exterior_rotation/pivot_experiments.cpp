/// \file
/// \brief Forces at the pivot of the falling column, and periods of boxes that swing on an edge.
#include "driver/common_numbers.hpp"
#include "exterior_rotation/box_pendulum.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "exterior_rotation/order_experiments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

constexpr double kWeight = 4.0 * kGravity;  // [N] of the column

// A column that falls, and the force at its pivot.
struct Falling {
  World world;
  Glued glued;

  Falling(GluedScheme scheme, double phi0) : world(column_world(phi0)), glued(of(scheme)) {}

  static GluedOptions of(GluedScheme scheme) {
    GluedOptions options;
    options.scheme = scheme;
    options.accuracy = 1e-13;
    return options;
  }

  [[nodiscard]] PivotForce pivot() const {
    const std::optional<BodyId> larger = world.find("larger");
    for (const ContactRecord& contact : glued.contacts())
      if (contact.first == larger) return {contact.push_w.y(), contact.push_w.x()};
    throw std::runtime_error("the column has no pivot");
  }
};

}  // namespace

Result measure_pivot_forces(const Parameters& settings) {
  const double phi0 = settings.number("phi0");
  const double rate = settings.number("rate");
  const std::array<ColumnScheme, 3> schemes{column_scheme("rk4"), column_scheme("dormand_prince"),
                                            column_scheme("semi_implicit")};
  std::vector<Falling> runs;
  Table table{"",
              {{"time_s", "s", "since the column was released"},
               {"angle_deg", "deg", "of its centre from the vertical, closed form"},
               {"normal", "-", "normal force over weight, closed form"},
               {"tangential", "-", "tangential force over weight, closed form"},
               {"friction", "-", "coefficient of friction that this takes"}}};
  for (const ColumnScheme& scheme : schemes) {
    runs.emplace_back(scheme.scheme, phi0);
    table.columns.push_back({scheme.column + "_normal", "-", "as simulated, " + scheme.words});
    table.columns.push_back({scheme.column + "_tangential", "-", "as simulated"});
    table.columns.push_back({scheme.column + "_friction", "-", "that it takes, as simulated"});
    table.columns.push_back(
        {scheme.column + "_error", "-", "largest error of either force, over weight"});
  }
  const int steps = static_cast<int>(std::lround(settings.number("time") * rate));
  double lowest = 1.0;            // [-] normal force over weight
  double lowest_angle = 0.0;      // [degrees]
  double most_friction = 0.0;     // [-]
  std::array<double, 3> worst{};  // [-]
  for (int k = 1; k <= steps; ++k) {
    const double time = k / rate;
    const double angle = column_angle(time, phi0);
    const PivotForce exact = pivot_force(angle, phi0);
    table.rows.push_back({time, angle * 180.0 / std::numbers::pi, exact.normal / kWeight,
                          exact.tangential / kWeight, std::abs(exact.tangential) / exact.normal});
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      runs[s].glued.step(runs[s].world, 1.0 / rate);
      const PivotForce found = runs[s].pivot();
      const double error = std::max(std::abs(found.normal - exact.normal),
                                    std::abs(found.tangential - exact.tangential)) /
                           kWeight;
      worst[s] = std::max(worst[s], error);
      const double friction = std::abs(found.tangential) / found.normal;
      table.rows.back().insert(
          table.rows.back().end(),
          {found.normal / kWeight, found.tangential / kWeight, friction, error});
      if (s != 0) continue;
      most_friction = std::max(most_friction, friction);
      if (found.normal / kWeight < lowest) {
        lowest = found.normal / kWeight;
        lowest_angle = centre_angle(runs[s].world) * 180.0 / std::numbers::pi;
      }
    }
  }
  // Without glue the top joint would open here: the forces above are those of the glued column.
  const double opens = opening_angle(3, phi0);
  Table marks{"marks",
              {{"opens_s", "s", "when the top joint would open without glue"},
               {"opens_deg", "deg", "angle of the column's centre then"}}};
  marks.rows.push_back({column_time(opens, phi0), opens * 180.0 / std::numbers::pi});

  // At rest: a step so short that nothing has moved.
  Falling start(GluedScheme::rk4, phi0);
  start.glued.step(start.world, 1e-9);
  const PivotForce rest = start.pivot();
  Result result;
  std::vector<Quantity>& out = result.quantities;
  out.push_back({"normal force at rest, over weight", "-", rest.normal / kWeight});
  out.push_back({"tangential force at rest, over weight", "-", rest.tangential / kWeight});
  out.push_back({"coefficient of friction that rest takes", "-", rest.tangential / rest.normal});
  out.push_back(
      {"largest coefficient of friction that a moment of the fall takes", "-", most_friction});
  out.push_back({"lowest normal force in the fall, over weight", "-", lowest});
  out.push_back({"angle of the centre at the lowest normal force", "deg", lowest_angle});
  for (std::size_t s = 0; s < schemes.size(); ++s)
    out.push_back({"largest error of a force over weight, " + schemes[s].words, "-", worst[s]});
  out.push_back({"angle of the centre at which the top joint would open without glue", "deg",
                 marks.rows.front()[1]});
  result.tables = {table, marks};
  return result;
}

Result measure_swing_periods(const Parameters& settings) {
  struct Box {
    std::string column;
    std::string words;
    double height;  // [m]
  };
  const std::array<Box, 2> boxes{{{"cube", "1 m by 1 m", 1.0}, {"tall", "1 m by 2 m", 2.0}}};
  Table table{"", {{"amplitude_deg", "deg", "how far the box swings to each side"}}};
  for (const Box& box : boxes) {
    table.columns.push_back({box.column + "_s", "s", "period as simulated, " + box.words});
    table.columns.push_back({box.column + "_exact_s", "s", "closed form"});
    table.columns.push_back({box.column + "_error", "-", "magnitude of the error over the period"});
  }
  const std::array<double, 15> amplitudes{1.0,   15.0,  30.0,  45.0,  60.0,  75.0,  90.0, 105.0,
                                          120.0, 135.0, 145.0, 155.0, 160.0, 165.0, 170.0};
  const std::array<double, 5> told{1.0, 30.0, 90.0, 135.0, 170.0};
  Result result;
  double worst = 0.0;
  double apart = 0.0;
  for (const double degrees : amplitudes) {
    const double amplitude = degrees * std::numbers::pi / 180.0;
    table.rows.push_back({degrees});
    for (const Box& box : boxes) {
      const MeasuredSwing swing =
          measure_swing(1.0, box.height, amplitude, settings.number("accuracy"));
      const double exact = exact_swing_period(1.0, box.height, amplitude);
      const double error = std::abs(swing.period - exact) / exact;
      table.rows.back().insert(table.rows.back().end(), {swing.period, exact, error});
      worst = std::max(worst, error);
      apart = std::max(apart, swing.apart);
      if (std::find(told.begin(), told.end(), degrees) != told.end())
        result.quantities.push_back({std::string("period at an amplitude of ") +
                                         std::to_string(static_cast<int>(degrees)) + " deg, " +
                                         box.words,
                                     "s", swing.period});
    }
  }
  Table curve{"exact", {{"amplitude_deg", "deg", "how far the box swings to each side"}}};
  for (const Box& box : boxes)
    curve.columns.push_back({box.column + "_s", "s", "period, closed form, " + box.words});
  for (int degrees = 0; degrees <= 174; ++degrees) {
    curve.rows.push_back({static_cast<double>(degrees)});
    for (const Box& box : boxes)
      curve.rows.back().push_back(
          exact_swing_period(1.0, box.height, degrees * std::numbers::pi / 180.0));
  }
  result.quantities.push_back({"largest error of a period, over it", "-", worst});
  result.quantities.push_back({"furthest that an edge came apart", "m", apart});
  result.tables = {table, curve};
  return result;
}

}  // namespace tumble::chapters
