/// \file
/// \brief A root of a body's inverse inertia (thesis 2.6.2).
#include "tumble/lcp_solvers/mass_root.hpp"

#include "tumble/contact/tolerances.hpp"

#include <cmath>

namespace tumble {

Mat3 root_of(const Mat3& inverse_inertia_w) {
  const Mat3& B = inverse_inertia_w;
  Mat3 S = Mat3::Zero();
  for (int k = 0; k < 3; ++k) {
    const double left = B(k, k) - S.row(k).squaredNorm();
    if (left <= tolerance::rigid * B.trace()) continue;
    const double pivot = std::sqrt(left);
    for (int i = k; i < 3; ++i) S(i, k) = (B(i, k) - S.row(i).dot(S.row(k))) / pivot;
  }
  return S;
}

}  // namespace tumble
