/// \file
/// \brief All solvers of the complementarity problem by answers known by hand, and the exact ones compared.
#include "tumble/lcp_solvers/lcp.hpp"

#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/enumerate.hpp"
#include "tumble/lcp_solvers/lemke.hpp"
#include "tumble/math/complementarity.hpp"
#include "tumble/math/enumeration.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "lcp_solvers/siconos_problems.hpp"
#include "support/allocation_counter.hpp"
#include "support/shared_data.hpp"
#include "support/test.hpp"

namespace {

// Some ten roundings of 2e-16 in problems of a few rows with numbers up to 50 (measured: below 1e-14).
constexpr double rounding = 1e-12;

// How far f and a may be off [N], [m/s²], and the residual [-]. What is iterated is as exact as its
// residual, times the condition of small problems (measured: multipliers 2e-11, sweeps 2e-8).
struct Exactness {
  double answer;
  double residual;
};

Exactness exactness_of(std::string_view solver) {
  if (solver == "least_constraint") return {1e-11, 1e-11};
  if (solver == "augmented_lagrangian") return {1e-10, 2e-12};  // as promised, and rounding of A f
  if (solver == "gauss_seidel") return {1e-7, 1e-9};
  return {rounding, rounding};
}

using Names = std::vector<std::string_view>;
const Names all_exact = {"baraff", "lemke", "enumeration"};
const Names any_matrix = {"lemke", "enumeration"};
const Names springs_too = {"baraff", "lemke", "enumeration", "least_constraint",
                           "augmented_lagrangian"};
const Names every = {"baraff",
                     "lemke",
                     "enumeration",
                     "least_constraint",
                     "augmented_lagrangian",
                     "baraff_as_printed",
                     "gauss_seidel",
                     "complementarity"};

// "complementarity" is the solver of math/ that Baraff's method is made of.
LcpResult solved_by(std::string_view name, const LcpProblem& problem) {
  LcpResult result;
  if (name != "complementarity") {
    make_lcp_solver(name)->solve(name == "least_constraint" ? with_factors(problem) : problem,
                                 result);
    return result;
  }
  ComplementaritySolver solver;
  ComplementarityResult found;
  solver.solve(problem.A, problem.b, found);
  const bool solved = found.status == ComplementarityStatus::solved;
  result.status = solved ? LcpStatus::solved : LcpStatus::infeasible;
  result.f = found.f;
  result.a = found.a;
  result.residual = found.residual;
  return result;
}

// f: none where it is not unique
void check_accelerations(const Names& names, const LcpProblem& problem,
                         const std::vector<double>& a, const std::vector<double>& f = {}) {
  for (const std::string_view name : names) {
    INFO(name);
    const LcpResult result = solved_by(name, problem);
    CHECK(result.status == LcpStatus::solved);
    CHECK(result.residual <= exactness_of(name).residual);
    if (f.empty()) CHECK(*std::ranges::min_element(result.f) >= 0.0);
    if (!f.empty()) CHECK(near(result.f, f, exactness_of(name).answer));
    CHECK(near(result.a, a, exactness_of(name).answer));
  }
}

void check(const Names& names, const LcpProblem& problem, const std::vector<double>& f,
           const std::vector<double>& a) {
  check_accelerations(names, problem, a, f);
}

void check_infeasible(const Names& names, const LcpProblem& problem) {
  for (const std::string_view name : names) {
    INFO(name);
    CHECK(solved_by(name, problem).status == LcpStatus::infeasible);
  }
}

VecX vector(const std::vector<double>& values) { return view(values); }

LcpProblem with_equalities(LcpProblem problem, std::vector<char> equality) {
  problem.equality = std::move(equality);
  return problem;
}

}  // namespace

TEST_CASE("Every solver finds the answers that are known by hand", "[exact][lcp][analytic_lcp]") {
  check(every, lcp({2}, {-4}), {2}, {0});
  check(every, lcp({2, 1, 1, 2}, {-5, -6}), {4.0 / 3, 7.0 / 3}, {0, 0});
  check(every, lcp({2, 1, 1, 2}, {1, 0}), {0, 0}, {1, 0});
  check(every, lcp({2, -1, 0, -1, 2, -1, 0, -1, 2}, {-1, 2, -1}), {0.5, 0, 0.5}, {0, 1, 0});
  check(every, lcp({4, 3, 3, 4}, {-1, -4}), {0, 1}, {2, 0});
  check(every, two_contacts(1.0, -1, -2), {0, 2}, {1, 0});
  check(every, stack(5), {49.05, 39.24, 29.43, 19.62, 9.81}, {0, 0, 0, 0, 0});
  // The load beyond the edge, or a torque of 6 N m: the cube begins to tip.
  LcpProblem cube = cube_on_ground(9.81, 0.6, 0);
  check(every, cube, {0, 5.4936, 5.4936, 0}, {2.3544, 0, 0, 2.3544});
  cube.b = vector({8.19, -27.81, -27.81, 8.19});
  check(every, cube, {0, 5.562, 5.562, 0}, {2.628, 0, 0, 2.628});

  const Names by_matrix = {"augmented_lagrangian", "gauss_seidel", "baraff_as_printed"};
  check(by_matrix, lcp({1, 1, 1, 1}, {-1, -2}), {0, 2}, {1, 0});
  check({"augmented_lagrangian"}, without_factors(stack(5)), {49.05, 39.24, 29.43, 19.62, 9.81},
        {0, 0, 0, 0, 0});
  check({"augmented_lagrangian"}, lcp({0, 0, 0, 1}, {3, -2}), {0, 2}, {3, 0});
  // Block pivoting cycles on this one (sets 000, 110, 101).
  check({"baraff", "lemke", "enumeration", "complementarity"},
        lcp({41, 37, -20, 37, 34, -17, -20, -17, 13}, {-3, -1, 2}), {3.0 / 41, 0, 0},
        {0, 37 * 3.0 / 41 - 1, 2 - 20 * 3.0 / 41});
  check(any_matrix, lcp({1, 0, 2, 3, 2, -1, -2, 1, 0}, {-3, 2, -1}), {0, 1, 4}, {5, 0, 0});
  check(any_matrix, lcp({1, 2, 0, 0, 1, 2, 2, 0, 1}, {-1, -1, -1}), {1.0 / 3, 1.0 / 3, 1.0 / 3},
        {0, 0, 0});
  // A particle that slides and comes to rest, in the form of Stewart and Trinkle.
  check(any_matrix,
        lcp({1, 0, 0, 0, 0, 1, -1, 1, 0, -1, 1, 1, 0.3, -1, -1, 0}, {-0.1635, 3, -3, 0}),
        {0.1635, 0, 0.04905, 2.95095}, {0, 5.9019, 0, 0});
  check(any_matrix, lcp({-1}, {1}), {0}, {1});  // f = 1, a = 0 is another solution
}

TEST_CASE("Any of several solutions will do", "[exact][lcp][analytic_lcp]") {
  for (const std::string_view name : any_matrix) {
    const LcpResult result = solved_by(name, lcp({1, 2, 2, 1}, {-1, -1}));
    CHECK(result.status == LcpStatus::solved);
    double nearest = 1.0;
    for (const std::vector<double>& f : {std::vector<double>{1, 0}, {0, 1}, {1.0 / 3, 1.0 / 3}})
      nearest = std::min(nearest, distance(result.f, f));
    CHECK(nearest <= rounding);
  }
}

TEST_CASE("Problems without a solution are called infeasible", "[exact][lcp][analytic_lcp]") {
  check_infeasible(all_exact, lcp({0}, {-1}));
  check_infeasible(all_exact, lcp({1, -1, -1, 1}, {-1, -1}));  // squeezed by two walls
  check_infeasible(all_exact, lcp({2, 0, 0, 0, 1, -1, 0, -1, 1}, {-1, -1, -1}));
  check_infeasible(any_matrix, lcp({-1}, {-1}));
  CHECK(solved_by("baraff", lcp({-1}, {-1})).status == LcpStatus::not_positive_semidefinite);
}

TEST_CASE("The corners of a cube bear its load and the moments of its load with every solver",
          "[exact][lcp][analytic_lcp]") {
  const double w = 9.81;
  for (const auto& [x, z] :
       {std::pair{0.0, 0.0}, {0.2, 0.1}, {0.4, 0.3}, {0.25, -0.25}, {0.5, 0.0}}) {
    INFO("the load at " << x << ", " << z);
    const LcpProblem cube = cube_on_ground(w, x, z);
    check_accelerations(every, cube, {0, 0, 0, 0});
    for (const std::string_view name : every) {
      INFO(name);
      const std::vector<double> f = solved_by(name, cube).f;
      double sum = 0.0;
      double moment_x = 0.0;
      double moment_z = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += f[k];
        moment_x += f[k] * cube_x[k];
        moment_z += f[k] * cube_z[k];
      }
      const double off = exactness_of(name).answer;
      CHECK(std::abs(sum - w) <= off);
      CHECK(std::abs(moment_x - w * x) <= off);
      CHECK(std::abs(moment_z - w * z) <= off);
    }
  }
}

TEST_CASE("Solvers ask for no memory once they have seen a problem as large",
          "[unit][lcp][analytic_lcp]") {
  const LcpProblem large = stack(12);
  LcpProblem lighter = large;
  lighter.b[0] = -5.0;
  const LcpProblem cube = cube_on_ground(9.81, 0.2, 0.1);
  for (const std::string_view name :
       {"baraff", "lemke", "baraff_as_printed", "gauss_seidel", "least_constraint"}) {
    INFO(name);
    const auto solver = make_lcp_solver(name);
    LcpResult result;
    solver->solve(large, result);
    const AllocationCount count;
    solver->solve(lighter, result);
    // Least constraint keeps no memory for a problem of another shape.
    if (name != "least_constraint") solver->solve(cube, result);
    solver->solve(large, result);
    CHECK(count.value() == 0);
  }
}

TEST_CASE("Glue pulls as well as pushes, and axes may be locked", "[exact][lcp][analytic_lcp]") {
  check(springs_too, rising_cube(false), {0, 0, 0, 0}, {9.81, 9.81, 9.81, 9.81});
  check(springs_too, rising_cube(true), {0, 0, -9.81, 0}, {0, 0, 0, 0});
  check({"augmented_lagrangian"}, without_factors(rising_cube(true)), {0, 0, -9.81, 0},
        {0, 0, 0, 0});
  check(springs_too, on_fixed_box(0.0, -9.81), {0, 9.81}, {0, 0});
}

TEST_CASE("Contacts that contradict each other are infeasible", "[exact][lcp][analytic_lcp]") {
  // Two walls that close on a body, and ground that comes up to a box that cannot move.
  check_infeasible(springs_too, two_contacts(-1.0, -1, -1));
  check_infeasible(springs_too, on_fixed_box(-9.81, 0.0));
  check_infeasible({"augmented_lagrangian"}, without_factors(two_contacts(-1.0, -1, -1)));
  // A wall recedes as fast as the other one comes: nothing to do but move.
  check(springs_too, two_contacts(-1.0, 1, -1), {0, 1}, {0, 0});
}

TEST_CASE("An equality holds with a force of either sign", "[exact][lcp][analytic_lcp]") {
  const LcpProblem pull = with_equalities(lcp({2}, {4}), {1});
  check(all_exact, pull, {-2}, {0});
  check(all_exact, with_equalities(lcp({2}, {-4}), {1}), {2}, {0});
  // Row 0 is glue that has to pull; what it pulls at makes contact 1 push.
  check(all_exact, with_equalities(lcp({2, 1, 1, 2}, {4, 0}), {1, 0}), {-8.0 / 3, 4.0 / 3}, {0, 0});
  // All rows are equalities: a system of linear equations.
  check(all_exact, with_equalities(lcp({2, 1, 1, 2}, {-5, 6}), {1, 1}), {16.0 / 3, -17.0 / 3},
        {0, 0});
  // Flags that are all 0 change nothing.
  check(all_exact, with_equalities(lcp({2}, {4}), {0}), {0}, {4});
}

TEST_CASE("Equalities may depend on each other, but must not contradict each other",
          "[exact][lcp][analytic_lcp]") {
  check_accelerations(all_exact, with_equalities(lcp({1, 1, 1, 1}, {-1, -1}), {1, 1}), {0, 0});
  check_infeasible(all_exact, with_equalities(lcp({1, 1, 1, 1}, {-1, -2}), {1, 1}));
  check_infeasible(all_exact, with_equalities(lcp({0}, {1}), {1}));
  check(all_exact, with_equalities(lcp({0}, {0}), {1}), {0}, {0});
}

TEST_CASE("Without rows there is nothing to solve with any solver", "[unit][lcp][analytic_lcp]") {
  for (const LcpRecipe& recipe : lcp_solvers()) {
    INFO(recipe.name);
    LcpResult result{.f = {1.0}, .a = {1.0}, .pushing = {3}};
    recipe.make()->solve({MatX(0, 0), VecX(0), {}}, result);
    CHECK(result.status == LcpStatus::solved);
    CHECK(result.f.empty());
    CHECK(result.a.empty());
    CHECK(result.pushing.empty());
    CHECK(result.residual == 0.0);
    CHECK(result.pivots <= 1);  // trying everything tries the one case
  }
}

TEST_CASE("The residual is 0 at a solution and shows each way of being wrong",
          "[exact][lcp][analytic_lcp]") {
  const LcpProblem problem = lcp({4, 0, 0, 4}, {-8, 2});
  CHECK(lcp_residual(problem, std::vector<double>{2, 0}) == 0.0);
  CHECK(lcp_residual(problem, std::vector<double>{1, 0}) == 0.5);      // a_0 = -4 sinks
  CHECK(lcp_residual(problem, std::vector<double>{3, 0}) == 0.5);      // a_0 = 4 though it pushes
  CHECK(lcp_residual(problem, std::vector<double>{2, -0.5}) == 0.25);  // pulls
  CHECK(lcp_residual(with_equalities(problem, {0, 1}), std::vector<double>{2, -0.5}) == 0.0);
  CHECK(lcp_residual(with_equalities(problem, {0, 1}), std::vector<double>{2, 0}) == 0.25);
  // Without b nothing is divided by.
  CHECK(lcp_residual(lcp({4}, {0}), std::vector<double>{2}) == 8.0);
  // A row of friction has a diagonal of 0, and is not right for that.
  CHECK(lcp_residual(lcp({0, 2, 0, 1}, {1, 0}), std::vector<double>{1, 0}) == 1.0);
  CHECK(lcp_residual(lcp({-1}, {1}), std::vector<double>{1}) == 0.0);
  CHECK(std::isnan(lcp_residual(problem, std::vector<double>{kNan, 0})));
  CHECK_THROWS_WITH(lcp_residual(problem, std::vector<double>{1}),
                    Contains("f has 1 entries: give 2"));
}

TEST_CASE("Every solver refuses what is no problem, and says where", "[unit][lcp][analytic_lcp]") {
  for (const LcpRecipe& recipe : lcp_solvers()) {
    INFO(recipe.name);
    const std::unique_ptr<LcpSolver> solver = recipe.make();
    LcpProblem good = lcp({2, 1, 1, 2}, {-5, -6});
    good.factors.bodies.push_back({Vec3::Ones(), Mat3::Identity()});  // least_constraint wants them
    good.factors.rows.assign(2, {-1, 0});
    good.factors.rows[0].linear_second_w = Vec3(1, 1, 0);
    good.factors.rows[1].linear_second_w = Vec3(1, 0, 1);
    LcpResult result;
    LcpProblem bad = good;
    bad.b = vector({1});
    CHECK_THROWS_WITH(solver->solve(bad, result),
                      Contains("A is 2 by 2") && Contains("give 1 by 1"));
    bad = good;
    bad.A = MatX::Zero(2, 3);
    CHECK_THROWS_AS(solver->solve(bad, result), std::invalid_argument);
    bad = with_equalities(good, {0});
    CHECK_THROWS_WITH(solver->solve(bad, result),
                      Contains("equality has 1 entries: give none or 2"));
    bad = good;
    bad.A(1, 0) = kNan;
    CHECK_THROWS_WITH(solver->solve(bad, result), Contains("A(1, 0)") && Contains("nan"));
    bad = good;
    bad.b[1] = kInfinity;
    CHECK_THROWS_WITH(solver->solve(bad, result), Contains("b[1]") && Contains("inf"));
    const std::vector<int> outside = {2};
    const std::vector<int> below = {-1};
    const std::vector<int> twice = {1, 0, 1};
    CHECK_THROWS_WITH(solver->solve(good, result, outside), Contains("start[0] = 2"));
    CHECK_THROWS_WITH(solver->solve(good, result, below), Contains("start[0] = -1"));
    CHECK_THROWS_WITH(solver->solve(good, result, twice), Contains("row 1 twice"));
    // A mistake leaves the solver as good as before.
    solver->solve(good, result);
    CHECK(result.residual <= 1e-6);
  }
}

TEST_CASE("What a solver needs of the matrix is checked", "[unit][lcp][analytic_lcp]") {
  const LcpProblem problem = lcp({1, 2, 0, 1}, {-1, -1});
  CHECK_NOTHROW(require_valid(problem, LcpMatrix::any));
  CHECK_NOTHROW(require_valid(problem, LcpMatrix::positive_diagonal));
  CHECK_THROWS_WITH(require_valid(problem, LcpMatrix::symmetric_semidefinite),
                    Contains("A(0, 1) = 2 but A(1, 0) = 0: give a symmetric matrix"));
  CHECK_THROWS_AS(solved_by("baraff", problem), std::invalid_argument);
  CHECK_NOTHROW(require_valid(lcp({0, 1, 1, 0}, {1, 1}), LcpMatrix::symmetric_semidefinite));
  CHECK_THROWS_WITH(require_valid(lcp({1, 0, 0, 0}, {1, 1}), LcpMatrix::positive_diagonal),
                    Contains("A(1, 1)"));
  const int n = enumeration_limit + 1;
  CHECK_THROWS_WITH(solved_by("enumeration", {MatX::Identity(n, n), VecX::Ones(n), {}}),
                    Contains("n = 9"));
  CHECK_THROWS_WITH(
      solved_by("enumeration", {MatX::Identity(5, 5), VecX::Ones(5), {1, 1, 1, 1, 0}}),
      Contains("n = 5 with 4 equalities"));
}

TEST_CASE("Solvers are found by name, and statuses have one each", "[unit][lcp][analytic_lcp]") {
  std::set<std::string_view> names;
  for (const LcpRecipe& recipe : lcp_solvers()) {
    CHECK(recipe.make()->name() == recipe.name);
    CHECK(make_lcp_solver(recipe.name)->name() == recipe.name);
    CHECK_FALSE(recipe.section.empty());
    CHECK_FALSE(recipe.summary.empty());
    names.insert(recipe.name);
  }
  CHECK(names.size() == lcp_solvers().size());
  CHECK_THROWS_WITH(make_lcp_solver("lemk"), Contains("lemk") && Contains("did you mean lemke?"));
  CHECK(name_of(LcpStatus::solved) == "solved");
  CHECK(name_of(LcpStatus::infeasible) == "infeasible");
  CHECK(name_of(LcpStatus::not_positive_semidefinite) == "not_positive_semidefinite");
  CHECK(name_of(LcpStatus::singular) == "singular");
  CHECK(name_of(LcpStatus::cycling) == "cycling");
  CHECK(name_of(LcpStatus::cap_reached) == "cap_reached");
  CHECK(name_of(LcpStatus::least_violation) == "least_violation");
  CHECK(name_of(LcpStatus::ray) == "ray");
  CHECK_THROWS_WITH(name_of(static_cast<LcpStatus>(99)), Contains("99"));
}

TEST_CASE("A start costs or saves pivots and changes no acceleration",
          "[unit][lcp][analytic_lcp]") {
  const LcpProblem problem = with_equalities(
      lcp({4, 1, -2, 1, 1, 4, 1, -2, -2, 1, 4, 1, 1, -2, 1, 4}, {3, -9, -5, -9}), {1, 0, 0, 0});
  const LcpResult want = solved_by("enumeration", problem);
  for (const std::string_view name : {"baraff", "lemke"}) {
    INFO(name);
    const auto solver = make_lcp_solver(name);
    for (const std::vector<int>& start : {std::vector<int>{}, {3, 0}, {0, 1, 2, 3}, {2}}) {
      LcpResult result;
      solver->solve(problem, result, start);
      CHECK(result.status == LcpStatus::solved);
      CHECK(distance(result.a, want.a) <= 9.0 * rounding);
    }
    LcpResult result;
    solver->solve(problem, result);
    CHECK(result.multiplications > 0);
    const int cold = result.pivots;
    solver->solve(problem, result, result.pushing);
    CHECK(result.status == LcpStatus::solved);
    CHECK(result.pivots <= cold);
  }
}

// --- problems that others collected -----------------------------------------------------------

TEST_CASE("Lemke's method solves the problems of Siconos, and Baraff's those of contacts",
          "[exact][lcp][analytic_lcp]") {
  const auto folder = shared_data("siconos-lcp");
  if (!folder) return;
  for (const SiconosProblem& one : siconos_problems(*folder)) {
    INFO(one.name);
    if (!one.semidefinite) CHECK_THROWS_AS(solved_by("baraff", one.problem), std::invalid_argument);
    Names names = {"lemke"};
    if (one.semidefinite) names.push_back("baraff");
    if (one.problem.size() <= enumeration_limit) names.push_back("enumeration");
    for (const std::string_view name : names) {
      INFO(name);
      const LcpResult result = solved_by(name, one.problem);
      CHECK(result.status == (one.solvable ? LcpStatus::solved : LcpStatus::infeasible));
      if (result.status != LcpStatus::solved) continue;
      CHECK(result.residual <= rounding);  // measured: 2e-13 (lcp_tobenna), others 8e-16
      double nearest = one.solutions.empty() ? 0.0 : 1.0;
      for (const std::vector<double>& f : one.solutions)
        nearest = std::min(nearest, distance(result.f, f));
      CHECK(nearest <= 100.0 * rounding);  // the largest force is 92
    }
  }
}
