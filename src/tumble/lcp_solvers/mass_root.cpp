/// \file
/// \brief The root of the inverse masses of a problem's bodies (thesis 2.6.2).
#include "tumble/lcp_solvers/mass_root.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {

namespace {

// The lower triangular S with S Sᵀ = B.
Mat3 root_of(const Mat3& B) {
  Mat3 S = Mat3::Zero();
  for (int k = 0; k < 3; ++k) {
    const double left = B(k, k) - S.row(k).squaredNorm();
    if (left <= tolerance::rigid * B.trace()) continue;
    const double pivot = std::sqrt(left);
    for (int i = k; i < 3; ++i) S(i, k) = (B(i, k) - S.row(i).dot(S.row(k))) / pivot;
  }
  return S;
}

}  // namespace

void MassRoots::take(const LcpFactors& factors) {
  mass_.clear();
  inertia_w_.clear();
  for (const LcpFactors::Body& body : factors.bodies) {
    mass_.push_back(body.inverse_mass.cwiseSqrt());
    inertia_w_.push_back(root_of(body.inverse_inertia_w));
  }
}

Vec6 MassRoots::part(int body, const Vec3& linear_w, const Vec3& angular_w) const {
  Vec6 part;
  part.head<3>() = mass_[idx(body)].cwiseProduct(linear_w);
  part.tail<3>() = inertia_w_[idx(body)].transpose() * angular_w;
  return part;
}

Vec6 MassRoots::acceleration(int body, const Vec6& z) const {
  Vec6 rates;
  rates.head<3>() = mass_[idx(body)].cwiseProduct(z.head<3>());
  rates.tail<3>() = inertia_w_[idx(body)] * z.tail<3>();
  return rates;
}

void require_factors_fit(const LcpProblem& problem) {
  const std::size_t rows = problem.factors.rows.size();
  if (rows != idx(problem.size()))
    refuse("factors have " + std::to_string(rows) + " rows: give none or " +
           std::to_string(problem.size()));
  require_valid(problem.factors);
}

void require_diagonal(const LcpProblem& problem, int row, double product) {
  const double A_ii = problem.A(row, row);
  if (std::abs(product - A_ii) <= tolerance::symmetry * std::max(product, std::abs(A_ii))) return;
  refuse("row " + std::to_string(row) + " of the factors makes " + shortest_text(product) +
         " of A_ii = " + shortest_text(A_ii) + ": give the factors of A");
}

}  // namespace tumble
