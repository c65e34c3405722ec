/// \file
/// \brief Every pair of bounds.
#include "tumble/geometry/all_pairs.hpp"

namespace tumble {

void AllPairs::search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  const int n = static_cast<int>(bounds.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) test(bounds, a, b, out);
  }
}

}  // namespace tumble
