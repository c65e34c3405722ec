/// \file
/// \brief Painlevé's rod where Coulomb's law has no answer, and its time steps there (thesis 2.6.3).
#include "analytic_lcp/painleve_rod.hpp"

namespace tumble::chapters {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFirst = 20.0;  // [degrees] the map's left edge
constexpr double kLast = 88.0;
constexpr double kMost = 3.0;         // [-] friction at the map's upper edge
constexpr double kStandstill = 1e-9;  // [m/s] slower is rounding, where rods slide with 1 m/s

// What the map shows.
enum class Answers { none, pushes, lifts, two };

Answers answers_of(const PainleveRod& rod) {
  const std::vector<double> forces = possible_forces(rod);
  if (forces.empty()) return Answers::none;
  if (forces.size() == 2) return Answers::two;
  return forces.front() > 0.0 ? Answers::pushes : Answers::lifts;
}

// Counts the solutions in the middles of a grid. Neighbours above each other with the same answer
// are one row of the table.
Table count_answers(const std::string& suffix, double spin, int friction_steps) {
  Table table{suffix,
              {{"from_deg", "deg", "left edge"},
               {"to_deg", "deg", "right edge"},
               {"from_mu", "-", "lower edge"},
               {"to_mu", "-", "upper edge"},
               {"answers", "-", "0: no force; 1: one, it pushes; 2: one, 0: it lifts; 3: two"}}};
  const int angle_steps = static_cast<int>(kLast - kFirst);
  for (int i = 0; i < angle_steps; ++i) {
    const double left = kFirst + i;
    for (int k = 0; k < friction_steps; ++k) {
      const double low = kMost * k / friction_steps;
      const double high = kMost * (k + 1) / friction_steps;
      const auto answers =
          static_cast<double>(answers_of({(left + 0.5) * kDegree, 0.5 * (low + high), spin}));
      if (k == 0 || table.rows.back().back() != answers)
        table.add(left, left + 1.0, low, high, answers);
      table.rows.back()[3] = high;
    }
  }
  return table;
}

// How far an edge between numbers of solutions is from the closed form, at most.
double edge_error(const Table& cells) {
  double worst = 0.0;
  for (const std::vector<double>& cell : cells.rows) {
    if (cell[3] >= kMost) continue;
    worst =
        std::max(worst, std::abs(cell[3] - critical_friction(0.5 * (cell[0] + cell[1]) * kDegree)));
  }
  return worst;
}

Table boundary() {
  Table table{
      "boundary",
      {{"angle_deg", "deg", "of the rod"}, {"mu", "-", "friction at which pushing stops to help"}}};
  for (double angle = kFirst; angle <= kLast; angle += 0.5)
    table.add(angle, critical_friction(angle * kDegree));
  return table;
}

// The lowest point of the boundary, where the tangent of the angle is 2.
Table least(double spin) {
  const double angle = elementary::atan2(2.0, 1.0);
  return {"least",
          {{"angle_deg", "deg", "angle with the least critical friction"},
           {"mu", "-", "that friction"},
           {"spin_rad_s", "rad/s", "of the rods in the map with spin"}},
          {{angle / kDegree, critical_friction(angle), spin}}};
}

RodStep solved_step(const PainleveRod& rod, double step) {
  const RodStep after = step_rod(rod, step, 4);
  if (!after.solved) throw std::runtime_error("a time step was not solved");
  return after;
}

// A time step for rods all over the map.
Table steps_over_map(double step) {
  Table table{"",
              {{"angle_deg", "deg", "of the rod"},
               {"mu", "-", "friction"},
               {"after", "-", "0: the end lifts off, 1: slides on, 2: sticks"}}};
  for (int angle = 24; angle <= 84; angle += 4) {
    for (int k = 0; k < 14; ++k) {
      const double friction = 0.1 + 0.2 * k;
      const RodStep after = solved_step({angle * kDegree, friction, 0.0}, step);
      const double state = after.lift > kStandstill ? 0.0 : -after.slip > kStandstill ? 1.0 : 2.0;
      table.add(1.0 * angle, friction, state);
    }
  }
  return table;
}

// The impulse of one step against its length, for rods at 60 degrees.
Table impulses() {
  Table table{"impulses",
              {{"step_s", "s", "length of the step"},
               {"sliding_n_s", "N s", "impulse away from the ground, friction 1"},
               {"jammed_n_s", "N s", "the same, friction 1.5"}}};
  for (int k = 0; k <= 16; ++k) {
    const double step = 0.1 * elementary::pow(10.0, -0.25 * k);
    const auto impulse = [step](double friction) {
      return solved_step({60.0 * kDegree, friction, 0.0}, step).normal_impulse;
    };
    table.add(step, impulse(1.0), impulse(1.5));
  }
  return table;
}

Result measure_painleve_map(const Parameters& settings) {
  const double spin = settings.number("spin");
  const int friction_steps = settings.count("friction_steps");
  const Table still = count_answers("still", 0.0, friction_steps);
  const Table spinning = count_answers("spinning", spin, friction_steps);
  const Table steps = steps_over_map(settings.number("step"));
  return {{steps, still, spinning, boundary(), least(spin), impulses()},
          {{"largest distance of the map's edge from the closed form", "-", edge_error(still)}}};
}

const Registered painleve_map_figure{
    {.name = "painleve_map",
     .parameters = {number("spin", 5.0, 0.1, 100.0, "rad/s", "of the rods in the second map"),
                    number("step", 1.0 / 60.0, 1e-6, 1.0, "s", "time step of the dots"),
                    whole("friction_steps", 120, 10, 2000, "rows of the grid of either map")},
     .quick = {"friction_steps=30"},
     .experiment = measure_painleve_map}};

}  // namespace
}  // namespace tumble::chapters
