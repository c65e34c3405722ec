/// \file
/// \brief The complementarity solver against hand-made problems and against trying everything.
#include "tumble/math/complementarity.hpp"

#include "tumble/math/enumeration.hpp"

#include "lcp_solvers/lcp_cases.hpp"
#include "support/dense_solve.hpp"
#include "support/test.hpp"

namespace {

// A residual of 1e-12 is rounding of small well-scaled problems (measured: below 1e-15).
constexpr double rounding = 1e-12;

VecX vector(const std::vector<double>& values) { return view(values); }

MatX square(const std::vector<double>& rows) {
  const auto n = std::lround(std::sqrt(double(rows.size())));
  return view(rows).reshaped(n, n).transpose();
}

ComplementarityResult solved(const MatX& A, const VecX& b) {
  ComplementaritySolver solver;
  ComplementarityResult result;
  solver.solve(A, b, result);
  return result;
}

}  // namespace

TEST_CASE("A matrix that is not positive semidefinite is detected where it shows", "[unit][lcp]") {
  const auto status = ComplementarityStatus::not_positive_semidefinite;
  CHECK(solved(square({-1}), vector({-1})).status == status);
  CHECK(solved(square({0, 1, 1, 0}), vector({-1, -1})).status == status);
  CHECK(solved(square({1, 2, 2, 1}), vector({-1, -1})).status == status);
  // All minors of size 2 are right, the determinant is -0.28: seen while pivoting.
  CHECK(solved(square({1, 0.8, 0.8, 0.8, 1, 0, 0.8, 0, 1}), vector({-1, -1, -4})).status == status);
}

TEST_CASE("A family that takes other methods 2^n pivots takes one here", "[exact][lcp]") {
  const int n = 8;  // Fathi's matrices, the solution is the first unit vector
  MatX A(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) A(i, j) = 4.0 * std::min(i, j) + 1.0 + (i == j ? 0.0 : 1.0);
  const ComplementarityResult result = solved(A, VecX::Constant(n, -1.0));
  CHECK(result.status == ComplementarityStatus::solved);
  CHECK(result.pivots == 1);
  CHECK(near(result.f, {1, 0, 0, 0, 0, 0, 0, 0}, rounding));
}

namespace {

// A = J Jᵀ of low rank with whole numbers, some rows repeated or opposed, and b either in the range of J
// (always solvable) or not (often infeasible).
struct RandomProblem {
  MatX A;
  VecX b;
};

RandomProblem random_problem(Random& random, int largest) {
  const int n = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(largest)));
  const int rank = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
  MatX J(n, rank);
  VecX b(n);
  VecX pull(rank);
  for (int k = 0; k < rank; ++k) pull[k] = static_cast<double>(random.below(9)) - 4.0;
  for (int i = 0; i < n; ++i) {
    const bool repeat = i > 0 && random.below(3) == 0;
    const double sign = random.below(4) == 0 ? -1.0 : 1.0;
    for (int k = 0; k < rank; ++k)
      J(i, k) = repeat ? sign * J(i - 1, k) : static_cast<double>(random.below(7)) - 3.0;
  }
  const bool in_range = random.below(2) == 0;
  for (int i = 0; i < n; ++i)
    b[i] = in_range ? J.row(i).dot(pull) : static_cast<double>(random.below(9)) - 5.0;
  return {test::product(J, J.transpose()), b};
}

struct Tally {
  int solved = 0;
  int infeasible = 0;
  int wrong_status = 0;
  int wrong_a = 0;
  int wrong_residual = 0;
  int wrong_ray = 0;
  int not_warm = 0;
  double worst_a = 0.0;
};

Tally compare_with_enumeration(int cases, int largest, std::uint64_t seed) {
  Random random(seed);
  ComplementaritySolver solver;
  ComplementarityResult result;
  ComplementarityResult again;
  Tally tally;
  for (int i = 0; i < cases; ++i) {
    const RandomProblem problem = random_problem(random, largest);
    solver.solve(problem.A, problem.b, result);
    const ComplementarityResult want = solve_by_enumeration(problem.A, problem.b);
    if (result.status != want.status) {
      ++tally.wrong_status;
      continue;
    }
    const double scale = std::max(problem.b.cwiseAbs().maxCoeff(), 1.0);
    if (result.status == ComplementarityStatus::infeasible) {
      ++tally.infeasible;
      const auto ray = view(result.ray);
      // 1e-9: rounding in the dependence of rows, 1e-12 at most, times forces up to some 100.
      const bool proof = ray.minCoeff() >= -1e-9 && problem.b.dot(ray) < 0.0 &&
                         problem.A.lazyProduct(ray).cwiseAbs().maxCoeff() <= 1e-9;
      if (!proof) ++tally.wrong_ray;
      continue;
    }
    ++tally.solved;
    const double error = (view(result.a) - view(want.a)).cwiseAbs().maxCoeff() / scale;
    tally.worst_a = std::max(tally.worst_a, error);
    if (!(error <= 1e-9)) ++tally.wrong_a;
    if (!(result.residual <= 1e-9) || view(result.f).minCoeff() < 0.0) ++tally.wrong_residual;
    solver.solve(problem.A, problem.b, again, result.pushing);
    if (again.status != ComplementarityStatus::solved || !(again.residual <= 1e-9))
      ++tally.wrong_residual;
    if (again.pivots != 0) ++tally.not_warm;
  }
  return tally;
}

void check_tally(const Tally& tally) {
  INFO("solved " << tally.solved << ", infeasible " << tally.infeasible << ", worst a "
                 << tally.worst_a);
  CHECK(tally.wrong_status == 0);
  CHECK(tally.wrong_a ==
        0);  // 1e-9 of max |b|: measured 5e-12 with 10000 problems, 2e-10 with n up to 8
  CHECK(tally.wrong_residual == 0);
  CHECK(tally.wrong_ray == 0);
  // Forces that are 0 in exact numbers may pull by rounding when solved for in another order.
  CHECK(tally.not_warm * 1000 <= tally.solved);  // measured 4 of 8519
  CHECK(tally.solved > 0);
  CHECK(tally.infeasible > 0);
}

}  // namespace

TEST_CASE("The solver agrees with trying everything on 10000 singular problems", "[unit][lcp]") {
  check_tally(compare_with_enumeration(10000, 5, 1));
}

TEST_CASE("The solver agrees with trying everything up to the largest size", "[unit][lcp][.long]") {
  check_tally(compare_with_enumeration(200000, 6, 2));
  check_tally(compare_with_enumeration(5000, 8, 3));
}

TEST_CASE("Mass ratios of a million do not make a stack infeasible", "[unit][lcp]") {
  // Light cubes at the bottom, each level held at three points instead of one.
  const double g = 9.81;
  const double masses[4] = {1.0, 1e2, 1e4, 1e6};
  MatX J = MatX::Zero(12, 4);
  VecX inverse_root(4);
  for (int level = 0; level < 4; ++level) {
    inverse_root[level] = 1.0 / std::sqrt(masses[level]);
    for (int point = 0; point < 3; ++point) {
      J(3 * level + point, level) = inverse_root[level];
      if (level > 0) J(3 * level + point, level - 1) = -1.0 / std::sqrt(masses[level - 1]);
    }
  }
  VecX b = VecX::Zero(12);
  b.head(3).setConstant(-g);
  const ComplementarityResult result = solved(test::product(J, J.transpose()), b);
  CHECK(result.status == ComplementarityStatus::solved);
  const double ground = result.f[0] + result.f[1] + result.f[2];
  // Relative 1e-8: of 16 digits the mass ratio costs 6 (measured 2e-10).
  CHECK(std::abs(ground / (g * 1010101.0) - 1.0) <= 1e-8);
}

TEST_CASE("A wrong warm start costs pivots but not the answer", "[unit][lcp]") {
  const MatX A = square({2, -1, 0, -1, 2, -1, 0, -1, 2});
  const VecX b = vector({-1, 2, -1});
  ComplementaritySolver solver;
  ComplementarityResult result;
  const std::vector<int> all{2, 1, 0};
  solver.solve(A, b, result, all);
  CHECK(result.status == ComplementarityStatus::solved);
  CHECK(near(result.f, {0.5, 0, 0.5}, rounding));
  CHECK(result.pushing == std::vector<int>{0, 2});
  solver.solve(A, b, result, result.pushing);
  CHECK(result.pivots == 0);
  CHECK(near(result.f, {0.5, 0, 0.5}, rounding));

  // Dependent contacts in the start are left out.
  const std::vector<int> both{0, 1};
  solver.solve(square({1, 1, 1, 1}), vector({-1, -1}), result, both);
  CHECK(result.status == ComplementarityStatus::solved);
  CHECK(near(result.a, {0, 0}, rounding));
}

TEST_CASE("The solver does not mind the unit of force or acceleration", "[unit][lcp]") {
  Random random(5);
  int different = 0;
  for (int i = 0; i < 500; ++i) {
    const RandomProblem problem = random_problem(random, 8);
    const ComplementarityResult one = solved(problem.A, problem.b);
    const ComplementarityResult other = solved(0x1p-40 * problem.A, 0x1p30 * problem.b);
    if (one.status != other.status || one.pushing != other.pushing) ++different;
    for (std::size_t k = 0; k < one.f.size(); ++k)
      if (one.f[k] * 0x1p70 != other.f[k]) ++different;
  }
  CHECK(different == 0);
}

TEST_CASE("Mistakes in a complementarity problem are refused", "[unit][lcp]") {
  ComplementaritySolver solver;
  ComplementarityResult result;
  const MatX A = square({2, 1, 1, 2});
  const VecX b = vector({-1, -1});
  using Wrong = std::invalid_argument;
  CHECK_THROWS_WITH(solver.solve(MatX::Zero(2, 3), b, result), Contains("as many rows as columns"));
  CHECK_THROWS_WITH(solver.solve(A, vector({1}), result), Contains("b: expected"));
  CHECK_THROWS_WITH(solver.solve(A, vector({1, kNan}), result), Contains("finite"));
  CHECK_THROWS_WITH(solver.solve(square({2, kNan, 1, 2}), b, result), Contains("finite"));
  CHECK_THROWS_WITH(solver.solve(square({2, 1, 1.001, 2}), b, result), Contains("symmetric"));
  for (const std::vector<int>& start : {std::vector<int>{-1}, {2}, {0, 0}})
    CHECK_THROWS_WITH(solver.solve(A, b, result, start), Contains("start: expected"));
  CHECK_THROWS_AS(complementarity_residual(A, b, vector({1})), Wrong);
  CHECK_THROWS_AS(complementarity_residual(A, vector({1}), b), Wrong);
  CHECK_THROWS_AS(solve_by_enumeration(MatX::Zero(2, 3), b), Wrong);
  CHECK_THROWS_AS(solve_by_enumeration(A, vector({1})), Wrong);
  CHECK_THROWS_AS(solve_by_enumeration(A, vector({kNan, 1})), Wrong);
  CHECK_THROWS_AS(solve_by_enumeration(MatX::Identity(9, 9), VecX::Zero(9)), Wrong);
}

TEST_CASE("The residual of a wrong answer is what it misses, over max |b|", "[unit][lcp]") {
  // f = (1, 0): a = (2, 1) + (-4, -1) = (-2, 0), min(A f, a) = (-2, 0), and max |b| = 4.
  CHECK(complementarity_residual(square({2, 1, 1, 2}), vector({-4, -1}), vector({1, 0})) == 0.5);
  CHECK(complementarity_residual(square({2}), vector({0}), vector({3})) == 6.0);
}
