/// \file
/// \brief The figure of Baraff's algorithm, step by step (thesis 3.3.1).
#include "driver/experiment.hpp"
#include "lcp_solvers/pivot_trace.hpp"
#include "lcp_solvers/planks.hpp"

namespace tumble::chapters {
namespace {

// What a cell of the picture shows.
double state_of(const TracedStep& step, int contact) {
  if (step.driven == contact) return 1.0;
  switch (step.during[idx(contact)]) {
    case BaraffSet::C: return 2.0;
    case BaraffSet::NC: return 3.0;
    default: return 0.0;
  }
}

Table set_table(const std::vector<TracedStep>& steps, int contacts) {
  Table table{"",
              {{"step", "-", "from 1"},
               {"contact", "-", "from 1"},
               {"state", "-", "0: not looked at, 1: driven, 2: in C, 3: in NC"},
               {"ends", "-",
                "of the contact that ends the step: 1 rests, 2 stops pushing, 3 pushes again"}}};
  double number = 0.0;
  for (const TracedStep& step : steps) {
    ++number;
    for (int i = 0; i < contacts; ++i) {
      const double end = step.ended_by == i ? 1.0 + static_cast<double>(step.end) : 0.0;
      table.add(number, i + 1.0, state_of(step, i), end);
    }
  }
  return table;
}

// Forces and accelerations before the first step and after each one. In between they are linear.
Table path_table(const LcpProblem& problem, const std::vector<TracedStep>& steps) {
  const int n = problem.size();
  Table table{"path", {{"step", "-", "steps done"}}};
  for (int i = 0; i < n; ++i)
    table.columns.push_back({"f" + std::to_string(i + 1) + "_n", "N", "force at this contact"});
  for (int i = 0; i < n; ++i)
    table.columns.push_back(
        {"a" + std::to_string(i + 1) + "_m_s2", "m/s²", "acceleration apart at this contact"});
  table.add(0, std::vector<double>(idx(n), 0.0), problem.b);
  for (const TracedStep& step : steps) table.add(table.rows.size(), step.f, step.a);
  return table;
}

Table body_table(const Planks& planks) {
  Table table{"bodies",
              {{"x_m", "m", "middle, to the right"},
               {"y_m", "m", "middle, up"},
               {"width_m", "m", "of the box"},
               {"height_m", "m", "of the box"},
               {"mass_kg", "kg", "0: fixed"}}};
  for (std::size_t k = 0; k < planks.bodies.size(); ++k) {
    const BodyProperties& body = planks.world.bodies()[k];
    const Vec3& p = planks.bodies[k].position_w;
    table.add(p.x(), p.y(), body.size.x(), body.size.y(), body.movable() ? body.mass : 0.0);
  }
  return table;
}

Table contact_table(const Planks& planks, const LcpResult& result) {
  Table table{"contacts",
              {{"contact", "-", "from 1"},
               {"x_m", "m", "to the right"},
               {"y_m", "m", "up"},
               {"force_n", "N", "in the end"}}};
  for (std::size_t k = 0; k < planks.contacts.size(); ++k) {
    const Vec3& p = planks.contacts[k].points[0].position_w;
    table.add(k + 1, p.x(), p.y(), result.f[k]);
  }
  return table;
}

// The acceleration of the contact that sinks fastest.
double fastest_sinking(std::span<const double> a) {
  return std::max(0.0, -*std::ranges::min_element(a));
}

Result measure_index_sets(const Parameters& settings) {
  const Planks planks = make_planks(settings.number("centre"), settings.number("post"));
  const LcpProblem& lcp = planks.problem.lcp();
  LcpResult result;
  const std::vector<TracedStep> steps = trace_baraff(lcp, result);
  if (result.status != LcpStatus::solved)
    throw std::runtime_error("Baraff's algorithm ended as " + std::string(name_of(result.status)));

  // P4, taken literally: the loop goes on *until* a contact sinks. One does at the start, with f = 0
  // and a = b, so it is not entered.
  return {{set_table(steps, lcp.size()), path_table(lcp, steps), body_table(planks),
           contact_table(planks, result)},
          {{"P4: fastest sinking that is left, loop until a contact sinks", "m/s²",
            fastest_sinking({lcp.b.data(), static_cast<std::size_t>(lcp.size())})},
           {"P4: fastest sinking that is left, loop while a contact sinks", "m/s²",
            fastest_sinking(result.a)}}};
}

const Registered index_sets_figure{
    {.name = "index_sets",
     .parameters = {number("centre", 1.625, 0.5, 2.2, "m", "middle of the upper plank"),
                    number("post", 1.5, 1.05, 2.5, "m", "place of the third post")},
     .experiment = measure_index_sets}};

}  // namespace
}  // namespace tumble::chapters
