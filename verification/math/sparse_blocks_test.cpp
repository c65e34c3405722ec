/// \file
/// \brief Sparse factors of 6×6 blocks, against Eigen's dense ones.
#include "tumble/math/sparse_blocks.hpp"

#include "support/dense_solve.hpp"
#include "support/test.hpp"

namespace {

using Dense = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

// A matrix of random blocks on random places, once sparse and once dense: the sum of squares of
// random rows, each of which joins two blocks or looks at one, as contacts do.
struct Problem {
  int blocks = 0;
  std::vector<BlockPair> joined;
  std::vector<Mat6> own;
  std::vector<Mat6> between;
  Dense dense;

  Problem(std::uint64_t seed, int count, int pairs) : blocks(count) {
    Random chance(seed);
    own.assign(idx(count), Mat6::Identity());
    const auto random_block = [&] {
      Mat6 m;
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i) m(i, j) = chance.uniform(-1.0, 1.0);
      return m;
    };
    for (int k = 0; k < pairs && count > 1; ++k) {
      const int a = static_cast<int>(chance.below(static_cast<std::uint32_t>(count)));
      const int b = static_cast<int>(chance.below(static_cast<std::uint32_t>(count)));
      if (a == b) continue;
      const Mat6 left = random_block();
      const Mat6 right = random_block();
      joined.push_back({a, b});
      own[idx(a)] += left * left.transpose();
      own[idx(b)] += right * right.transpose();
      between.emplace_back(left * right.transpose());
    }
    dense = Dense::Zero(6 * count, 6 * count);
    for (int b = 0; b < count; ++b) dense.block<6, 6>(6 * b, 6 * b) = own[idx(b)];
    for (std::size_t k = 0; k < joined.size(); ++k) {
      const int a = 6 * joined[k].first;
      const int b = 6 * joined[k].second;
      dense.block<6, 6>(a, b) += between[k];
      dense.block<6, 6>(b, a) += between[k].transpose();
    }
  }

  void fill(SparseBlocks& matrix) const {
    matrix.clear();
    for (int b = 0; b < blocks; ++b) matrix.add_to(b, own[idx(b)]);
    for (std::size_t k = 0; k < joined.size(); ++k)
      matrix.add_to_pair(static_cast<int>(k), between[k]);
  }
};

// [-] Largest error of a solution over the largest entry of the dense one.
double error_of(const Problem& problem, SparseBlocks& matrix, std::uint64_t seed) {
  Random chance(seed);
  std::vector<Vec6> x(static_cast<std::size_t>(problem.blocks));
  Column right(6 * problem.blocks);
  for (int b = 0; b < problem.blocks; ++b)
    for (int i = 0; i < 6; ++i) right[6 * b + i] = x[idx(b)][i] = chance.uniform(-1.0, 1.0);
  matrix.solve(x);
  const Column exact = test::dense_solve(problem.dense, right);
  double worst = 0.0;
  for (int b = 0; b < problem.blocks; ++b)
    worst = std::max(worst, (x[idx(b)] - exact.segment<6>(6 * b)).cwiseAbs().maxCoeff());
  return worst / exact.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("Sparse factors solve what dense ones do, on two hundred random patterns",
          "[exact][sparse_blocks][impulse_damped]") {
  SparseBlocks matrix;  // one for all: nothing of the pattern before may be left
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const int blocks = 1 + static_cast<int>(seed % 17);
    const Problem problem(seed, blocks, static_cast<int>(seed % 31));
    matrix.analyse(blocks, problem.joined);
    problem.fill(matrix);
    matrix.factor();
    worst = std::max(worst, error_of(problem, matrix, seed + 1000));
  }
  INFO("largest error " << worst);
  // [-] The smallest eigenvalue is at least 1, the largest about 1e2. Measured 1.2e-15.
  CHECK(worst < 1e-13);
}

TEST_CASE("Patterns of more than 64 blocks, pairs that come twice and no pair at all are solved",
          "[exact][sparse_blocks][impulse_damped]") {
  SparseBlocks matrix;
  Problem chain(7, 130, 0);
  for (int k = 0; k + 1 < 130; ++k) {
    chain.joined.push_back({k + 1, k});  // and the higher one first
    if (k % 5 == 0) chain.joined.push_back({k, k + 1});
  }
  for (const BlockPair& pair : chain.joined) {
    const Mat6 value = -0.1 * Mat6::Ones();
    chain.between.push_back(value);
    chain.dense.block<6, 6>(6 * pair.first, 6 * pair.second) += value;
    chain.dense.block<6, 6>(6 * pair.second, 6 * pair.first) += value.transpose();
  }
  for (int b = 0; b < 130; ++b) {
    chain.own[idx(b)] *= 5.0;
    chain.dense.block<6, 6>(6 * b, 6 * b) *= 5.0;
  }
  CHECK(matrix.analyse(130, chain.joined));
  CHECK(!matrix.analyse(130, chain.joined));  // the same pattern
  chain.fill(matrix);
  matrix.factor();
  CHECK(error_of(chain, matrix, 3) < 1e-13);  // [-] rounding
  // Elimination from the ends of a chain fills nothing in: one block below each diagonal one.
  CHECK(matrix.multiplications_of_solve() == 42 * 130 + 72 * 129);
  const Problem alone(9, 3, 0);
  CHECK(matrix.analyse(3, alone.joined));
  alone.fill(matrix);
  matrix.factor();
  CHECK(error_of(alone, matrix, 4) < 1e-15);
}

TEST_CASE("A matrix that is not positive definite has no finite solution",
          "[unit][sparse_blocks]") {
  for (const double least : {0.0, -1.0}) {
    SparseBlocks matrix;
    matrix.analyse(2, {});
    matrix.clear();
    Mat6 own = Mat6::Identity();
    matrix.add_to(0, own);
    own(5, 5) = least;
    matrix.add_to(1, own);
    matrix.factor();
    std::vector<Vec6> x(2, Vec6::Ones());
    matrix.solve(x);
    CHECK(x[0] == Vec6::Ones());
    CHECK_FALSE(x[1].allFinite());
  }
}

TEST_CASE("A pair of blocks that are none, or one, is refused",
          "[unit][sparse_blocks][impulse_damped]") {
  SparseBlocks matrix;
  for (const BlockPair& pair : {BlockPair{0, 0}, BlockPair{0, 2}, BlockPair{-1, 1}}) {
    const std::vector<BlockPair> joined = {pair};
    CHECK_THROWS_AS(matrix.analyse(2, joined), std::invalid_argument);
  }
}
