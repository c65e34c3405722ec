/// \file
/// \brief Nothing is called solved that is not: the judge, second attempts, and problems that contradict
///        themselves a little.
#include "tumble/lcp_solvers/safeguard.hpp"

#include "tumble/base/random.hpp"
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/enumeration.hpp"
#include "tumble/record/matrix_market.hpp"

#include "lcp_solvers/lcp_cases.hpp"
#include "support/catch.hpp"
#include "support/dense_solve.hpp"
#include "support/shared_data.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

LcpResult solved_by(std::string_view name, const LcpProblem& problem) {
  LcpResult result;
  make_lcp_solver(name)->solve(problem, result);
  return result;
}

// Whether a solver is made for a problem.
bool takes(std::string_view name, const LcpProblem& problem) {
  const auto glued = std::count(problem.equality.begin(), problem.equality.end(), 1);
  const bool symmetric = problem.A == problem.A.transpose();
  const bool positive = problem.size() == 0 || problem.A.diagonal().minCoeff() > 0.0;
  if (name == "enumeration") return problem.size() + glued <= enumeration_limit;
  if (name == "gauss_seidel") return positive;
  if (name == "baraff_as_printed") return symmetric && glued == 0;
  return name == "lemke" || symmetric;
}

// [-] The largest error of a, in rows of unit diagonal, over the largest b there.
double error_of(const LcpProblem& problem, const std::vector<double>& got, const VecX& want) {
  double worst = 0.0;
  double scale = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const double unit = problem.A(i, i) > 0.0 ? std::sqrt(problem.A(i, i)) : 1.0;
    const double error = std::abs(got[idx(i)] - want[i]) / unit;
    if (!(error <= worst)) worst = error;
    scale = std::max(scale, std::abs(problem.b[i]) / unit);
  }
  return scale > 0.0 ? worst / scale : worst;
}

// Claims to have solved everything.
class Liar final : public LcpSolver {
 public:
  explicit Liar(std::vector<double> f) : f_(std::move(f)) {}
  [[nodiscard]] std::string_view name() const override { return "baraff_as_printed"; }
  void solve(const LcpProblem& problem, LcpResult& result, std::span<const int>) override {
    result = {};
    result.f = f_;
    complete(problem, result);
  }

 private:
  std::vector<double> f_;
};

}  // namespace

// --- the judge ------------------------------------------------------------------------------------

TEST_CASE("An answer that is not finite, pulls or does not complement is not called solved",
          "[unit][lcp][lcp_solvers]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const LcpProblem problem = lcp({2, 0, 0, 2}, {-4, 2});
  const auto status_of = [&](std::vector<double> f) {
    LcpResult result;
    SafeguardedSolver(std::make_unique<Liar>(std::move(f))).solve(problem, result);
    return result.status;
  };
  CHECK(status_of({2, 0}) == LcpStatus::solved);
  CHECK(status_of({2 + 1e-8, 0}) == LcpStatus::solved);
  for (const double wrong : {nan, infinity, -infinity, 1.0, 3.0, -2.0}) {
    INFO(wrong);
    CHECK(status_of({wrong, 0}) == LcpStatus::singular);
    CHECK(status_of({2, wrong}) == LcpStatus::singular);
  }
}

TEST_CASE("A force below 0 by rounding is 0 in an answer that is called solved",
          "[exact][lcp][lcp_solvers]") {
  const LcpProblem problem = lcp({2, 0, 0, 2}, {-4, 0});
  LcpResult result;
  SafeguardedSolver(std::make_unique<Liar>(std::vector<double>{2.0, -1e-9})).solve(problem, result);
  CHECK(result.status == LcpStatus::solved);
  CHECK(result.f == std::vector<double>{2.0, 0.0});
  CHECK(result.a == std::vector<double>{0.0, 0.0});
}

TEST_CASE("A row in small units is judged in its own units", "[exact][lcp][lcp_solvers]") {
  // The second row is wrong by its whole b, which is a hundred-millionth of the first one's.
  const LcpProblem problem = lcp({1, 0, 0, 1e-16}, {-1, -1e-8});
  LcpResult result{.f = {1, 0}};
  complete(problem, result);
  CHECK(result.residual <= 1e-7);
  CHECK_FALSE(holds(problem, result));
  result.f = {1, 1e8};
  complete(problem, result);
  CHECK(holds(problem, result));
}

TEST_CASE("A row that breaks its conditions is not excused by loads that do not reach it",
          "[exact][lcp][lcp_solvers]") {
  // A load that nothing can carry beside a huge one; then bodies between two walls, of which a row in
  // a huge unit asks to move on, beside a row that separates.
  const LcpProblem apart = lcp({0, 0, 0, 1}, {-1e-4, -1e23});
  LcpProblem walls = lcp({1, -2, 0x1p47, -2, 4, -0x1p48, 0x1p47, -0x1p48, 0x1p94}, {1, 0, -3});
  const LcpProblem unlike = lcp(
      {0x1p-78, -3 * 0x1p-73, 0x1p-28, 0x1p38, -3 * 0x1p-73, 9 * 0x1p-68, -3 * 0x1p-23, -3 * 0x1p43,
       0x1p-28, -3 * 0x1p-23, 0x1p22, 0x1p88, 0x1p38, -3 * 0x1p43, 0x1p88, 0x1p154},
      {1, 0, -2, -1});
  for (const LcpProblem& problem : {apart, walls, unlike})
    for (const LcpRecipe& recipe : lcp_solvers()) {
      CAPTURE(recipe.name, problem.b[0]);
      if (takes(recipe.name, problem))
        CHECK(solved_by(recipe.name, problem).status != LcpStatus::solved);
    }
  // As loads of known bodies, they may be rounding of the motion that separates.
  LcpResult result;
  result.f = {0, 0, 3 * 0x1p-94};
  complete(walls, result);
  CHECK_FALSE(holds(walls, result));
  walls.factors.rows.resize(3);
  CHECK(holds(walls, result));
}

TEST_CASE("Solvers agree on which problems of entries from 1e-120 to 1e120 have no solution",
          "[unit][lcp][lcp_solvers]") {
  Random random(47);
  int contradictions = 0;
  for (int k = 0; k < 1500; ++k) {
    CAPTURE(k);
    const double decades = k % 3 == 0 ? 12.0 : k % 3 == 1 ? 25.0 : 60.0;
    const bool has_solution = k % 2 == 0;
    const int n = 1 + static_cast<int>(random.unit() * 5);
    const int rank = 1 + static_cast<int>(random.unit() * 5);
    const auto small = [&] { return std::trunc(random.uniform(-3.99, 3.99)); };
    MatX J(n, rank);
    VecX unit(n);
    for (int i = 0; i < n; ++i) {
      unit[i] = std::ldexp(1.0, static_cast<int>(3.32 * random.uniform(-decades, decades)));
      for (int r = 0; r < rank; ++r) J(i, r) = unit[i] * small();
    }
    LcpProblem problem{MatX::Zero(n, n), VecX::Zero(n), {}};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) problem.A(i, j) = J.row(i).dot(J.row(j));
    VecX f = VecX::Zero(n), a = VecX::Zero(n);
    for (int i = 0; i < n; ++i) {
      const double size = 1.0 + std::abs(small());
      (random.unit() < 0.5 ? f[i] : a[i]) = size;
      f[i] /= unit[i];
      a[i] *= unit[i];
      if (!has_solution) problem.b[i] = small();
    }
    if (has_solution)
      for (int i = 0; i < n; ++i) problem.b[i] = a[i] - problem.A.row(i).dot(f);

    bool solved = false, denied = false;
    for (const LcpRecipe& recipe : lcp_solvers()) {
      if (recipe.name == "baraff_as_printed" || !takes(recipe.name, problem)) continue;
      const LcpResult result = solved_by(recipe.name, problem);
      solved = solved || result.status == LcpStatus::solved;
      denied = denied || result.status == LcpStatus::infeasible ||
               result.status == LcpStatus::least_violation;
    }
    if (has_solution) CHECK(solved);
    if (has_solution) CHECK_FALSE(denied);
    contradictions += solved && denied ? 1 : 0;
  }
  CHECK(contradictions == 0);
}

TEST_CASE("A problem whose forces are too large for a number is not called infeasible",
          "[exact][lcp][lcp_solvers]") {
  const LcpProblem problem = lcp({2e-200, 0, 0, 2e-200}, {-1e200, 1e200});  // f = 5e399
  for (const LcpRecipe& recipe : lcp_solvers()) {
    CAPTURE(recipe.name);
    CHECK(solved_by(recipe.name, problem).status == LcpStatus::singular);
  }
}

TEST_CASE("Sweeps that end in numbers that are none are not solved", "[exact][lcp][lcp_solvers]") {
  // The last row comes out finite after one that did not.
  LcpProblem problem = lcp({2, 0, -3, -2, 3, -3, 1, -2, 1}, {-3, -1, 0});
  problem.equality = {0, 1, 0};
  const LcpResult result = solved_by("gauss_seidel", problem);
  CHECK(result.status != LcpStatus::solved);
  for (const double f : result.f) CHECK(std::isfinite(f));
}

// --- matrices for which a ray proves nothing ------------------------------------------------------

TEST_CASE("Games of two players are solved though Lemke's first path ends on a ray",
          "[exact][lcp][lcp_solvers]") {
  // Two strategies each: (1/7, 1/14, 1/7, 1/14) holds 3 f_2 + 8 f_3 = 1 and so on.
  const LcpProblem game = lcp({0, 0, 3, 8, 0, 0, 6, 2, 4, 6, 0, 0, 5, 4, 0, 0}, {-1, -1, -1, -1});
  CHECK(solved_with<LemkeSolver>(game).status == LcpStatus::ray);
  CHECK(solved_by("lemke", game).status == LcpStatus::solved);

  Random random(21);
  int unsolved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int first = 4 + static_cast<int>(random.below(6));
    const int second = 4 + static_cast<int>(random.below(6));
    const int n = first + second;
    LcpProblem problem{MatX::Zero(n, n), VecX::Constant(n, -1.0), {}};
    for (int i = 0; i < first; ++i)
      for (int j = first; j < n; ++j) {
        problem.A(i, j) = random.uniform(0.1, 10.0);
        problem.A(j, i) = random.uniform(0.1, 10.0);
      }
    if (solved_by("lemke", problem).status != LcpStatus::solved) ++unsolved;
  }
  CHECK(unsolved == 0);  // every game has an equilibrium
}

TEST_CASE("A ray is called infeasible only where that is proved", "[exact][lcp][lcp_solvers]") {
  CHECK(solved_by("lemke", lcp({-1}, {-1})).status == LcpStatus::infeasible);  // all cases tried
  const int n = enumeration_limit + 1;
  const LcpProblem many{-MatX::Identity(n, n), VecX::Constant(n, -1.0), {}};
  CHECK(solved_by("lemke", many).status == LcpStatus::ray);
}

// --- problems that contradict themselves a little -------------------------------------------------

TEST_CASE("Problems that are consistent but for a little get small forces from every solver",
          "[exact][lcp][lcp_solvers]") {
  // Two walls squeeze a body by a gap of accelerations; each is violated by half of it, and the wall that the
  // body is pressed against bears its load of 1 N. In units of rows that differ by a million.
  struct Case {
    double gap;
    LcpStatus status;
  };
  for (const Case& c : {Case{1e-10, LcpStatus::solved}, Case{1e-7, LcpStatus::solved},
                        Case{1e-4, LcpStatus::least_violation}, Case{0.5, LcpStatus::infeasible}})
    for (const double unit : {1.0, 1e-3, 1e3}) {
      LcpProblem problem = lcp({1, -1, -1, 1}, {-1, 1 - c.gap});
      problem.A.row(1) *= unit;
      problem.A.col(1) *= unit;
      problem.b[1] *= unit;
      for (const LcpRecipe& recipe : lcp_solvers()) {
        if (recipe.name == "baraff_as_printed") continue;
        INFO(recipe.name << ", gap " << c.gap << ", unit " << unit);
        const LcpResult result = solved_by(recipe.name, problem);
        CHECK(result.status == c.status);
        // Sweeps stop as soon as the largest row is right enough, and forces have grown until then.
        const double allowed = c.gap + (recipe.name == "gauss_seidel" ? 0.02 : 1e-6);
        CHECK(std::abs(result.f[0] - 1.0) <= allowed);
        CHECK(std::abs(result.f[1]) * unit <= allowed);
      }
    }
}

TEST_CASE("Equalities that contradict each other a little share the violation",
          "[exact][lcp][lcp_solvers]") {
  LcpProblem problem = lcp({1, 1, 1, 1}, {-1, -1.00002});
  problem.equality = {1, 1};
  for (const LcpRecipe& recipe : lcp_solvers()) {
    if (recipe.name == "baraff_as_printed") continue;
    INFO(recipe.name);
    const LcpResult result = solved_by(recipe.name, problem);
    CHECK(result.status == LcpStatus::least_violation);
    CHECK(std::abs(result.residual - 1e-5) <= 1e-9);
    CHECK(std::abs(result.f[0] + result.f[1] - 1.00001) <= 1e-9);
    CHECK(std::abs(result.f[0] - result.f[1]) <= 1e-4);
  }
}

TEST_CASE("Every case from outside is solved with forces of one size by all solvers",
          "[reference][lcp][lcp_solvers]") {
  const auto cases = shared_data("../cases");
  if (!cases) return;
  // [-] The largest A_ii f_i in rows of unit diagonal, over max |b| there.
  const auto size_of_forces = [](const LcpProblem& problem, const LcpResult& result) {
    double force = 0.0;
    double load = 0.0;
    for (int i = 0; i < problem.size(); ++i) {
      const double unit = problem.A(i, i) > 0.0 ? std::sqrt(problem.A(i, i)) : 1.0;
      force = std::max(force, unit * std::abs(result.f[idx(i)]));
      load = std::max(load, std::abs(problem.b[i]) / unit);
    }
    return force / load;
  };
  for (const char* name : {"lcp/baraff21_contacts", "lcp/lemke_says_infeasible_10_2_4",
                           "robustness/augmented_lagrangian_cap", "robustness/baraff_residual",
                           "robustness/enumeration_infeasible", "robustness/lemke_singular"}) {
    LcpProblem problem;
    problem.A = read_matrix_market((*cases / (std::string(name) + "_A.mtx")).string());
    problem.b = read_matrix_market((*cases / (std::string(name) + "_b.mtx")).string()).col(0);
    if ((problem.A - problem.A.transpose()).cwiseAbs().maxCoeff() <= 1e-9)
      problem.A = (0.5 * (problem.A + problem.A.transpose())).eval();
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const LcpRecipe& recipe : lcp_solvers()) {
      if (!takes(recipe.name, problem) || recipe.name == "baraff_as_printed") continue;
      INFO(name << ", " << recipe.name);
      const LcpResult result = solved_by(recipe.name, problem);
      if (recipe.name != "gauss_seidel") CHECK(result.status == LcpStatus::solved);
      least = std::min(least, size_of_forces(problem, result));
      most = std::max(most, size_of_forces(problem, result));
    }
    INFO(name << ": forces from " << least << " to " << most);
    CHECK(most <= 20.0 * least);
  }
}

// --- thousands ------------------------------------------------------------------------------------

namespace {

// J Jᵀ of any rank, rows repeated now and then, equalities, and b from an answer that is known.
LcpProblem random_problem(Random& random, bool units, bool glued, VecX& a) {
  const int n = 1 + static_cast<int>(random.below(10));
  const int rank = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
  MatX J(n, rank);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < rank; ++j) J(i, j) = random.uniform(-1.0, 1.0);
  for (int i = 1; i < n; ++i)
    if (random.below(4) == 0) J.row(i) = J.row(i - 1);
  LcpProblem problem{product(J, J.transpose()), VecX(n), {}};
  problem.equality.assign(idx(n), 0);
  VecX f = VecX::Zero(n);
  a = VecX::Zero(n);
  for (int i = 0; i < n; ++i) {
    if (glued && random.below(3) == 0) {
      problem.equality[idx(i)] = 1;
      f[i] = random.uniform(-2.0, 2.0);
    } else if (random.below(2) == 0) {
      f[i] = random.uniform(0.0, 2.0);
    } else if (random.below(2) == 0) {
      a[i] = random.uniform(0.0, 2.0);
    }
  }
  problem.b = a - problem.A.lazyProduct(f);
  for (int i = 0; units && i < n; ++i) {
    const double unit = elementary::pow(10.0, random.uniform(-3.0, 3.0));
    problem.A.row(i) *= unit;
    problem.A.col(i) *= unit;
    problem.b[i] *= unit;
    a[i] *= unit;
  }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < j; ++i) problem.A(i, j) = problem.A(j, i);
  return problem;
}

}  // namespace

TEST_CASE("Of 8000 semidefinite problems in any units no solver calls a wrong answer solved",
          "[unit][lcp][lcp_solvers]") {
  struct Tally {
    int problems = 0;
    int unsolved = 0;
    int wrong = 0;
    double worst = 0.0;
  };
  std::map<std::string, Tally> tallies;
  Random random(31);
  for (int trial = 0; trial < 8000; ++trial) {
    VecX a;
    const LcpProblem problem = random_problem(random, trial % 4 != 0, trial % 2 != 0, a);
    for (const LcpRecipe& recipe : lcp_solvers()) {
      if (!takes(recipe.name, problem)) continue;
      if (recipe.name == "gauss_seidel" && trial % 8 > 1) continue;  // slow
      Tally& tally = tallies[std::string(recipe.name)];
      const LcpResult result = solved_by(recipe.name, problem);
      ++tally.problems;
      if (result.status != LcpStatus::solved) {
        ++tally.unsolved;
        continue;
      }
      const double error = error_of(problem, result.a, a);
      tally.worst = std::max(tally.worst, error);
      // a is good to the root of the residual at worst; others leave much less.
      const bool loose = recipe.name == "gauss_seidel" || recipe.name == "baraff_as_printed";
      if (!(error <= (loose ? 1e-3 : 1e-5)) || !holds(problem, result)) ++tally.wrong;
    }
  }
  CHECK(tallies.size() == lcp_solvers().size());
  for (const auto& [name, tally] : tallies) {
    INFO(name << ": " << tally.problems << " problems, " << tally.unsolved << " unsolved, worst "
              << tally.worst);
    CHECK(tally.wrong == 0);
    if (name == "gauss_seidel" || name == "baraff_as_printed")
      CHECK(tally.unsolved <= tally.problems / 100);
    else
      CHECK(tally.unsolved == 0);
  }
}

TEST_CASE("Baraff's method by itself solves problems whose rows are in units from 1e-3 to 1e3",
          "[unit][lcp][lcp_solvers]") {
  Random random(32);
  BaraffSolver solver;
  LcpResult result;
  int unsolved = 0;
  for (int trial = 0; trial < 8000; ++trial) {
    const int n = 1 + static_cast<int>(random.below(10));
    MatX J(n, 1 + static_cast<int>(random.below(10)));
    for (int i = 0; i < n; ++i) {
      const double unit = elementary::pow(10.0, random.uniform(-3.0, 3.0));
      for (int k = 0; k < J.cols(); ++k) J(i, k) = unit * random.uniform(-1.0, 1.0);
    }
    LcpProblem problem{product(J, J.transpose()), VecX::Zero(n), {}};
    // Forces of one size, whatever the units: the accelerations differ by 1e12.
    VecX f = VecX::Zero(n);
    for (int i = 0; i < n; ++i) {
      f[i] = std::max(0.0, random.uniform(-1.0, 1.0));
      if (f[i] == 0.0) problem.b[i] = random.uniform(0.0, 1.0) * problem.A(i, i);
    }
    problem.b -= problem.A.lazyProduct(f);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < j; ++i) problem.A(i, j) = problem.A(j, i);
    solver.solve(problem, result);
    if (result.status != LcpStatus::solved || !holds(problem, result)) ++unsolved;
  }
  CHECK(unsolved == 0);  // 176 when the largest row decided for all
}
