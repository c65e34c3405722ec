/// \file
/// \brief Multiplications of contact solvers against the number of contacts (thesis 3.3.1).
///
/// The problems are those of pyramid_problem(), k cubes in the lowest row for 4k² contacts. Each solver
/// does larger ones as long as the next is expected to stay below a limit of multiplications, taken to
/// grow with the cube of the size, as a factorisation does. Counts are the same on every machine.
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/pyramid_problem.hpp"

namespace tumble::chapters {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kLowestRows[] = {2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16};  // cubes
constexpr const char* kFastest = "augmented_lagrangian";

// What a solver did on one problem.
struct Work {
  int n = 0;
  bool solved = false;
  double multiplications = 0.0;
};

// One solver, all sizes that it comes to.
std::vector<Work> work_of(const LcpRecipe& recipe, const Parameters& settings, double noise) {
  std::vector<Work> all;
  const auto seed = static_cast<std::uint64_t>(settings.whole("seed"));
  double expected = 0.0;
  for (const int row : kLowestRows) {
    const int n = 4 * row * row;
    const bool printed = recipe.name == "baraff_as_printed";
    if (n > settings.count(printed ? "largest_printed" : "largest")) break;
    if (!printed && expected > settings.number("limit")) break;
    if (recipe.name == "enumeration") break;  // at most 8 rows
    const auto solver = recipe.make();
    LcpResult result;
    solver->solve(pyramid_problem(n, noise, seed).problem, result);
    // What is as wrong as an engine's sweeps leave it is no answer, whatever the solver says.
    const bool solved =
        result.status == LcpStatus::solved && result.residual <= tolerance::usable_residual;
    const auto multiplications = static_cast<double>(result.multiplications);
    all.push_back({n, solved, multiplications});
    const double growth = (row + (row < 8 ? 1.0 : 2.0)) / row;  // squared, of n
    expected = multiplications * growth * growth * growth * growth * growth * growth;
  }
  return all;
}

// A row for each size: n, the cost of one dense factorisation, and the work of each solver that solved it.
Table table_of(const std::string& suffix, const std::vector<std::vector<Work>>& solvers) {
  Table table{suffix,
              {{"contacts", "-", "rows n of the problem"},
               {"dense", "-", "multiplications of one dense Cholesky factorisation, n^3/6"}}};
  for (const LcpRecipe& recipe : lcp_solvers()) {
    const std::string name(recipe.name);
    table.columns.push_back({name, "-", "multiplications of " + name + ", where it solved it"});
  }
  for (const int row : kLowestRows) {
    const double n = 4.0 * row * row;
    std::vector<double> work_of_each;
    for (const std::vector<Work>& solver : solvers) {
      const auto here = std::find_if(solver.begin(), solver.end(),
                                     [&](const Work& work) { return work.n == 4 * row * row; });
      const bool found = here != solver.end() && here->solved;
      work_of_each.push_back(found ? here->multiplications : kNothing);
    }
    table.add(n, n * n * n / 6.0, work_of_each);
  }
  return table;
}

// What is said about the fastest solver.
void add_quantities(const std::string& which, const std::vector<Work>& fastest,
                    std::vector<Quantity>& quantities) {
  const double n = fastest.back().n;
  quantities.push_back({"work over a dense factorisation, multipliers, largest, " + which, "-",
                        fastest.back().multiplications / (n * n * n / 6.0)});
}

Result measure_work(const Parameters& settings) {
  Result result;
  Table failures{"failed",
                 {{"contacts", "-", "rows n of the problem"},
                  {"multiplications", "-", "until the solver gave up or was wrong"},
                  {"noisy", "-", "1 with random velocities, 0 at rest"},
                  {"solver", "-", "which, from 1, in the order of the other tables' columns"}}};
  for (const double noise : {0.0, settings.number("noise")}) {
    const std::string which = noise > 0.0 ? "noisy" : "rest";
    std::vector<std::vector<Work>> solvers;
    for (const LcpRecipe& recipe : lcp_solvers()) {
      solvers.push_back(work_of(recipe, settings, noise));
      if (recipe.name == kFastest) add_quantities(which, solvers.back(), result.quantities);
    }
    result.tables.push_back(table_of(noise > 0.0 ? "noisy" : "", solvers));
    for (std::size_t k = 0; k < solvers.size(); ++k)
      for (const Work& work : solvers[k])
        if (!work.solved) failures.add(work.n, work.multiplications, noise > 0.0, k + 1);
  }
  result.tables.push_back(failures);
  return result;
}

const Registered lcp_work_figure{
    {.name = "lcp_work",
     .parameters =
         Parameters{}
             .add_number("noise", 0.1, 1e-6, 10.0, "m/s", "velocities of the noisy case")
             .add_whole("seed", 1, 0, 1000000000, "of these velocities")
             .add_number("limit", 5e8, 1e4, 1e12, "-",
                         "multiplications that a solve may be expected to take")
             .add_whole("largest", 1024, 16, 1024, "contacts of the largest problem")
             .add_whole("largest_printed", 256, 16, 1024, "the same for the thesis's form"),
     .quick = {"limit=1e7", "largest=144", "largest_printed=64"},
     .experiment = measure_work}};

}  // namespace
}  // namespace tumble::chapters
