/// \file
/// \brief The column turns, and is pushed along without turning (claim 6.2a).
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/pushed_column.hpp"

namespace tumble::chapters {
namespace {

constexpr double kSmall = 1e-3;  // [m] a thousandth of an edge: the claim's rule
constexpr int kBoxes = 4;
// [m] Gaps of single steps below this are not used for slopes: positions of some metres have 1e-15.
constexpr double kRounded = 1e-13;
constexpr std::size_t kSloped = 5;  // of film_schemes(): all but the reference

// [m] In the glue; or, with JointHold::edge, at the edge about which the column turns.
double largest_in_run(const HeldRun& run, JointHold hold = JointHold::area) {
  return largest_of(run.frames,
                    [&](const HeldFrame& frame) { return std::abs(widest(run, frame, hold)); });
}

// How many of the claim's two statements hold, given the gap of the column that turns and that of the
// column that is pushed.
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
    std::vector<double> gaps;
    for (std::size_t s = 0; s < kSloped; ++s) {
      gaps.push_back(std::abs(gap_of_step(exact, options_of(film_schemes()[s]), dt)));
      // The shorter half of the steps, where the leading term leads.
      if (gaps.back() <= kRounded || 2 * k < sizes - 1) continue;
      fitted_dt[s].push_back(dt);
      fitted_gap[s].push_back(gaps.back());
    }
    table.add(dt, 0.5 * rate * rate * dt * dt, gaps);
  }
  for (std::size_t s = 0; s < kSloped; ++s)
    result.add("order of the gap that a single step makes, " + film_schemes()[s].words, "-",
               fitted_order(fitted_dt[s], fitted_gap[s]));
  return table;
}

Result measure_turning(const Parameters& settings) {
  const double dt = 1.0 / settings.number("rate");
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  const World start = column_world(settings.number("angle"));
  const HeldRun turning = run_held(start, options_of(film_schemes()[0]), dt, steps);
  const HeldRun other = run_held(start, options_of(film_schemes()[1]), dt, steps);
  const double weight = kBoxes * start.gravity_w.norm();  // [N] of cubes of 1 kg
  const PushedRun pushed = push_column(kBoxes, settings.number("push") * weight, dt, steps);
  // Without a push, in free fall, by the technique itself.
  World falling = lone_column(kBoxes);
  falling.gravity_w = start.gravity_w;
  const HeldRun free = run_held(falling, options_of(film_schemes()[0]), dt, steps);

  Table table{"",
              {{"time_s", "s", "since the start"},
               {"turning_m", "m", "gap or overlap of the column that falls over the edge"},
               {"pushed_m", "m", "the same of the column that is pushed along"}}};
  for (std::size_t k = 0; k < turning.frames.size(); ++k)
    table.add(turning.frames[k].time, std::abs(widest(turning, turning.frames[k], JointHold::area)),
              pushed.gaps[k]);

  const double turned = largest_in_run(turning);
  Result result;
  result.quantities = {
      {"of two sayings those that hold: the column of figure 6.1 opens or overlaps by a thousandth "
       "of an edge or more within a second of its fall at 60 steps a second, and the same column "
       "pushed along without turning by less than a tenth of that",
       "-", holding(turned, pushed.gap)},
      {"largest gap or overlap of the column that turns, over an edge", "-", turned},
      {"the same, semi-implicit", "-", largest_in_run(other)},
      {"the same, of the edge about which it turns", "-", largest_in_run(turning, JointHold::edge)},
      {"largest gap or overlap of the column that is pushed, over an edge", "-", pushed.gap},
      {"the same, falling freely under the technique glued", "-", largest_in_run(free)},
      {"largest force in the glue of the column that is pushed, over its weight", "-",
       pushed.force / weight}};
  // The angle is ours. The column that is pushed has none.
  for (const auto& [factor, words] : {std::pair(0.5, "half"), std::pair(2.0, "twice")}) {
    const World other_start = column_world(factor * settings.number("angle"));
    const double gap =
        largest_in_run(run_held(other_start, options_of(film_schemes()[0]), dt, steps));
    const std::string angle = std::string(words) + " the angle at the start";
    result.add("the same sayings, " + angle, "-", holding(gap, pushed.gap));
    result.add("largest gap or overlap of the column that turns, over an edge, " + angle, "-", gap);
  }
  result.tables = {table};
  result.tables.push_back(single_steps(settings, result));
  return result;
}

const Registered claim_6_2a_turning_figure{
    {.name = "claim_6_2a_turning",
     .parameters = {number("angle", 0.3, 0.05, 0.9, "rad", "of the column's centre at the start"),
                    number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second"),
                    number("duration", 1.0, 0.1, 1.0, "s", "of both motions"),
                    number("push", 1.0, 0.0, 100.0, "-",
                           "on the column that does not turn, over its weight"),
                    whole("sizes", 21, 3, 200, "single steps, from 0.1 s to 0.01 s")},
     .quick = {"sizes=7"},
     .experiment = measure_turning}};

}  // namespace
}  // namespace tumble::chapters
