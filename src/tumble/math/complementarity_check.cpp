/// \file
/// \brief Mistakes in a complementarity problem, and in an answer to one.
#include "tumble/math/complementarity_check.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/math/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

void require_sizes(const MatRef& A, const VecRef& b) {
  require::that(A.rows() == A.cols(), "A: expected as many rows as columns");
  require::that(b.size() == A.rows(), "b: expected as many entries as A has rows");
}

bool may_be_semidefinite(const MatRef& A, const VecRef& b) {
  require_sizes(A, b);
  bool plausible = true;
  for (int j = 0; j < A.cols(); ++j) {
    require::finite(b[j], "b");
    const double root = std::sqrt(std::abs(A(j, j)));
    for (int i = 0; i <= j; ++i) {
      require::finite(A(i, j), "A");
      require::finite(A(j, i), "A");
      const double scale = std::sqrt(std::abs(A(i, i))) * root;
      require::that(std::abs(A(i, j) - A(j, i)) <= tolerance::symmetry * scale,
                    "A: expected a symmetric matrix");
      if (std::abs(A(i, j)) > (1.0 + tolerance::symmetry) * scale) plausible = false;
    }
    if (A(j, j) < 0.0) plausible = false;
  }
  return plausible;
}

double complementarity_residual(const MatRef& A, const VecRef& b, const VecRef& f) {
  require_sizes(A, b);
  require::that(f.size() == b.size(), "f: expected as many entries as b has");
  double worst = 0.0;
  double scale = 0.0;
  for (int i = 0; i < b.size(); ++i) {
    double a = b[i];
    for (int j = 0; j < b.size(); ++j) a += A(i, j) * f[j];
    const double wrong = std::abs(std::min(A(i, i) * f[i], a));
    if (!(wrong <= worst)) worst = wrong;
    if (std::isnan(worst) || std::isnan(a)) return std::numeric_limits<double>::quiet_NaN();
    scale = std::max(scale, std::abs(b[i]));
  }
  return scale > 0.0 ? worst / scale : worst;
}

}  // namespace tumble
