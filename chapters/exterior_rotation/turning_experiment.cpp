/// \file
/// \brief The column turns, and is pushed along without turning (claim 6.2a).
#include "driver/statistics.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/film_schemes.hpp"
#include "exterior_rotation/problem_experiments.hpp"
#include "exterior_rotation/pushed_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace tumble::chapters {
namespace {

constexpr double kSmall = 1e-3;  // [m] a thousandth of an edge: the claim's rule
constexpr int kBoxes = 4;
// [m] Gaps of single steps below this are not used for slopes: positions of some metres have 1e-15.
constexpr double kRounded = 1e-13;
constexpr std::size_t kSloped = 5;  // of film_schemes(): all but the reference

double largest(const HeldRun& run, const std::function<double(const HeldFrame&)>& of) {
  double largest = 0.0;
  for (const HeldFrame& frame : run.frames) largest = std::max(largest, std::abs(of(frame)));
  return largest;
}

double largest_glue_gap(const HeldRun& run) {
  return largest(run, [&](const HeldFrame& f) { return widest(run, f, JointHold::area); });
}

// Of the claim's two sayings those that hold, from the gaps of the column that turns and of the one that
// is pushed.
double holding(double turned, double pushed) {
  return (turned >= kSmall ? 1.0 : 0.0) + (pushed < 0.1 * kSmall ? 1.0 : 0.0);
}

// Gaps of single steps from the exact state at the end, by length of the step.
Table single_steps(const Parameters& settings, Result& result) {
  Table table{"steps",
              {{"step_s", "s", "length of the step"},
               {"arc_m", "m", "omega^2 h^2 s / 2, from the exact state"}}};
  for (std::size_t s = 0; s < kSloped; ++s)
    table.columns.push_back({film_schemes()[s].column + "_m", "m",
                             "magnitude of the gap after one step, " + film_schemes()[s].words});
  const double angle = settings.number("angle");
  const double time = settings.number("duration");
  const double rate = column_rate(time, angle);
  const World exact = column_world(column_angle(time, angle), rate);
  std::array<std::vector<double>, kSloped> fitted_dt;
  std::array<std::vector<double>, kSloped> fitted_gap;
  const int sizes = settings.count("sizes");
  for (int k = 0; k < sizes; ++k) {
    const double dt = 0.1 * std::pow(0.1, static_cast<double>(k) / (sizes - 1));
    table.rows.push_back({dt, 0.5 * rate * rate * dt * dt});
    for (std::size_t s = 0; s < kSloped; ++s) {
      const double gap = std::abs(gap_of_step(exact, options_of(film_schemes()[s]), dt));
      table.rows.back().push_back(gap);
      // The shorter half of the steps, where the leading term leads.
      if (gap <= kRounded || 2 * k < sizes - 1) continue;
      fitted_dt[s].push_back(dt);
      fitted_gap[s].push_back(gap);
    }
  }
  for (std::size_t s = 0; s < kSloped; ++s)
    result.quantities.push_back(
        {"order of the gap that a single step makes, " + film_schemes()[s].words, "-",
         fitted_order(fitted_dt[s], fitted_gap[s])});
  return table;
}

}  // namespace

Result measure_turning(const Parameters& settings) {
  const double dt = 1.0 / settings.number("rate");
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  const World start = column_world(settings.number("angle"));
  const HeldRun turning = run_held(start, options_of(film_schemes()[0]), dt, steps);
  const HeldRun other = run_held(start, options_of(film_schemes()[1]), dt, steps);
  const double weight = kBoxes * start.gravity_w.norm();  // [N] of cubes of 1 kg
  const PushedRun pushed = push_column(kBoxes, settings.number("push") * weight, dt, steps);
  // The same without a push, falling, by the technique itself.
  World falling = lone_column(kBoxes);
  falling.gravity_w = start.gravity_w;
  const HeldRun free = run_held(falling, options_of(film_schemes()[0]), dt, steps);

  Table table{"",
              {{"time_s", "s", "since the start"},
               {"turning_m", "m", "gap or overlap of the column that falls over the edge"},
               {"pushed_m", "m", "the same of the column that is pushed along"}}};
  for (std::size_t k = 0; k < turning.frames.size(); ++k)
    table.rows.push_back({turning.frames[k].time,
                          std::abs(widest(turning, turning.frames[k], JointHold::area)),
                          pushed.gaps[k]});

  const double turned = largest_glue_gap(turning);
  const double semi = largest_glue_gap(other);
  const double edge =
      largest(turning, [&](const HeldFrame& f) { return widest(turning, f, JointHold::edge); });
  Result result;
  result.quantities = {
      {"of two sayings those that hold: the column of figure 6.1 opens or overlaps by a thousandth "
       "of an edge or more within a second of its fall at 60 steps a second, and the same column "
       "pushed along without turning by less than a tenth of that",
       "-", holding(turned, pushed.gap)},
      {"largest gap or overlap of the column that turns, over an edge", "-", turned},
      {"the same, semi-implicit", "-", semi},
      {"the same, of the edge about which it turns", "-", edge},
      {"largest gap or overlap of the column that is pushed, over an edge", "-", pushed.gap},
      {"the same, falling freely under the technique glued", "-", largest_glue_gap(free)},
      {"largest force in the glue of the column that is pushed, over its weight", "-",
       pushed.force / weight}};
  // The angle is ours. The column that is pushed has none.
  for (const auto& [factor, words] : {std::pair(0.5, "half"), std::pair(2.0, "twice")}) {
    const World other_start = column_world(factor * settings.number("angle"));
    const double gap =
        largest_glue_gap(run_held(other_start, options_of(film_schemes()[0]), dt, steps));
    const std::string angle = std::string(words) + " the angle at the start";
    result.quantities.push_back({"the same sayings, " + angle, "-", holding(gap, pushed.gap)});
    result.quantities.push_back(
        {"largest gap or overlap of the column that turns, over an edge, " + angle, "-", gap});
  }
  result.tables = {table};
  result.tables.push_back(single_steps(settings, result));
  return result;
}

}  // namespace tumble::chapters
