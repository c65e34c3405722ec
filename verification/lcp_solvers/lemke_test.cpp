/// \file
/// \brief Lemke's method: how many pivots, which matrices, what its rays mean.
#include "tumble/lcp_solvers/lemke.hpp"

#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/math/enumeration.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "lcp_solvers/redundant_contacts.hpp"
#include "lcp_solvers/siconos_problems.hpp"
#include "support/dense_solve.hpp"
#include "support/shared_data.hpp"
#include "support/test.hpp"

namespace {

LcpResult solved(const LcpProblem& problem, const LemkeOptions& options = {}) {
  return solved_with<LemkeSolver>(problem, options);
}

// Murty's matrix: 1 on the diagonal, 2 below it.
LcpProblem murty(int n) {
  LcpProblem problem{MatX::Identity(n, n), VecX::Constant(n, -1.0), {}};
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < n; ++i) problem.A(i, j) = 2.0;
  return problem;
}

bool is_first_unit_vector(const std::vector<double>& f) {
  double others = 0.0;
  for (std::size_t i = 1; i < f.size(); ++i) others += std::abs(f[i]);
  return f[0] == 1.0 && others == 0.0;
}

double whole(Random& random, std::uint32_t range) {
  return static_cast<double>(random.below(2 * range + 1)) - static_cast<double>(range);
}

}  // namespace

// --- how many pivots --------------------------------------------------------------------------------

TEST_CASE("Murty's problems take Lemke's method 2^n pivots, that of the lift included",
          "[exact][lcp][analytic_lcp]") {
  // A pivot is an exchange of two unknowns: the lift comes in with the first and goes with the last.
  for (int n = 1; n <= 12; ++n) {
    INFO(n);
    LcpProblem problem = murty(n);
    const LcpResult ties = solved(problem);
    CHECK(ties.status == LcpStatus::solved);
    CHECK(ties.pivots == 1 << n);
    CHECK(is_first_unit_vector(ties.f));

    // The same without ties: b_i = -(2^n + 2^(n-1) + ... + 2^(n-i)).
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
      sum += std::ldexp(1.0, n - i);
      problem.b[i] = -sum;
    }
    CHECK(solved(problem).status == LcpStatus::solved);
    CHECK(solved(problem).pivots == 1 << n);
  }
}

TEST_CASE("Fathi's symmetric problems take 2^n pivots too, and Baraff's method one",
          "[exact][lcp][analytic_lcp]") {
  for (int n = 1; n <= 8; ++n) {
    LcpProblem problem{MatX(n, n), VecX::Constant(n, -1.0), {}};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        problem.A(i, j) = 4.0 * std::min(i, j) + 1.0 + (i == j ? 0.0 : 1.0);
    const LcpResult result = solved(problem);
    CHECK(result.status == LcpStatus::solved);
    CHECK(result.pivots == 1 << n);
    CHECK(is_first_unit_vector(result.f));
    LcpResult baraff;
    BaraffSolver().solve(problem, baraff);
    CHECK(baraff.pivots == 1);
  }
}

TEST_CASE("The cap of pivots ends the path with the state reached", "[unit][lcp][analytic_lcp]") {
  const LcpProblem problem = murty(8);
  const LcpResult capped = solved(problem, {255});
  CHECK(capped.status == LcpStatus::cap_reached);
  CHECK(capped.pivots == 255);
  CHECK(capped.f.size() == 8);
  CHECK(solved(problem, {256}).status == LcpStatus::solved);
  CHECK(solved(problem, {0}).status == LcpStatus::cap_reached);
  CHECK(solved(lcp({1}, {1}), {0}).status == LcpStatus::solved);  // needs none
  CHECK_THROWS_WITH(LemkeSolver({-1}), Contains("pivot_cap = -1"));
}

// --- ties -----------------------------------------------------------------------------------------

TEST_CASE("A problem full of ties takes the path of exact arithmetic",
          "[exact][lcp][analytic_lcp]") {
  // 40 rows, most of b equal; with fractions of whole numbers the path has 127 pivots. Once rounding
  // breaks a tie the wrong way it runs in circles.
  const auto folder = shared_data("siconos-lcp");
  if (!folder) return;
  const LcpResult result = solved(read_siconos(*folder / "lcp_tobenna.dat"));
  CHECK(result.status == LcpStatus::solved);
  CHECK(result.pivots == 127);
  CHECK(result.residual <= 1e-12);  // forces of 1 and factors of 250: measured 2e-13
}

// --- which matrices -------------------------------------------------------------------------------

TEST_CASE(
    "For positive semidefinite matrices without symmetry a ray means that there is no solution",
    "[unit][lcp][analytic_lcp]") {
  // A = J Jᵀ + K - Kᵀ is copositive-plus. Whole numbers, so that rows depend and tie.
  Random random(6);
  LemkeSolver solver;
  LcpResult result;
  int counts[2] = {};
  int wrong = 0;
  double worst = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const int n = 1 + static_cast<int>(random.below(5));
    MatX J(n, 2);
    MatX K(n, n);
    LcpProblem problem{MatX(n, n), VecX(n), {}};
    for (int i = 0; i < n; ++i) {
      problem.b[i] = whole(random, 3);
      for (int j = 0; j < 2; ++j) J(i, j) = whole(random, 2);
      for (int j = 0; j < n; ++j) K(i, j) = whole(random, 1);
    }
    problem.A = product(J, J.transpose()) + K - K.transpose();
    solver.solve(problem, result);
    const bool solvable =
        solve_by_enumeration(problem.A, problem.b).status == ComplementarityStatus::solved;
    ++counts[solvable ? 0 : 1];
    if (result.status != (solvable ? LcpStatus::solved : LcpStatus::infeasible)) ++wrong;
    if (solvable) worst = std::max(worst, result.residual);
  }
  CHECK(wrong == 0);
  CHECK(worst <= 1e-12);  // measured 2e-14
  CHECK(counts[0] > 500);
  CHECK(counts[1] > 100);
}

TEST_CASE("Contacts with friction are solved from any velocities", "[unit][lcp][analytic_lcp]") {
  // The velocity form of Anitescu and Potra: one rod-like body in the plane, up to three contacts,
  // each with an impulse c >= 0 along the normal, two along the tangents and one unknown that is 0
  // where it sticks. Copositive for any friction, and b is such that no ray can occur.
  Random random(8);
  LemkeSolver solver;
  LcpResult result;
  int unsolved = 0;
  double worst = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const int contacts = 1 + static_cast<int>(random.below(3));
    const double inverse_inertia = random.uniform(1.0, 12.0);
    const double friction = random.uniform(0.0, 3.0);
    Vec3 velocity = random.in_cube(3.0);
    MatX G(3 * contacts, 3);  // rows: how normal and tangents see vx, vy, omega
    for (int c = 0; c < contacts; ++c) {
      const Vec3 arm = random.in_cube(1.0);
      G.row(c) << 0.0, 1.0, arm.x();
      G.row(contacts + 2 * c) << 1.0, 0.0, -arm.y();
      G.row(contacts + 2 * c + 1) = -G.row(contacts + 2 * c);
    }
    const Vec3 W(1.0, 1.0, inverse_inertia);
    const int n = 4 * contacts;
    LcpProblem problem{MatX::Zero(n, n), VecX::Zero(n), {}};
    problem.A.topLeftCorner(3 * contacts, 3 * contacts) =
        product(G * W.asDiagonal(), G.transpose());
    problem.b.head(3 * contacts) = G.lazyProduct(velocity);
    for (int c = 0; c < contacts; ++c) {
      const int slip = 3 * contacts + c;
      problem.A(slip, c) = friction;
      for (const int tangent : {contacts + 2 * c, contacts + 2 * c + 1}) {
        problem.A(tangent, slip) = 1.0;
        problem.A(slip, tangent) = -1.0;
      }
    }
    solver.solve(problem, result);
    if (result.status != LcpStatus::solved) ++unsolved;
    worst = std::max(worst, result.residual);
  }
  CHECK(unsolved == 0);
  CHECK(worst <= 1e-9);  // impulses grow beyond bounds where contacts jam: measured 3e-14
}

// --- equalities -----------------------------------------------------------------------------------

TEST_CASE("Equalities are solved for whatever the matrix", "[exact][lcp][analytic_lcp]") {
  LcpProblem problem = lcp({-1}, {3});
  problem.equality = {1};
  LcpResult result = solved(problem);
  CHECK(result.status == LcpStatus::solved);
  CHECK(result.f[0] == 3.0);
  CHECK(result.pivots == 1);

  // Without a diagonal, the rows have to be exchanged.
  problem = lcp({0, 2, -4, 0}, {6, 8});
  problem.equality = {1, 1};
  result = solved(problem);
  CHECK(result.status == LcpStatus::solved);
  CHECK(near(result.f, {2, -3}, 0.0));

  // Equality 0 has no answer of its own force. As long as contact 1 happens to satisfy it all is
  // well; to move the contact for its sake, here by f = (-1, 2), is beyond the method.
  problem = lcp({0, 1, 1, 1}, {-1, -1});
  problem.equality = {1, 0};
  CHECK(solved(problem).status == LcpStatus::solved);
  problem.b[0] = -2.0;
  CHECK(lcp_residual(problem, std::vector<double>{-1, 2}) == 0.0);
  CHECK(solved(problem).status == LcpStatus::singular);
}

// --- edges ----------------------------------------------------------------------------------------
