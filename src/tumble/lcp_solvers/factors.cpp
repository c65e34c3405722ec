/// \file
/// \brief The matrix of a contact problem as the product that it came from (thesis 2.6.2).
#include "tumble/lcp_solvers/factors.hpp"

#include "tumble/base/error.hpp"

namespace tumble {
namespace {

using Row = LcpFactors::Row;
using Body = LcpFactors::Body;

// What a row has of a body: zeros if it has nothing of it.
struct Part {
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
};

Part part_of(const Row& row, int body) {
  if (body == row.first) return {row.linear_first_w, row.angular_first_w};
  if (body == row.second) return {row.linear_second_w, row.angular_second_w};
  return {};
}

// J_i W J_jᵀ, the part of one body; -1 does not move.
double through_body(const LcpFactors& factors, const Row& i, const Row& j, int body) {
  if (body < 0 || (j.first != body && j.second != body)) return 0.0;  // most pairs of rows
  const Body& w = factors.bodies[static_cast<std::size_t>(body)];
  const Part a = part_of(i, body);
  const Part b = part_of(j, body);
  return a.linear.dot(w.inverse_mass.cwiseProduct(b.linear)) +
         a.angular.dot(w.inverse_inertia_w * b.angular);
}

}  // namespace

void require_valid(const LcpFactors& factors) {
  const int bodies = static_cast<int>(factors.bodies.size());
  for (const Row& row : factors.rows) {
    require::that(row.first >= -1 && row.first < bodies && row.second >= -1 && row.second < bodies,
                  "factors: expected indices of bodies, or -1");
    require::that(row.first < 0 || row.first != row.second,
                  "factors: expected two different bodies in a row");
    require::finite(row.linear_first_w, "factors: linear_first_w");
    require::finite(row.angular_first_w, "factors: angular_first_w");
    require::finite(row.linear_second_w, "factors: linear_second_w");
    require::finite(row.angular_second_w, "factors: angular_second_w");
  }
  for (const Body& body : factors.bodies) {
    require::finite(body.inverse_inertia_w, "factors: inverse_inertia_w");
    for (int k = 0; k < 3; ++k) {
      require::not_negative(body.inverse_mass[k], "factors: inverse_mass");
      require::not_negative(body.inverse_inertia_w(k, k), "factors: diagonal of inverse_inertia_w");
    }
  }
}

void multiply_out(const LcpFactors& factors, MatX& A) {
  require_valid(factors);
  const auto n = static_cast<Eigen::Index>(factors.rows.size());
  A.resize(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i <= j; ++i) {
      const Row& a = factors.rows[static_cast<std::size_t>(i)];
      const Row& b = factors.rows[static_cast<std::size_t>(j)];
      A(i, j) = through_body(factors, a, b, a.first) + through_body(factors, a, b, a.second);
      A(j, i) = A(i, j);
    }
  }
}

}  // namespace tumble
