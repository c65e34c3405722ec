/// \file
/// \brief Factors that grow and shrink, against products written out.
#include "tumble/math/dense.hpp"

#include "support/dense_solve.hpp"
#include "support/test.hpp"

using namespace tumble;

TEST_CASE("A product sums the columns from left to right", "[exact][dense]") {
  MatX A(2, 3);
  A << 1e16, 1.0, -1e16, 1.0, 2.0, 3.0;
  const std::vector<double> x{1.0, 1.0, 1.0};
  std::vector<double> y{7.0, 7.0};
  multiply(A, x, y);
  CHECK(y[0] == 0.0);  // (1e16 + 1) - 1e16 in doubles; any other order of sums gives 1
  CHECK(y[1] == 6.0);
}

TEST_CASE("An orthogonal factor keeps the digits that normal equations lose", "[exact][dense]") {
  // Läuchli's matrix: G'G is singular in doubles for e = 1e-9, G is not.
  const double e = 1e-9;
  MatX G(3, 2);
  G << 1, 1, e, 0, 0, e;
  VecX d(3);
  d << 2, e, e;  // x = (1, 1) exactly
  OrthogonalFactor factor;
  factor.clear(3, 2);
  REQUIRE(factor.append(G, 0));
  REQUIRE(factor.append(G, 1));
  std::vector<double> x(2);
  factor.solve(d, x);
  // Condition 1e9 times rounding 1e-16 (measured 2e-16: this one is kind).
  CHECK(std::abs(x[0] - 1.0) <= 1e-7);
  CHECK(std::abs(x[1] - 1.0) <= 1e-7);
  const MatX normal = test::product(G.transpose(), G);
  CHECK(normal(0, 0) * normal(1, 1) == 1.0);
}
