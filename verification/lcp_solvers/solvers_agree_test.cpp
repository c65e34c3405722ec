/// \file
/// \brief All solvers on the same contact problems, against each other.
#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/least_constraint.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"
#include "tumble/math/complementarity.hpp"
#include "tumble/math/enumeration.hpp"

#include "lcp_solvers/lcp_cases.hpp"
#include "lcp_solvers/siconos_friction.hpp"
#include "lcp_solvers/siconos_problems.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

using namespace tumble;
using namespace tumble::test;

namespace {

// What forces do to the bodies, W Jᵀ f: unlike f, there is only one answer.
std::vector<double> pushed(const LcpFactors& factors, const std::vector<double>& f) {
  std::vector<double> x(6 * factors.bodies.size(), 0.0);
  const auto add = [&](int body, const Vec3& linear_w, const Vec3& angular_w) {
    if (body < 0) return;
    const LcpFactors::Body& w = factors.bodies[at(body)];
    const Vec3 linear = w.inverse_mass.cwiseProduct(linear_w);
    const Vec3 angular = w.inverse_inertia_w * angular_w;
    for (int k = 0; k < 3; ++k) {
      x[at(6 * body + k)] += linear[k];
      x[at(6 * body + 3 + k)] += angular[k];
    }
  };
  for (std::size_t i = 0; i < f.size(); ++i) {
    const LcpFactors::Row& row = factors.rows[i];
    add(row.first, f[i] * row.linear_first_w, f[i] * row.angular_first_w);
    add(row.second, f[i] * row.linear_second_w, f[i] * row.angular_second_w);
  }
  return x;
}

struct Agreement {
  int problems = 0;      // that the solver takes
  int unsolved = 0;      // of them
  double worst_a = 0.0;  // of max |b|, as the next two
  double worst_push = 0.0;
  double fastest_sinking = 0.0;
};

using Agreements = std::map<std::string, Agreement, std::less<>>;

// Solves a problem by everybody and compares with least constraint, which works on J, not on A.
class Comparison {
 public:
  Comparison() {
    for (const LcpRecipe& recipe : lcp_solvers()) solvers_.push_back(recipe.make());
  }

  void add(const LcpProblem& problem) {
    reference_.solve(problem, want_);
    const std::vector<double> want_push = pushed(problem.factors, want_.f);
    const double scale = scale_of(problem);
    if (want_.status != LcpStatus::solved || !(want_.residual <= 1e-10)) ++unsure;
    for (const auto& solver : solvers_) {
      if (solver->name() == "enumeration" && problem.size() > enumeration_limit) continue;
      Agreement& one = agreements[std::string(solver->name())];
      solver->solve(problem, result_);
      ++one.problems;
      if (result_.status != LcpStatus::solved) {
        ++one.unsolved;
        continue;
      }
      one.worst_a = std::max(one.worst_a, distance(result_.a, want_.a) / scale);
      one.worst_push =
          std::max(one.worst_push, distance(pushed(problem.factors, result_.f), want_push) / scale);
      for (const double a : result_.a) one.fastest_sinking = std::max(one.fastest_sinking, -a);
    }
  }

  Agreements agreements;
  int unsure = 0;

 private:
  std::vector<std::unique_ptr<LcpSolver>> solvers_;
  LeastConstraintSolver reference_;
  LcpResult want_, result_;
};

// A chain of boxes, each touched in `contacts` points in any direction by the one before; the first
// by scenery. Every fifth contact is given twice.
LcpProblem chain(Random& random, int bodies, int contacts) {
  LcpProblem problem;
  const int n = bodies * contacts;
  std::vector<Vec3> linear;
  std::vector<Vec3> angular;
  for (int k = 0; k < bodies; ++k) {
    problem.factors.bodies.push_back({Vec3::Ones(), Vec3::Constant(6.0).asDiagonal()});
    linear.push_back(random.in_cube(10.0));
    angular.push_back(random.in_cube(10.0));
  }
  problem.b.resize(n);
  for (int i = 0; i < n; ++i) {
    LcpFactors::Row row;
    row.second = i / contacts;
    row.first = row.second - 1;
    const Vec3 normal = random.direction();
    row.linear_first_w = -normal;
    row.linear_second_w = normal;
    row.angular_first_w = -random.in_cube(0.5).cross(normal);
    row.angular_second_w = random.in_cube(0.5).cross(normal);
    if (i % 5 == 4) row = problem.factors.rows.back();
    problem.factors.rows.push_back(row);
    problem.b[i] = row.linear_second_w.dot(linear[at(row.second)]) +
                   row.angular_second_w.dot(angular[at(row.second)]);
    if (row.first >= 0)
      problem.b[i] += row.linear_first_w.dot(linear[at(row.first)]) +
                      row.angular_first_w.dot(angular[at(row.first)]);
  }
  multiply_out(problem.factors, problem.A);
  return problem;
}

}  // namespace

TEST_CASE("All exact solvers find one motion in 10000 contact problems with redundant contacts",
          "[unit][lcp][analytic_lcp]") {
  Random random(11);
  Comparison comparison;
  for (int k = 0; k < 10000; ++k)
    comparison.add(random_contacts(random, 3, k % 4 == 0 ? 16 : 8, k % 2 == 0));
  CHECK(comparison.unsure == 0);
  for (const auto& [name, one] : comparison.agreements) {
    INFO(name << ": " << one.problems << " problems, " << one.unsolved << " unsolved, a off by "
              << one.worst_a << ", push by " << one.worst_push << ", sinks "
              << one.fastest_sinking);
    CHECK(one.problems > 0);
    if (name == "gauss_seidel") {
      CHECK(one.unsolved <= 10);      // measured 3: contacts that are nearly parallel
      CHECK(one.worst_a <= 1e-6);     // measured 4e-8
      CHECK(one.worst_push <= 1e-6);  // measured 8e-8
    } else if (name == "baraff_as_printed") {
      CHECK(one.unsolved <= 50);                         // measured 10
      CHECK(one.fastest_sinking <= tolerance::sinking);  // measured 8e-11 m/s²
    } else {
      CHECK(one.unsolved == 0);
      CHECK(one.worst_a <= 1e-9);     // measured 6e-11
      CHECK(one.worst_push <= 1e-9);  // measured 8e-11
    }
  }
}

TEST_CASE("Chains of boxes with a dozen contacts and more on each are solved",
          "[unit][lcp][analytic_lcp]") {
  // On the way to the answer rows depend on each other up to 1e-12 of their lengths: more than A can
  // tell, which holds the squares.
  Random random(12);
  Comparison comparison;
  for (const int bodies : {1, 4})
    for (const int contacts : {12, 16})
      for (int k = 0; k < 20; ++k) comparison.add(chain(random, bodies, contacts));
  CHECK(comparison.unsure == 0);
  for (const std::string_view name : {"baraff", "lemke", "augmented_lagrangian"}) {
    const Agreement& one = comparison.agreements.at(std::string(name));
    INFO(name << ": a off by " << one.worst_a << ", push by " << one.worst_push);
    CHECK(one.unsolved == 0);
    // Of max |b|. Measured 5e-10; the method of multipliers 3e-9, as the smallest changes of gaps take
    // large changes of forces.
    const double limit = name == "augmented_lagrangian" ? 1e-8 : 1e-9;
    CHECK(one.worst_a <= limit);
    CHECK(one.worst_push <= limit);
  }

  // Ten boxes in a row: 35 of 160 problems ended at the cap, and 3 were called infeasible, when a
  // contact was held for sinking or dependent by the size of the numbers alone.
  BaraffSolver baraff;
  ComplementaritySolver on_A_alone;
  LeastConstraintSolver reference;
  LcpResult result;
  LcpResult want;
  ComplementarityResult alone;
  int unsolved = 0;
  int unsolved_alone = 0;
  double worst = 0.0;
  for (const int contacts : {12, 16, 24}) {
    for (int k = 0; k < 4; ++k) {
      const LcpProblem problem = chain(random, 10, contacts);
      baraff.solve(problem, result);
      reference.solve(problem, want);
      on_A_alone.solve(problem.A, problem.b, alone);
      if (result.status != LcpStatus::solved) ++unsolved;
      if (alone.status != ComplementarityStatus::solved) ++unsolved_alone;
      worst = std::max(worst, distance(result.a, want.a) / scale_of(problem));
    }
  }
  INFO("worst " << worst << ", unsolved with A alone " << unsolved_alone);
  CHECK(unsolved == 0);
  CHECK(unsolved_alone <= 1);
  CHECK(worst <= 1e-9);
}

TEST_CASE("A solver that has seen a larger problem gives the bits of a new one",
          "[unit][lcp][analytic_lcp]") {
  Random random(13);
  for (const LcpRecipe& recipe : lcp_solvers()) {
    INFO(recipe.name);
    const auto old = recipe.make();
    int different = 0;
    for (int k = 0; k < 40; ++k) {
      const int rows = k % 2 == 0 ? 8 : 3;
      const LcpProblem problem = random_contacts(random, 2, rows, k % 3 == 0);
      LcpResult one;
      LcpResult other;
      old->solve(problem, one);
      recipe.make()->solve(problem, other);
      if (one.f != other.f || one.a != other.a || one.pivots != other.pivots ||
          one.multiplications != other.multiplications)
        ++different;
    }
    CHECK(different == 0);
  }
}

TEST_CASE("No problem that others published is left out", "[unit][lcp][analytic_lcp]") {
  const auto count = [](const std::filesystem::path& folder) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".dat") ++files;
    return files;
  };
  const auto lcps = shared_data("siconos-lcp");
  const auto frictions = shared_data("siconos-friction");
  if (!lcps || !frictions) return;
  // Three are there twice, once in blocks.
  CHECK(siconos_problems(*lcps).size() + 3 == count(*lcps));
  for (const auto& [name, size] :
       {std::pair{"lcp_deudeu", 2}, std::pair{"lcp_ortiz", 2}, std::pair{"lcp_trivial", 1}}) {
    INFO(name);
    const LcpProblem dense = read_siconos(*lcps / (std::string(name) + ".dat"));
    std::ifstream in(*lcps / (std::string(name) + "_block.dat"));
    CHECK(next<int>(in) == dense.size());
    CHECK(read_matrix(in, size) == dense.A);
    for (int i = 0; i < dense.size(); ++i) CHECK(next<double>(in) == dense.b[i]);
  }
  CHECK(siconos_normal_problems(*frictions).size() == count(*frictions));
}

TEST_CASE("Published friction problems without friction are solved by Baraff, Lemke and by trying",
          "[reference][lcp][analytic_lcp]") {
  const auto folder = shared_data("siconos-friction");
  if (!folder) return;
  for (const NormalProblem& one : siconos_normal_problems(*folder)) {
    for (const std::string_view name : {"baraff", "lemke", "enumeration"}) {
      if (name == "enumeration" && one.problem.size() > enumeration_limit) continue;
      INFO(one.name << ", " << name);
      LcpResult result;
      make_lcp_solver(name)->solve(one.problem, result);
      CHECK(result.status == LcpStatus::solved);
      CHECK(distance(result.a, one.a) <= 1e-11 * scale_of(one.problem));
    }
  }
}
