/// \file
/// \brief Experiments on free motion (thesis 3.1).
#include "tumble/dynamics/integrate.hpp"
#include "tumble/math/bracket.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include "basic_colliding/experiments.hpp"
#include "basic_colliding/free_rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tumble::chapters {
namespace {

// A box with three different moments of inertia, 5, 10 and 13 kg m².
BodyProperties uneven_box() { return box_properties(Vec3(3.0, 2.0, 1.0), 12.0); }

// It stands upright in the world at first, so that body and world frame agree.
BodyState spun(const BodyProperties& body, const Vec3& omega) {
  return make_state(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega);
}

// Spun about the middle axis, a little off; and a motion without a flip.
const Vec3 kUnstableSpin(0.01, 5.0, 0.02);  // [rad/s]
const Vec3 kStableSpin(1.0, 0.0, 2.0);      // [rad/s]

double middle_rate(const BodyProperties& body, const BodyState& state) {
  return (state.orientation_wb.conjugate() * angular_velocity(body, state)).y();
}

// When the middle angular velocity is 0 for the first time: whole steps until its sign has changed,
// then the last step again with its length halved until it ends there.
double first_flip(const BodyProperties& body, double step, RotationRule rule) {
  constexpr int cap = 1100;         // enough for any two doubles
  constexpr double give_up = 30.0;  // [s] ten times the true time
  BodyState state = spun(body, kUnstableSpin);
  for (int k = 0; k * step < give_up; ++k) {
    const auto rate_after = [&](double part) {
      BodyState later = state;
      advance_pose(body, later, part, rule);
      return middle_rate(body, later);
    };
    if (rate_after(step) < 0.0) {
      return k * step + bisect(rate_after, Bracket{0.0, step}, 0.0, cap).bracket.low;
    }
    advance_pose(body, state, step, rule);
  }
  throw std::runtime_error("the box has not turned over after 30 s");
}

// Slope on log-log axes between two of the errors, each belonging to half the step before it.
double order_between(double coarse, double fine, int halvings) {
  return elementary::log(std::abs(coarse / fine)) / (halvings * elementary::log(2.0));
}

Column of_rule(RotationRule rule, const std::string& ending, const std::string& unit,
               const std::string& meaning) {
  const std::string name(name_of(rule));
  return {name + ending, unit, meaning + ", rule " + name};
}

Table flip_errors(const FreeRotation& exact, std::vector<Quantity>& quantities) {
  const BodyProperties body = uneven_box();
  Table table{"flips", {{"step_s", "s", "time step"}}};
  for (const RotationRule rule : rotation_rules()) {
    table.columns.push_back(of_rule(rule, "_s", "s", "error of the first flip"));
  }
  constexpr std::array<double, 4> steps_per_second = {60.0, 120.0, 240.0, 1000.0};
  for (const double frequency : steps_per_second) {
    std::vector<double> row{1.0 / frequency};
    for (const RotationRule rule : rotation_rules()) {
      row.push_back(first_flip(body, 1.0 / frequency, rule) - exact.first_flip());
      if (frequency != 60.0 && frequency != 1000.0) continue;
      quantities.push_back({"error of the first flip, " + std::string(name_of(rule)) + " at 1/" +
                                (frequency == 60.0 ? "60" : "1000") + " s",
                            "s", row.back()});
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

Result measure_rotation_rules(const Parameters& settings) {
  const double step = settings.number("step");
  const BodyProperties body = uneven_box();
  const FreeRotation exact(body.inertia_b, kUnstableSpin);
  constexpr double accepted = 1e-6;

  Table table{"",
              {{"time_s", "s", "time"},
               {"exact_rad_s", "rad/s", "middle angular velocity, body frame, exact"}}};
  for (const RotationRule rule : rotation_rules()) {
    table.columns.push_back(of_rule(rule, "_rad_s", "rad/s", "middle angular velocity"));
  }
  for (const RotationRule rule : rotation_rules()) {
    table.columns.push_back(of_rule(rule, "_energy", "-", "energy error over the energy"));
  }
  table.columns.push_back({"accepted", "-", "energy error accepted of rule rk4"});

  std::vector<BodyState> states(rotation_rules().size(), spun(body, kUnstableSpin));
  std::vector<double> worst(states.size(), 0.0);
  const double energy = kinetic_energy(body, states.front());
  const int steps = static_cast<int>(std::lround(settings.number("duration") / step));
  for (int k = 0; k <= steps; ++k) {
    std::vector<double> row{k * step, exact.at(k * step).y()};
    for (const BodyState& state : states) row.push_back(middle_rate(body, state));
    for (std::size_t i = 0; i < states.size(); ++i) {
      row.push_back(std::abs(kinetic_energy(body, states[i]) / energy - 1.0));
      worst[i] = std::max(worst[i], row.back());
      advance_pose(body, states[i], step, rotation_rules()[i]);
    }
    row.push_back(accepted);
    table.rows.push_back(row);
  }

  std::vector<Quantity> quantities{{"first flip, exact", "s", exact.first_flip()},
                                   {"time between flips, exact", "s", exact.flip_interval()}};
  for (std::size_t i = 0; i < states.size(); ++i) {
    quantities.push_back(
        {"largest energy error, " + std::string(name_of(rotation_rules()[i])), "-", worst[i]});
  }
  const Table flips = flip_errors(exact, quantities);
  return {{table, flips}, quantities};
}

Result measure_rotation_order(const Parameters& settings) {
  const double time = settings.number("time");
  const int halvings = settings.count("halvings");
  const BodyProperties body = uneven_box();
  const Quat truth = free_orientation(body.inertia_b, kStableSpin, time);

  Table table{"", {{"step_s", "s", "time step"}}};
  for (const RotationRule rule : rotation_rules()) {
    table.columns.push_back(of_rule(rule, "_rad", "rad", "angle from the true orientation"));
  }
  for (int halving = 0; halving <= halvings; ++halving) {
    const int steps = 16 << halving;
    std::vector<double> row{time / steps};
    for (const RotationRule rule : rotation_rules()) {
      BodyState state = spun(body, kStableSpin);
      for (int k = 0; k < steps; ++k) advance_pose(body, state, time / steps, rule);
      row.push_back(angle_between(state.orientation_wb, truth));
    }
    table.rows.push_back(row);
  }

  // Between the second and the fifth halving steps are short enough for the leading term and
  // errors are large enough against rounding.
  std::vector<Quantity> quantities;
  for (std::size_t i = 0; i < rotation_rules().size(); ++i) {
    quantities.push_back({"order, " + std::string(name_of(rotation_rules()[i])), "-",
                          order_between(table.rows[2][i + 1], table.rows[5][i + 1], 3)});
  }
  return {{table}, quantities};
}

Result measure_free_fall(const Parameters& settings) {
  const double height = settings.number("height");
  const double duration = settings.number("duration");
  const int halvings = settings.count("halvings");
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  const Vec3 gravity(0.0, -9.81, 0.0);
  const double truth = height + 0.5 * gravity.y() * duration * duration;

  // A step has the same form in all three; the rotation is at rest.
  const auto error_of = [&](const auto& step_once, int steps) {
    BodyState state = make_state(body, Vec3(0.0, height, 0.0));
    for (int k = 0; k < steps; ++k) {
      step_once(body, state, gravity, duration / steps, RotationRule::splitting);
    }
    return state.position_w.y() - truth;
  };
  Table table{"",
              {{"step_s", "s", "time step"},
               {"forward_m", "m", "error of the height, forward Euler"},
               {"semi_implicit_m", "m", "error of the height, semi-implicit Euler"},
               {"ballistic_m", "m", "error of the height, flight along the parabola"},
               {"predicted_m", "m", "g duration step / 2"}}};
  double worst = 0.0;
  for (int halving = 0; halving <= halvings; ++halving) {
    const int steps = 4 << halving;
    const double step = duration / steps;
    table.rows.push_back({step, error_of(step_forward_euler, steps),
                          error_of(step_semi_implicit, steps), error_of(fly, steps),
                          -0.5 * gravity.y() * duration * step});
    worst = std::max(worst, std::abs(table.rows.back()[3]));
  }

  const std::vector<double>& coarse = table.rows.front();
  const std::vector<double>& fine = table.rows.back();
  return {{table},
          {{"height with forward Euler at 1/60 of the fall", "m",
            truth + error_of(step_forward_euler, 60)},
           {"height with semi-implicit Euler at 1/60 of the fall", "m",
            truth + error_of(step_semi_implicit, 60)},
           {"order of forward Euler", "-", order_between(coarse[1], fine[1], halvings)},
           {"order of semi-implicit Euler", "-", order_between(coarse[2], fine[2], halvings)},
           {"largest error of flight along the parabola", "m", worst}}};
}

}  // namespace tumble::chapters
