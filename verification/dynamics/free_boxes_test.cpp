/// \file
/// \brief A box in free flight against four engines' published errors (Peters and Hsu 2014).
#include "tumble/dynamics/integrate.hpp"

#include "support/shared_data.hpp"
#include "support/test.hpp"

#include <fstream>

namespace {

// Largest errors over 10 s of flight; momentum and energy relative to their start.
struct Errors {
  double angular_momentum = 0.0;  // [-]
  double energy = 0.0;            // [-]
  double position = 0.0;          // [m]
};

// A published row.
struct Row {
  std::string engine;
  double dt = 0.0;
  bool complex = false;
  Errors errors;
};

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  REQUIRE(in);
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(in, line);
  std::map<std::string, std::size_t> column;
  for (const std::string& name : cells_of(line)) {
    const std::size_t number = column.size();
    column[name] = number;
  }
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    const auto number = [&](const char* name) { return std::stod(cells.at(column.at(name))); };
    rows.push_back(Row{cells.at(column.at("engine")), number("dt"), number("isComplex") != 0.0,
                       Errors{number("angMomentumErr_maxAbs"), number("energyError_maxAbs"),
                              number("linPositionErr_maxAbs")}});
  }
  return rows;
}

// Our flight with the same box, start, step and duration. Angular momentum is measured as an
// engine would have it, through the velocity: I ω; it is not the stored number read back.
Errors flown(bool complex, double dt, RotationRule rule) {
  const BodyProperties body = box_properties(Vec3(0.1, 0.4, 0.9), 10.0);
  const Vec3 gravity = complex ? Vec3(0.0, 0.0, -9.8) : Vec3::Zero();
  const Vec3 v0 = complex ? Vec3(-2.0, 2.0, 8.0) : Vec3(-0.9, 0.4, 0.1);
  const Vec3 omega0 = complex ? Vec3(0.1, 5.0, 0.1) : Vec3(0.5, 0.0, 0.0);
  BodyState state = make_state(body, Vec3::Zero(), Quat::Identity(), v0, omega0);
  const double energy0 = energy_of(body, state, gravity).total();
  const Vec3 momentum0 = state.angular_momentum_w;
  Errors worst;
  const int steps = static_cast<int>(std::lround(10.0 / dt));
  for (int i = 1; i <= steps; ++i) {
    fly(body, state, gravity, dt, rule);
    const double t = i * dt;
    const Mat3 r = state.orientation_wb.toRotationMatrix();
    const Vec3 momentum =
        r * body.inertia_b.cwiseProduct(r.transpose() * angular_velocity(body, state));
    const Vec3 exact = v0 * t + 0.5 * t * t * gravity;
    worst.angular_momentum =
        std::max(worst.angular_momentum, (momentum - momentum0).norm() / momentum0.norm());
    worst.energy = std::max(worst.energy,
                            std::abs(energy_of(body, state, gravity).total() - energy0) / energy0);
    worst.position = std::max(worst.position, (state.position_w - exact).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("A free box keeps momentum, energy and its parabola at least as well as four engines",
          "[reference][free_boxes]") {
  const auto folder = shared_data("scpeters-boxes");
  if (!folder) return;
  const std::vector<Row> rows = read_rows(*folder / "BENCHMARK_boxes_dt.csv");
  REQUIRE(rows.size() >= 80);

  // Where both are exact but for rounding, 10^4 to 10^5 steps of it are no contest.
  constexpr double rounding = 1e-10;
  std::map<std::pair<bool, double>, std::map<RotationRule, Errors>> ours;
  std::map<RotationRule, std::map<std::string, int>> beaten;  // rows met or beaten, by engine
  std::map<std::string, int> total;
  for (const Row& row : rows) {
    auto& by_rule = ours[{row.complex, row.dt}];
    if (by_rule.empty())
      for (const RotationRule rule : rotation_rules())
        by_rule[rule] = flown(row.complex, row.dt, rule);
    ++total[row.engine];
    for (const RotationRule rule : rotation_rules()) {
      const Errors& mine = by_rule[rule];
      const bool met = mine.angular_momentum <= std::max(row.errors.angular_momentum, rounding) &&
                       mine.energy <= std::max(row.errors.energy, rounding) &&
                       mine.position <= std::max(row.errors.position, rounding);
      beaten[rule][row.engine] += met ? 1 : 0;
      const bool must = rule == RotationRule::splitting || rule == RotationRule::rk4;
      if (must && !met)
        FAIL_CHECK(row.engine << " at " << row.dt << " s, " << name_of(rule) << ": "
                              << mine.angular_momentum << " " << mine.energy << " " << mine.position
                              << " against " << row.errors.angular_momentum << " "
                              << row.errors.energy << " " << row.errors.position);
    }
  }
  std::ostringstream table;
  for (const RotationRule rule : rotation_rules()) {
    table << name_of(rule) << " meets or beats";
    for (const auto& [engine, count] : total)
      table << "  " << engine << " " << beaten[rule][engine] << "/" << count;
    const Errors& at_1ms = ours[{true, 0.001}][rule];
    table << "; complex case at 1 ms: momentum " << at_1ms.angular_momentum << ", energy "
          << at_1ms.energy << ", position " << at_1ms.position << " m\n";
  }
  INFO(table.str());
  CHECK(beaten[RotationRule::splitting] == total);
  CHECK(beaten[RotationRule::rk4] == total);
  CHECK(beaten[RotationRule::midpoint] == total);
  // Even the first-order rule is better than the engines in momentum, which it does not touch.
  CHECK(ours[{true, 0.001}][RotationRule::frozen].angular_momentum < 1e-12);
}
