/// \file
/// \brief Products and factors, and non-negative least squares against trying every set of columns.
#include "tumble/math/least_squares.hpp"

#include "tumble/math/dense.hpp"

#include "support/allocation_counter.hpp"
#include "support/dense_solve.hpp"
#include "support/test.hpp"

namespace {

LeastSquaresResult nearest(const MatX& G, const VecX& d) {
  NonNegativeLeastSquares solver;
  LeastSquaresResult result;
  solver.solve(G, d, result);
  return result;
}

// The distance by brute force: the best of all sets of columns whose factors are not negative.
double distance_by_enumeration(const MatX& G, const VecX& d) {
  double best = d.norm();
  for (unsigned set = 1; set < 1U << G.cols(); ++set) {
    OrthogonalFactor factor;
    factor.clear(static_cast<int>(G.rows()), static_cast<int>(G.cols()));
    bool usable = true;
    for (int j = 0; j < G.cols() && usable; ++j)
      if ((set >> j & 1U) != 0) usable = factor.append(G, j);
    if (!usable) continue;
    std::vector<double> x(factor.indices().size());
    factor.solve(d, x);
    VecX rest = d;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (x[k] < 0.0) usable = false;
      rest -= x[k] * G.col(factor.indices()[k]);
    }
    if (usable) best = std::min(best, rest.norm());
  }
  return best;
}

struct Problem {
  MatX G;
  VecX d;
};

// Columns of whole numbers, often repeated, opposed or combined from others.
Problem random_problem(Random& random) {
  const int rows = 1 + static_cast<int>(random.below(6));
  const int columns = 1 + static_cast<int>(random.below(7));
  Problem p{MatX(rows, columns), VecX(rows)};
  for (int j = 0; j < columns; ++j) {
    const std::uint32_t kind = random.below(4);
    for (int i = 0; i < rows; ++i) p.G(i, j) = static_cast<double>(random.below(7)) - 3.0;
    if (j > 0 && kind == 0) p.G.col(j) = p.G.col(j - 1);
    if (j > 1 && kind == 1) p.G.col(j) = p.G.col(j - 1) - 2.0 * p.G.col(j - 2);
  }
  for (int i = 0; i < rows; ++i) p.d[i] = static_cast<double>(random.below(9)) - 4.0;
  return p;
}

}  // namespace

TEST_CASE("Non-negative least squares agrees with trying every set of columns",
          "[unit][least_squares]") {
  Random random(1);
  NonNegativeLeastSquares solver;
  LeastSquaresResult result;
  LeastSquaresResult warm;
  Failures wrong;
  int busy_warm = 0;
  int most_pivots = 0;
  for (int i = 0; i < 10000; ++i) {
    const Problem p = random_problem(random);
    solver.solve(p.G, p.d, result);
    most_pivots = std::max(most_pivots, result.pivots);
    // 1e-9: the slope that counts as none, 1e-11 of |d| <= 10, times factors up to some 10.
    if (!(std::abs(result.distance - distance_by_enumeration(p.G, p.d)) <= 1e-9))
      ++wrong["wrong distance"];

    // Karush, Kuhn and Tucker: f >= 0, slopes G'(d - G f) <= 0, and f is 0 where they are not 0.
    const VecX slope = p.G.transpose().lazyProduct(view(result.rest));
    const VecX rest = p.d - p.G * view(result.f);
    bool good = result.status == ComplementarityStatus::solved &&
                (rest - view(result.rest)).norm() <= 1e-12;
    for (int j = 0; j < p.G.cols(); ++j) {
      const double f = result.f[idx(j)];
      if (!(f >= 0.0) || slope[j] > 1e-9 || (f > 0.0 && slope[j] < -1e-9)) good = false;
    }
    if (!good) ++wrong["wrong conditions"];

    solver.solve(p.G, p.d, warm, result.pushing);
    if (!(std::abs(warm.distance - result.distance) <= 1e-12)) ++wrong["wrong warm"];
    if (warm.pivots != 0) ++busy_warm;
  }
  CHECK(wrong == Failures{});
  // Factors that are 0 in exact numbers may be negative by rounding in another order.
  CHECK(busy_warm <= 10);    // measured 2 of 10000
  CHECK(most_pivots <= 40);  // of a cap of 400; measured 8
}

TEST_CASE("Wide cones of nearly dependent columns keep their conditions", "[unit][least_squares]") {
  // 25 columns around one direction in 10 dimensions, and targets around it: long chains of changes.
  Random random(5);
  int wrong = 0;
  int most_pivots = 0;
  for (int i = 0; i < 500; ++i) {
    MatX G(10, 25);
    VecX d(10);
    for (int row = 0; row < 10; ++row) {
      for (int j = 0; j < 25; ++j) G(row, j) = 1.0 + random.uniform(-0.01, 0.01);
      d[row] = 1.0 + random.uniform(-0.02, 0.02);
    }
    const LeastSquaresResult result = nearest(G, d);
    most_pivots = std::max(most_pivots, result.pivots);
    const VecX slope = G.transpose().lazyProduct(view(result.rest));
    bool good = result.status == ComplementarityStatus::solved;
    for (int j = 0; j < 25; ++j) {
      const double f = result.f[idx(j)];
      if (!(f >= 0.0) || slope[j] > 1e-9 || (f > 0.0 && slope[j] < -1e-9)) good = false;
    }
    if (!good) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(most_pivots <= 100);  // of a cap of 1300; measured 12
}

TEST_CASE("Least squares without columns or rows leaves the target as it is",
          "[unit][least_squares]") {
  const LeastSquaresResult none = nearest(MatX(2, 0), Vec2(3.0, 4.0));
  CHECK(none.status == ComplementarityStatus::solved);
  CHECK(none.distance == 5.0);
  CHECK(none.f.empty());
  const LeastSquaresResult flat = nearest(MatX(0, 2), VecX(0));
  CHECK(flat.distance == 0.0);
  CHECK(flat.f == std::vector<double>{0.0, 0.0});
}

TEST_CASE("A warm start of any columns gives the same distance", "[unit][least_squares]") {
  Random random(3);
  NonNegativeLeastSquares solver;
  LeastSquaresResult result;
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const Problem p = random_problem(random);
    solver.solve(p.G, p.d, result);
    const double cold = result.distance;
    std::vector<int> start;
    for (int j = 0; j < p.G.cols(); ++j)
      if (random.below(2) == 0) start.push_back(j);
    solver.solve(p.G, p.d, result, start);
    if (!(std::abs(result.distance - cold) <= 1e-9)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("Warm solvers of no larger problems ask for no memory", "[unit][least_squares][lcp]") {
  Random random(4);
  NonNegativeLeastSquares least_squares;
  LeastSquaresResult distance;
  ComplementaritySolver complementarity;
  ComplementarityResult forces;
  MatX G(6, 20);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 6; ++i) G(i, j) = random.uniform(-1.0, 1.0);
  const MatX A = test::product(G.transpose(), G);
  const VecX d = VecX::Ones(6);
  const VecX b = -G.transpose().lazyProduct(d);
  least_squares.solve(G, d, distance);
  complementarity.solve(A, b, forces);
  const AllocationCount count;
  for (const int n : {20, 7, 12, 20}) {
    least_squares.solve(G.leftCols(n), d, distance,
                        std::span<const int>(distance.pushing).first(0));
    complementarity.solve(A.topLeftCorner(n, n), b.head(n), forces);
    complementarity.solve(A.topLeftCorner(n, n), b.head(n), forces, forces.pushing);
  }
  CHECK(count.value() == 0);
}

TEST_CASE("Mistakes in a least-squares problem are refused", "[unit][least_squares]") {
  NonNegativeLeastSquares solver;
  LeastSquaresResult result;
  const MatX G = MatX::Identity(2, 2);
  CHECK_THROWS_WITH(solver.solve(G, VecX::Zero(3), result), Contains("d: expected"));
  CHECK_THROWS_WITH(solver.solve(G, Vec2(kNan, 0.0), result), Contains("finite"));
  CHECK_THROWS_WITH(solver.solve(kNan * G, Vec2(1.0, 0.0), result), Contains("finite"));
  for (const std::vector<int>& start : {std::vector<int>{-1}, {2}, {1, 1}})
    CHECK_THROWS_AS(solver.solve(G, Vec2(1.0, 0.0), result, start), std::invalid_argument);
}

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
