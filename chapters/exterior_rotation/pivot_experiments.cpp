/// \file
/// \brief Forces at the pivot of the falling column, and periods of boxes that swing on an edge.
#include "driver/experiment.hpp"
#include "exterior_rotation/box_pendulum.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

constexpr double kWeight = 4.0 * kGravity;  // [N] of the column

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }
double radians(double angle) { return angle * std::numbers::pi / 180.0; }

// A column that falls, and the force at its pivot.
struct Falling {
  World world;
  Glued glued;

  Falling(GluedScheme scheme, double phi0)
      : world(column_world(phi0)), glued(glued_options(scheme, PoseUpdate::separate, 1e-13)) {}

  [[nodiscard]] PivotForce pivot() const {
    const std::optional<BodyId> larger = world.find("larger");
    for (const ContactRecord& contact : glued.contacts())
      if (contact.first == larger) return {contact.push_w.y(), contact.push_w.x()};
    throw std::runtime_error("the column has no pivot");
  }
};

Result measure_pivot_forces(const Parameters& settings) {
  const double phi0 = settings.number("phi0");
  const double rate = settings.number("rate");
  // The first one is drawn; of the others the errors are.
  const std::array<ColumnScheme, 3> schemes{column_scheme("rk4"), column_scheme("dormand_prince"),
                                            column_scheme("semi_implicit")};
  std::vector<Falling> runs;
  Table table{"",
              {{"time_s", "s", "since the column was released"},
               {"normal", "-", "normal force over weight, closed form"},
               {"tangential", "-", "tangential force over weight, closed form"},
               {"friction", "-", "coefficient of friction that this takes"},
               {"rk4_normal", "-", "as simulated, Runge-Kutta 4"},
               {"rk4_tangential", "-", "as simulated"},
               {"rk4_friction", "-", "that it takes, as simulated"}}};
  for (const ColumnScheme& scheme : schemes) {
    runs.emplace_back(scheme.scheme, phi0);
    table.columns.push_back({scheme.column + "_error", "-",
                             "largest error of either force, over weight, " + scheme.words});
  }
  const int steps = static_cast<int>(std::lround(settings.number("time") * rate));
  double lowest = 1.0;            // [-] normal force over weight
  double lowest_angle = 0.0;      // [degrees]
  double most_friction = 0.0;     // [-]
  std::array<double, 3> worst{};  // [-]
  for (int k = 1; k <= steps; ++k) {
    const double time = k / rate;
    const PivotForce exact = pivot_force(column_angle(time, phi0), phi0);
    std::array<PivotForce, 3> found;
    std::array<double, 3> errors{};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      finished(runs[s].glued.step(runs[s].world, 1.0 / rate));
      found[s] = runs[s].pivot();
      errors[s] = std::max(std::abs(found[s].normal - exact.normal),
                           std::abs(found[s].tangential - exact.tangential)) /
                  kWeight;
      worst[s] = std::max(worst[s], errors[s]);
    }
    const double friction = std::abs(found[0].tangential) / found[0].normal;
    table.add(time, exact.normal / kWeight, exact.tangential / kWeight,
              std::abs(exact.tangential) / exact.normal, found[0].normal / kWeight,
              found[0].tangential / kWeight, friction, errors);
    most_friction = std::max(most_friction, friction);
    if (found[0].normal / kWeight < lowest) {
      lowest = found[0].normal / kWeight;
      lowest_angle = degrees(centre_angle(runs[0].world));
    }
  }
  // Without glue the top joint would open here: the forces above are those of the glued column.
  const double opens = opening_angle(3, phi0);
  Table marks{"marks", {{"opens_s", "s", "when the top joint would open without glue"}}};
  marks.add(column_time(opens, phi0));

  // At rest: a step so short that nothing has moved.
  Falling start(GluedScheme::rk4, phi0);
  finished(start.glued.step(start.world, 1e-9));
  const PivotForce rest = start.pivot();
  Result result;
  result.tables = {table, marks};
  result.quantities = {
      {"normal force at rest, over weight", "-", rest.normal / kWeight},
      {"tangential force at rest, over weight", "-", rest.tangential / kWeight},
      {"coefficient of friction that rest takes", "-", rest.tangential / rest.normal},
      {"largest coefficient of friction that a moment of the fall takes", "-", most_friction},
      {"lowest normal force in the fall, over weight", "-", lowest},
      {"angle of the centre at the lowest normal force", "deg", lowest_angle},
      {"angle of the centre at which the top joint would open without glue", "deg",
       degrees(opens)}};
  for (std::size_t s = 0; s < schemes.size(); ++s)
    result.add("largest error of a force over weight, " + schemes[s].words, "-", worst[s]);
  return result;
}

const Registered pivot_forces_figure{{.name = "pivot_forces",
                                      .parameters = fall_parameters(1.25).add_number(
                                          "rate", 60.0, 10.0, 1000.0, "1/s", "steps a second"),
                                      .quick = {"time=0.5"},
                                      .experiment = measure_pivot_forces}};

Result measure_swing_periods(const Parameters& settings) {
  struct Box {
    std::string column;
    std::string words;
    double height;  // [m]
  };
  const std::array<Box, 2> boxes{{{"cube", "1 m by 1 m", 1.0}, {"tall", "1 m by 2 m", 2.0}}};
  Table table{"", {{"amplitude_deg", "deg", "how far the box swings to each side"}}};
  Table curve{"exact", table.columns};
  for (const Box& box : boxes) {
    table.columns.push_back({box.column + "_s", "s", "period as simulated, " + box.words});
    table.columns.push_back({box.column + "_error", "-", "magnitude of the error over the period"});
    curve.columns.push_back({box.column + "_s", "s", "period, closed form, " + box.words});
  }
  double worst = 0.0;
  double apart = 0.0;
  for (const double amplitude : {1.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0,
                                 145.0, 155.0, 160.0, 165.0, 170.0}) {
    std::vector<double> row;
    for (const Box& box : boxes) {
      const MeasuredSwing swing =
          measure_swing(1.0, box.height, radians(amplitude), settings.number("accuracy"));
      const double exact = exact_swing_period(1.0, box.height, radians(amplitude));
      const double error = std::abs(swing.period - exact) / exact;
      row.insert(row.end(), {swing.period, error});
      worst = std::max(worst, error);
      apart = std::max(apart, swing.apart);
    }
    table.add(amplitude, row);
  }
  for (int amplitude = 0; amplitude <= 174; ++amplitude) {
    std::vector<double> periods;
    for (const Box& box : boxes)
      periods.push_back(exact_swing_period(1.0, box.height, radians(amplitude)));
    curve.add(amplitude, periods);
  }
  return {{table, curve},
          {{"largest error of a period, over it", "-", worst},
           {"furthest that an edge came apart", "m", apart}}};
}

const Registered swing_periods_figure{
    {.name = "swing_periods",
     .parameters = Parameters{}.add_number("accuracy", 1e-14, 1e-14, 1e-3, "-",
                                           "error that is allowed in a step"),
     .quick = {"accuracy=1e-10"},
     .experiment = measure_swing_periods}};

}  // namespace
}  // namespace tumble::chapters
