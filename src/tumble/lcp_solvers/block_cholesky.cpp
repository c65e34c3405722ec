/// \file
/// \brief Cholesky factor of a sparse matrix of 6×6 blocks.
#include "tumble/lcp_solvers/block_cholesky.hpp"

#include "tumble/base/index.hpp"

namespace tumble {

void BlockCholesky::analyse(const BlockRows& rows) {
  multiplications_ = 0;
  joined_.clear();
  const std::vector<int>& begin = rows.begin_of_rows();
  const std::vector<int>& blocks = rows.blocks_of_rows();
  for (int i = 0; i < rows.size(); ++i)
    for (int p = begin[idx(i)]; p < begin[idx(i) + 1]; ++p)
      for (int q = p + 1; q < begin[idx(i) + 1]; ++q)
        joined_.push_back({blocks[idx(p)], blocks[idx(q)]});
  matrix_.analyse(rows.blocks(), joined_);
}

void BlockCholesky::factor(const BlockRows& rows, const std::vector<char>& in_set,
                           double softness) {
  matrix_.clear();
  for (int k = 0; k < rows.blocks(); ++k) matrix_.add_to(k, softness * Mat6::Identity());
  const std::vector<int>& begin = rows.begin_of_rows();
  const std::vector<int>& blocks = rows.blocks_of_rows();
  const std::vector<Vec6>& parts = rows.parts();
  int pair = 0;
  for (int i = 0; i < rows.size(); ++i) {
    const int count = begin[idx(i) + 1] - begin[idx(i)];
    if (in_set[idx(i)] == 0) {
      pair += count * (count - 1) / 2;
      continue;
    }
    for (int p = begin[idx(i)]; p < begin[idx(i) + 1]; ++p) {
      const Vec6& a = parts[idx(p)];
      matrix_.add_to(blocks[idx(p)], a * a.transpose());
      for (int q = p + 1; q < begin[idx(i) + 1]; ++q)
        matrix_.add_to_pair(pair++, a * parts[idx(q)].transpose());
    }
    multiplications_ += std::int64_t{18} * count * (count + 1);
  }
  matrix_.factor();
  multiplications_ += matrix_.multiplications_of_factor();
}

void BlockCholesky::solve(std::vector<Vec6>& x) {
  matrix_.solve(x);
  multiplications_ += matrix_.multiplications_of_solve();
}

}  // namespace tumble
