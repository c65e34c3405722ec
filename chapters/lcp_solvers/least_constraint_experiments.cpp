/// \file
/// \brief Counted work: least constraint against contact forces.
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/least_constraint.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/redundant_contacts.hpp"

namespace tumble::chapters {
namespace {

double multiplications(LcpSolver& solver, const LcpProblem& problem, LcpResult& result) {
  solver.solve(problem, result);
  if (result.status != LcpStatus::solved)
    throw std::runtime_error(std::string(solver.name()) + ": " +
                             std::string(name_of(result.status)));
  return static_cast<double>(result.multiplications);
}

// Work of both forms by contacts per body (index 0: least) and seed.
struct ChainWork {
  std::vector<std::vector<double>> forces;
  std::vector<std::vector<double>> least_constraint;

  // From how many contacts a body on the second form takes less, for all that were tried; NaN if it
  // does not with the most.
  [[nodiscard]] double crossing(int fewest, int left_out) const {
    int from = static_cast<int>(forces.size());
    while (from > 0 && sum_without(least_constraint[idx(from - 1)], left_out) <
                           sum_without(forces[idx(from - 1)], left_out))
      --from;
    return from == static_cast<int>(forces.size()) ? std::numeric_limits<double>::quiet_NaN()
                                                   : fewest + from;
  }
};

ChainWork measure_chains(int boxes, int fewest, int most, int seeds) {
  BaraffSolver baraff;
  LeastConstraintSolver least_constraint;
  LcpResult result;
  ChainWork work;
  for (int contacts = fewest; contacts <= most; ++contacts) {
    work.forces.emplace_back();
    work.least_constraint.emplace_back();
    for (int seed = 1; seed <= seeds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const LcpProblem problem = contact_chain(random, boxes, contacts);
      work.forces.back().push_back(multiplications(baraff, problem, result));
      work.least_constraint.back().push_back(multiplications(least_constraint, problem, result));
    }
  }
  return work;
}

Result measure_least_constraint(const Parameters& settings) {
  constexpr int fewest = 2;
  constexpr std::array<int, 3> boxes = {1, 4, 10};
  const int seeds = settings.count("seeds");
  const int most = settings.count("most");
  std::array<ChainWork, 3> work;
  for (std::size_t k = 0; k < boxes.size(); ++k)
    work[k] = measure_chains(boxes[k], fewest, most, seeds);

  Table table{"",
              {{"contacts", "-", "contacts on a box with the one before"},
               {"forces_1", "-", "contact forces, one box: multiplications, mean over the seeds"},
               {"least_1", "-", "least constraint, the same"},
               {"forces_4", "-", "contact forces, four boxes"},
               {"least_4", "-", "least constraint, the same"},
               {"forces_10", "-", "contact forces, ten boxes"},
               {"least_10", "-", "least constraint, the same"}}};
  for (std::size_t i = 0; i < work[0].forces.size(); ++i) {
    std::vector<double> row;
    for (const ChainWork& one : work) {
      row.push_back(sum_without(one.forces[i], -1) / seeds);
      row.push_back(sum_without(one.least_constraint[i], -1) / seeds);
    }
    table.add(idx(fewest) + i, row);
  }

  const auto crossing = [&](std::size_t k, const char* name) {
    return over_seeds(name, "-", seeds,
                      [&, k](int left_out) { return work[k].crossing(fewest, left_out); });
  };
  return {{table},
          {crossing(2,
                    "contacts per body from which least constraint takes fewer multiplications "
                    "than contact forces do"),
           crossing(1, "the same for four boxes")}};
}

const Registered claim_2_6_2a_least_constraint_figure{
    {.name = "claim_2_6_2a_least_constraint",
     .parameters = {whole("most", 24, 8, 64, "contacts on a box with the one before, at most"),
                    whole("seeds", 20, 2, 1000, "random chains for each number of contacts")},
     .quick = {"most=16", "seeds=3"},
     .experiment = measure_least_constraint}};

}  // namespace
}  // namespace tumble::chapters
