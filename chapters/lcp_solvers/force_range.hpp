/// \file
/// \brief The smallest and the largest force that a part of the contacts can bear, as a linear
///        programme (thesis 2.6).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Two ends of a range.
struct ForceInterval {
  double least = 0.0;  // [N]
  double most = 0.0;   // [N]
};

// All forces f >= 0 with A f + b = 0, those under which nothing accelerates, and how large a sum of
// some of them can be.
//
// Dantzig's simplex method on a dense tableau: m equations, and a basis of as many unknowns that
// are not 0. Pivots follow Bland's rule, the unknown of least index first, and so cannot run in
// circles where contacts tie. Equations that depend on others are recognised and dropped.
class ForceRange {
 public:
  // Finds forces to begin with; throws std::runtime_error if there are none.
  ForceRange(const MatX& A, const VecX& b);

  // The least and the largest sum of some forces; throws std::runtime_error if it has no limit.
  [[nodiscard]] ForceInterval of(std::span<const int> rows) const;

 private:
  // Row k says that unknown basis[k] is T(k, n) less T(k, j) times each unknown j beside the basis;
  // its own column is a unit vector. The last row is the cost that is to be made least, negative.
  struct Tableau {
    MatX T;                  // (m+1×n+1)
    std::vector<int> basis;  // (m) n and above: the artificial unknown of an equation
    bool descend();
    void pivot(int row, int column);
  };

  Tableau start_;  // after the first phase
};

}  // namespace tumble::chapters
