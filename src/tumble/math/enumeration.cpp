/// \file
/// \brief Complementarity by trying everything.
#include "tumble/math/enumeration.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

std::vector<int> members(unsigned set) {
  std::vector<int> out;
  for (int i = 0; i < enumeration_limit; ++i)
    if ((set >> i & 1U) != 0) out.push_back(i);
  return out;
}

// Forces at F that make the accelerations at Z vanish, as nearly as can be; false if they are not
// determined or one of them pulls.
bool forces(const MatRef& A, const VecRef& b, const std::vector<int>& Z, const std::vector<int>& F,
            std::vector<double>& f) {
  const auto rows = static_cast<Eigen::Index>(Z.size());
  const auto columns = static_cast<Eigen::Index>(F.size());
  MatX part(rows, columns);
  VecX target(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int z = Z[static_cast<std::size_t>(i)];
    target[i] = -b[z];
    for (Eigen::Index k = 0; k < columns; ++k) part(i, k) = A(z, F[static_cast<std::size_t>(k)]);
  }
  OrthogonalFactor factor;
  factor.clear(static_cast<int>(rows), static_cast<int>(columns));
  for (int k = 0; k < columns; ++k)
    if (!factor.append(part, k)) return false;

  std::vector<double> x(F.size());
  factor.solve(target, x);
  std::fill(f.begin(), f.end(), 0.0);
  for (std::size_t k = 0; k < F.size(); ++k) {
    if (x[k] < 0.0) return false;
    f[static_cast<std::size_t>(F[k])] = x[k];
  }
  return true;
}

// Whether a = A f + b vanishes on Z and is not negative elsewhere, within the rounding of its terms.
bool fits(const MatRef& A, const VecRef& b, unsigned Z, ComplementarityResult& result) {
  const int n = static_cast<int>(b.size());
  double largest = 0.0;
  double terms = 0.0;
  for (int i = 0; i < n; ++i) {
    double row = 0.0;
    for (int j = 0; j < n; ++j) row += std::abs(A(i, j)) * result.f[static_cast<std::size_t>(j)];
    terms = std::max(terms, row);
    largest = std::max(largest, std::abs(b[i]));
  }
  const double slack = tolerance::complementarity * largest + tolerance::rounding * terms;

  multiply(A, result.f, result.a);
  for (int i = 0; i < n; ++i) {
    double& a = result.a[static_cast<std::size_t>(i)];
    a += b[i];
    if (a < -slack || ((Z >> i & 1U) != 0 && a > slack)) return false;
  }
  return true;
}

}  // namespace

ComplementarityResult solve_by_enumeration(const MatRef& A, const VecRef& b) {
  require::that(A.rows() == A.cols(), "A: expected as many rows as columns");
  require::that(b.size() == A.rows(), "b: expected as many entries as A has rows");
  require::that(b.size() <= enumeration_limit, "b: expected at most 8 entries to try all cases");
  for (int j = 0; j < b.size(); ++j) {
    require::finite(b[j], "b");
    for (int i = 0; i < b.size(); ++i) require::finite(A(i, j), "A");
  }

  const auto n = static_cast<std::size_t>(b.size());
  ComplementarityResult result;
  result.f.assign(n, 0.0);
  result.a.assign(n, 0.0);
  for (unsigned Z = 0; Z < 1U << n; ++Z) {
    // F runs through all subsets of Z, from Z itself down to none.
    for (unsigned F = Z;; F = (F - 1U) & Z) {
      ++result.pivots;
      if (forces(A, b, members(Z), members(F), result.f) && fits(A, b, Z, result)) {
        result.pushing = members(F);
        result.residual = complementarity_residual(A, b, view(result.f));
        return result;
      }
      if (F == 0U) break;
    }
  }
  result.status = ComplementarityStatus::infeasible;
  result.f.assign(n, 0.0);
  result.a.assign(b.data(), b.data() + b.size());
  return result;
}

}  // namespace tumble
