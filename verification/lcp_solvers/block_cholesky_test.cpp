/// \file
/// \brief The sparse factor of 6×6 blocks against the equations that it solves.
#include "tumble/lcp_solvers/block_cholesky.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double softness = 1e-3;

// What is left of r by (εI + Σ g g') x, over the size of r.
double left_over(const BlockRows& rows, const std::vector<char>& in_set, const std::vector<Vec6>& x,
                 const std::vector<Vec6>& r) {
  std::vector<double> forces(in_set.size());
  rows.project(x, forces);
  for (std::size_t i = 0; i < in_set.size(); ++i) forces[i] *= in_set[i];
  std::vector<Vec6> product(x.size());
  rows.gather(forces, product);
  double worst = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    worst = std::max(worst, (product[k] + softness * x[k] - r[k]).cwiseAbs().maxCoeff());
    size = std::max(size, r[k].cwiseAbs().maxCoeff());
  }
  return worst / size;
}

}  // namespace

TEST_CASE("The sparse factor solves its equations for any pile and any set of rows",
          "[unit][lcp][analytic_lcp]") {
  Random random(5);
  BlockRows rows;
  BlockCholesky cholesky;
  double worst = 0.0;
  for (int round = 0; round < 300; ++round) {
    LcpProblem problem = random_contacts(random, 20, 60, round % 2 == 0);
    if (round % 10 == 0) problem.factors = {};
    REQUIRE(rows.take(problem));
    cholesky.analyse(rows);
    std::vector<char> in_set;
    for (int i = 0; i < problem.size(); ++i) in_set.push_back(random.below(4) != 0 ? 1 : 0);
    std::vector<Vec6> r(static_cast<std::size_t>(rows.blocks()));
    for (Vec6& part : r) {
      part.head<3>() = random.in_cube(1.0);
      part.tail<3>() = random.in_cube(1.0);
    }
    cholesky.factor(rows, in_set, softness);
    std::vector<Vec6> x = r;
    cholesky.solve(x);
    worst = std::max(worst, left_over(rows, in_set, x, r));
  }
  // [-] Condition numbers up to 1e4, times 2e-16 and a few terms: measured 1.2e-12.
  CHECK(worst <= 1e-11);
}

TEST_CASE("Elimination leaves a chain of bodies as sparse as it was",
          "[exact][lcp][analytic_lcp]") {
  // From the ends inwards each body has one neighbour left: one block below the diagonal.
  BlockRows rows;
  BlockCholesky cholesky;
  for (const int n : {10, 100}) {
    REQUIRE(rows.take(stack(n)));
    cholesky.analyse(rows);
    cholesky.factor(rows, std::vector<char>(static_cast<std::size_t>(n), 1), softness);
    const std::int64_t columns = std::int64_t{n} * 56 + (n - 1) * std::int64_t{126 + 216};
    const std::int64_t products = 36 + (n - 1) * std::int64_t{108};
    CHECK(cholesky.multiplications() == columns + products);
  }
}

TEST_CASE("Rows are scaled to length 1, and their lengths are roots of the diagonal",
          "[exact][lcp][analytic_lcp]") {
  BlockRows rows;
  LcpProblem problem = cube_on_ground(9.81, 0, 0);
  for (int form = 0; form < 2; ++form) {
    REQUIRE(rows.take(problem));
    CHECK(rows.blocks() == 1);  // rank 3 without factors, one body with them
    std::vector<Vec6> z(1);
    std::vector<double> products(4);
    for (int i = 0; i < 4; ++i) {
      CHECK(std::abs(rows.length(i) - 2.0) <= 1e-15);
      std::vector<double> unit(4, 0.0);
      unit[static_cast<std::size_t>(i)] = 1.0;
      rows.gather(unit, z);
      rows.project(z, products);
      for (int j = 0; j < 4; ++j)  // A_ij / 4; rounding of a few products: measured 2e-16
        CHECK(std::abs(products[static_cast<std::size_t>(j)] - problem.A(i, j) / 4.0) <= 1e-15);
    }
    problem.factors = {};
  }
}
