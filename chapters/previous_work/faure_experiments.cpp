/// \file
/// \brief Accuracy of Faure's iteration against its work (thesis 2.6.4).
///
/// The problems are those of pyramid_problem(). The error of an answer is that of the motion: the distance of f from an
/// exact answer in the norm of A, over that of no forces at all. It does not depend on which of many exact
/// answers is taken.
#include "tumble/lcp_solvers/gauss_seidel.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"
#include "tumble/previous_work/faure_solver.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/pyramid_problem.hpp"

namespace tumble::chapters {
namespace {

constexpr double kUsable = 0.01;     // [-] the error that is asked for
constexpr int kMostSteps = 1 << 16;  // until then it has to be reached
constexpr std::array<int, 15> kShown = {0, 1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200};

// f·(A f/2 + b)
double energy_of_forces(const LcpProblem& problem, std::span<const double> f) {
  double sum = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    double a = 0.0;
    for (int k = 0; k < problem.size(); ++k) a += problem.A(i, k) * f[idx(k)];
    sum += f[idx(i)] * (0.5 * a + problem.b[i]);
  }
  return sum;
}

// A problem with its exact answer.
struct Judged {
  LcpProblem problem;
  double least = 0.0;   // energy of the answer
  double direct = 0.0;  // multiplications of the direct solver

  Judged(int n, double noise) : problem(pyramid_problem(n, noise, 1).problem) {
    LcpResult result;
    for (const LcpRecipe& recipe : lcp_solvers())
      if (recipe.name == "baraff") recipe.make()->solve(problem, result);
    if (!result.solved_within(tolerance::usable_residual))
      throw std::runtime_error("the direct solver has no answer to a pyramid of this figure");
    least = energy_of_forces(problem, result.f);
    direct = static_cast<double>(result.multiplications);
  }
  [[nodiscard]] double error(std::span<const double> f) const {
    return std::sqrt(std::max(0.0, energy_of_forces(problem, f) / -least + 1.0));
  }
};

// Error and work after some steps of an iteration.
struct Reached {
  double error = 0.0;
  double multiplications = 0.0;
};

using Iteration = std::function<void(const LcpProblem&, int steps, LcpResult&)>;

void by_faure(const LcpProblem& problem, int steps, LcpResult& result) {
  FaureSolver(steps, 0.0).solve(problem, result);
}

void by_sweeps(const LcpProblem& problem, int steps, LcpResult& result) {
  GaussSeidelSolver({.sweeps = steps, .residual = 0.0}).solve(problem, result);
}

Reached reached(const Judged& judged, const Iteration& iteration, int steps) {
  LcpResult result;
  iteration(judged.problem, steps, result);
  return {judged.error(result.f), static_cast<double>(result.multiplications)};
}

// The first step after which the error is small enough; it falls with each.
int steps_to(const Judged& judged, const Iteration& iteration) {
  int high = 1;
  while (!(reached(judged, iteration, high).error <= kUsable)) {
    if (high >= kMostSteps) throw std::runtime_error("an error of one per cent is not reached");
    high *= 2;
  }
  int low = high / 2;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (reached(judged, iteration, middle).error <= kUsable ? high : low) = middle;
  }
  return high;
}

// The geometric mean of work over that of the direct solver.
double mean_ratio(const std::vector<Judged>& problems, const Iteration& iteration) {
  double sum = 0.0;
  for (const Judged& judged : problems)
    sum += elementary::log(reached(judged, iteration, steps_to(judged, iteration)).multiplications /
                           judged.direct);
  return elementary::exp(sum / static_cast<double>(problems.size()));
}

Result measure_faure(const Parameters& settings) {
  const double noise = settings.number("noise");
  std::vector<Judged> problems, at_rest;
  for (const int row : {3, 4, 5, 6}) {
    if (4 * row * row > settings.count("largest")) break;
    problems.emplace_back(4 * row * row, noise);
    at_rest.emplace_back(4 * row * row, 0.0);
  }
  Result result;
  result.add(
      "multiplications of Faure's iteration to an error of one per cent over those of the direct "
      "solver, geometric mean over pyramids",
      "-", mean_ratio(problems, by_faure));
  result.add("the same for Gauss-Seidel", "-", mean_ratio(problems, by_sweeps));
  result.add("the same at rest", "-", mean_ratio(at_rest, by_faure));
  result.add("the same for Gauss-Seidel at rest", "-", mean_ratio(at_rest, by_sweeps));
  result.add("steps to one per cent in the largest pyramid", "-",
             steps_to(problems.back(), by_faure));
  result.add("sweeps to one per cent there", "-", steps_to(problems.back(), by_sweeps));

  Table table{"",
              {{"steps", "-", "of the iteration, or sweeps"},
               {"faure", "-", "error of the motion in the largest pyramid, in motion"},
               {"sweeps", "-", "the same for Gauss-Seidel"},
               {"faure_rest", "-", "the same at rest"},
               {"sweeps_rest", "-", "the same for Gauss-Seidel at rest"}}};
  for (const int steps : kShown)
    table.add(steps, reached(problems.back(), by_faure, steps).error,
              reached(problems.back(), by_sweeps, steps).error,
              reached(at_rest.back(), by_faure, steps).error,
              reached(at_rest.back(), by_sweeps, steps).error);
  result.tables.push_back(table);
  return result;
}

const Registered faure_figure{
    {.name = "claim_2_6_4a_faure",
     .parameters = {number("noise", 0.1, 1e-6, 10.0, "m/s", "velocities of the cubes in motion"),
                    whole("largest", 144, 36, 144, "contacts of the largest pyramid")},
     .quick = {"largest=64"},
     .experiment = measure_faure}};

}  // namespace
}  // namespace tumble::chapters
