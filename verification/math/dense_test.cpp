/// \file
/// \brief Factors that grow and shrink, against products written out.
#include "tumble/math/dense.hpp"

#include "tumble/base/random.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace tumble;

namespace {

MatX random_matrix(Random& random, int rows, int columns) {
  MatX m(rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) m(i, j) = random.uniform(-1.0, 1.0);
  return m;
}

}  // namespace

TEST_CASE("A product sums the columns from left to right", "[exact][dense]") {
  MatX A(2, 3);
  A << 1e16, 1.0, -1e16, 1.0, 2.0, 3.0;
  const std::vector<double> x{1.0, 1.0, 1.0};
  std::vector<double> y{7.0, 7.0};
  multiply(A, x, y);
  CHECK(y[0] == 0.0);  // (1e16 + 1) - 1e16 in doubles; any other order of sums gives 1
  CHECK(y[1] == 6.0);
}

TEST_CASE("A Cholesky factor solves for its indices while they come and go", "[unit][dense]") {
  Random random(1);
  SubsetCholesky factor;
  double worst = 0.0;
  double worst_answer = 0.0;
  for (int round = 0; round < 200; ++round) {
    const int n = 1 + static_cast<int>(random.below(12));
    const MatX J = random_matrix(random, n, n + 3);
    const MatX A = J * J.transpose();
    factor.clear(n);
    for (int change = 0; change < 30; ++change) {
      const int j = static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
      const auto& held = factor.indices();
      const auto where = std::find(held.begin(), held.end(), j);
      if (where != held.end()) {
        factor.remove(A, static_cast<int>(where - held.begin()));
      } else {
        // A unit force at j and the answering forces must leave the accelerations of C at 0.
        const double schur = factor.consider(A, j);
        std::vector<double> answer(held.size());
        factor.answer_to_considered(answer);
        double at_j = A(j, j);
        for (std::size_t k = 0; k < held.size(); ++k) {
          double a = A(held[k], j);
          for (std::size_t l = 0; l < held.size(); ++l) a += A(held[k], held[l]) * answer[l];
          worst_answer = std::max(worst_answer, std::abs(a));
          at_j += A(j, held[k]) * answer[k];
        }
        worst_answer = std::max(worst_answer, std::abs(at_j - schur));
        factor.append_considered();
      }
      std::vector<double> x(held.size(), 1.0);
      factor.solve(x);
      for (const int row : held) {
        double r = -1.0;
        for (std::size_t k = 0; k < held.size(); ++k) r += A(row, held[k]) * x[k];
        worst = std::max(worst, std::abs(r) / (1.0 + view(x).cwiseAbs().maxCoeff()));
      }
    }
  }
  // Rounding of sums of 12 terms up to 5, times the size of the answers (measured 2e-15 both).
  CHECK(worst <= 1e-13);
  CHECK(worst_answer <= 1e-13);
}

TEST_CASE("The Schur complement of a dependent row is rounding", "[exact][dense]") {
  MatX A(3, 3);
  A << 2, 1, 3, 1, 2, 3, 3, 3, 6;  // the last row is the sum of the others
  SubsetCholesky factor;
  factor.clear(3);
  CHECK(factor.consider(A, 0) == 2.0);
  factor.append_considered();
  CHECK(std::abs(factor.consider(A, 1) - 1.5) <= 1e-15);
  factor.append_considered();
  CHECK(std::abs(factor.consider(A, 2)) <= 1e-14);
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
  CHECK((G.transpose() * G)(0, 0) * (G.transpose() * G)(1, 1) == 1.0);
}

TEST_CASE("An orthogonal factor refuses dependent columns and solves for the rest",
          "[unit][dense]") {
  Random random(2);
  OrthogonalFactor factor;
  int wrong = 0;
  double worst = 0.0;
  for (int round = 0; round < 300; ++round) {
    const int rows = 1 + static_cast<int>(random.below(8));
    MatX G = random_matrix(random, rows, 6);
    G.col(3) = 0.5 * G.col(1) - 2.0 * G.col(0);
    G.col(4).setZero();
    factor.clear(rows, 6);
    int held = 0;
    for (int j = 0; j < 6; ++j) {
      const bool independent = held < rows && j != 4 && (j != 3 || rows < 2);
      const bool appended = factor.append(G, j);
      if (appended != independent) ++wrong;
      if (appended) ++held;
    }
    if (held > 1 && random.below(2) == 0) factor.remove(G, 0);
    VecX d(rows);
    for (int i = 0; i < rows; ++i) d[i] = random.uniform(-1.0, 1.0);
    std::vector<double> x(factor.indices().size());
    factor.solve(d, x);
    // What is left is at right angles to all columns in use.
    VecX rest = d;
    for (std::size_t k = 0; k < x.size(); ++k) rest -= x[k] * G.col(factor.indices()[k]);
    for (const int j : factor.indices())
      worst = std::max(worst, std::abs(rest.dot(G.col(j))) / (1.0 + view(x).cwiseAbs().maxCoeff()));
  }
  CHECK(wrong == 0);
  CHECK(worst <= 1e-14);  // rounding of sums of 8 terms (measured 5e-16)
}
