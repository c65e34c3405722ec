/// \file
/// \brief Forces in a pyramid: determined on feet, a range on full faces (thesis 2.6, 3.3.1).
#include "tumble/lcp_solvers/augmented_lagrangian.hpp"
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/gauss_seidel.hpp"
#include "tumble/lcp_solvers/lemke.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/brick_pyramid.hpp"
#include "lcp_solvers/force_range.hpp"

namespace tumble::chapters {
namespace {

LcpResult solved(LcpSolver& solver, const LcpProblem& problem) {
  LcpResult result;
  solver.solve(problem, result);
  if (result.status != LcpStatus::solved)
    throw std::runtime_error(std::string(solver.name()) + " did not solve the pyramid");
  return result;
}

// [bricks' weights] What each pair of faces bears according to forces.
std::vector<double> loads(const BrickPyramid& pyramid, std::span<const double> f) {
  std::vector<double> result;
  for (const Resultant& r : resultants(pyramid, f))
    result.push_back(r.force / weight_of_brick(pyramid));
  return result;
}

// [bricks' weights] The least and largest loads of each pair of faces.
std::vector<ForceInterval> ranges(const BrickPyramid& pyramid) {
  const LcpProblem& lcp = pyramid.problem.lcp();
  const ForceRange forces(lcp.A, lcp.b);
  const double weight = weight_of_brick(pyramid);
  std::vector<ForceInterval> result;
  for (int contact = 0; contact < static_cast<int>(pyramid.contacts.size()); ++contact) {
    std::vector<int> rows;
    for (int i = 0; i < lcp.size(); ++i)
      if (pyramid.problem.rows()[static_cast<std::size_t>(i)].contact == contact) rows.push_back(i);
    const ForceInterval range = forces.of(rows);
    result.push_back({range.least / weight, range.most / weight});
  }
  return result;
}

// [m] The middle of the area in which two bricks touch.
Vec3 middle_of(const Contact& contact) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < contact.count; ++i)
    sum += contact.points[static_cast<std::size_t>(i)].position_w;
  return sum / contact.count;
}

Table brick_table(const BrickPyramid& pyramid) {
  Table table{"bricks",
              {{"x_m", "m", "middle, to the right"},
               {"y_m", "m", "middle, up"},
               {"width_m", "m", "of the brick"},
               {"height_m", "m", "of the brick"}}};
  for (std::size_t k = 1; k < pyramid.bodies.size(); ++k) {
    const Vec3& p = pyramid.bodies[k].position_w;
    const Vec3& size = pyramid.world.bodies()[k].size;
    table.add(p.x(), p.y(), size.x(), size.y());
  }
  return table;
}

Table feet_table(const BrickPyramid& pyramid) {
  Table table{"feet", {{"x_m", "m", "where a foot stands, to the right"}, {"y_m", "m", "up"}}};
  for (const Contact& contact : pyramid.contacts)
    for (int i = 0; i < contact.count; ++i) {
      const Vec3& p = contact.points[static_cast<std::size_t>(i)].position_w;
      table.add(p.x(), p.y());
    }
  return table;
}

Result measure_pyramid_forces(const Parameters& settings) {
  const int rows = settings.count("rows");
  const double spacing = settings.number("spacing");
  BaraffSolver baraff;
  LemkeSolver lemke;
  GaussSeidelSolver gauss_seidel;

  const BrickPyramid feet = make_brick_pyramid(rows, spacing, Stand::feet);
  const std::vector<double> feet_f = solved(baraff, feet.problem.lcp()).f;
  const std::vector<Resultant> on_feet = resultants(feet, feet_f);
  const std::vector<double> feet_loads = loads(feet, feet_f);

  const BrickPyramid full = make_brick_pyramid(rows, spacing, Stand::faces);
  const LcpProblem& lcp = full.problem.lcp();
  const std::vector<ForceInterval> range = ranges(full);
  AugmentedLagrangianSolver multipliers;
  const LcpResult by_baraff = solved(baraff, lcp);
  const LcpResult by_lemke = solved(lemke, lcp);
  const LcpResult by_sweeps = solved(gauss_seidel, lcp);
  const std::vector<std::vector<double>> answers{loads(full, by_baraff.f), loads(full, by_lemke.f),
                                                 loads(full, by_sweeps.f),
                                                 loads(full, solved(multipliers, lcp).f)};

  Table table{"",
              {{"feet_x_m", "m", "on feet: where the force acts"},
               {"feet", "-", "on feet: the force, in bricks' weights"},
               {"x_m", "m", "on faces: middle of the area that touches"},
               {"y_m", "m", "its height"},
               {"least", "-", "on faces: the smallest force, in bricks' weights"},
               {"most", "-", "the largest"},
               {"baraff", "-", "the force that Baraff's method finds"},
               {"lemke", "-", "Lemke's"},
               {"gauss_seidel", "-", "sweeps"},
               {"multipliers", "-", "the method of multipliers, as equal springs share"}}};
  double apart = 0.0;
  double outside = 0.0;
  double on_ground = 0.0;
  for (std::size_t k = 0; k < full.contacts.size(); ++k) {
    const Vec3 middle = middle_of(full.contacts[k]);
    std::vector<double> found;
    for (const std::vector<double>& answer : answers) found.push_back(answer[k]);
    const auto [low, high] = std::minmax_element(found.begin(), found.end());
    apart = std::max(apart, *high - *low);
    outside = std::max({outside, range[k].least - *low, *high - range[k].most});
    if (full.contacts[k].first == 0) on_ground += answers[0][k];
    table.add(on_feet[k].place, feet_loads[k], middle.x(), middle.y(), range[k].least,
              range[k].most, found);
  }

  const ForceInterval top = ranges(make_brick_pyramid(2, spacing, Stand::faces)).back();
  return {
      {table, brick_table(full), feet_table(feet)},
      {{"on faces: load of the lowest row, over the weight of a brick", "-", on_ground},
       {"on faces: how far two answers for a pair of faces are apart, over the weight of a brick",
        "-", apart},
       {"on faces: how far an answer is outside of its bar, over the weight of a brick", "-",
        outside},
       {"two rows on faces: smallest force under an end of the top brick, over its weight", "-",
        top.least}}};
}

const Registered pyramid_forces_figure{
    {.name = "pyramid_forces",
     .parameters = Parameters{}
                       .add_whole("rows", 3, 2, 6, "bricks in the lowest row")
                       .add_number("spacing", 1.05, 1.001, 1.5, "m",
                                   "from brick to brick in a row, 1 m wide"),
     .quick = {"rows=2"},
     .experiment = measure_pyramid_forces}};

}  // namespace
}  // namespace tumble::chapters
