/// \file
/// \brief Particles and rods held by relaxation.
#include "tumble/previous_work/rods.hpp"

#include "tumble/base/index.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <Eigen/LU>

#include <numbers>

namespace tumble {

// [S2.3:advance]
// Verlet's rule: the way of the step before, and what the acceleration adds.
void RodParticles::advance(const Vec3& acceleration_w, double dt) {
  for (std::size_t k = 0; k < now_w.size(); ++k) {
    if (!(inverse_mass[k] > 0.0)) continue;
    const Vec3 next_w = now_w[k] + (now_w[k] - before_w[k]) + dt * dt * acceleration_w;
    before_w[k] = now_w[k];
    now_w[k] = next_w;
  }
}
// [S2.3:advance]

// [S2.3:relax]
// Each rod moves its ends until it has its length; the lighter end moves farther.
void RodParticles::relax() {
  for (const Rod& rod : rods) {
    Vec3& first_w = now_w[idx(rod.first)];
    Vec3& second_w = now_w[idx(rod.second)];
    const double ease_first = inverse_mass[idx(rod.first)];
    const double ease_second = inverse_mass[idx(rod.second)];
    const Vec3 along_w = second_w - first_w;
    const double length = along_w.norm();
    if (!(length > 0.0) || !(ease_first + ease_second > 0.0)) continue;
    const double share = (length - rod.length) / (length * (ease_first + ease_second));
    first_w += ease_first * share * along_w;
    second_w -= ease_second * share * along_w;
  }
}
// [S2.3:relax]

Vec3 particle_of_box(const Vec3& half, std::size_t k) {
  const auto& sign = kTetrahedron[k];
  return Vec3(sign[0] * half.x(), sign[1] * half.y(), sign[2] * half.z()) * std::numbers::inv_sqrt3;
}

// The signs of four corners add up to 0, and their products to 4 for the same axis and 0 for two.
std::array<double, 4> weights_of(const Vec3& half, const Vec3& point_b) {
  const Vec3 share = point_b.cwiseQuotient(half) * std::numbers::sqrt3;
  std::array<double, 4> weights{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& sign = kTetrahedron[k];
    weights[k] = 0.25 * (1.0 + sign[0] * share.x() + sign[1] * share.y() + sign[2] * share.z());
  }
  return weights;
}

// With F the mean over particles of their place, less the centre, times their place in the undeformed box: F = R U. The mean
// of R and of its inverse transposed comes nearer to a rotation, with twice the digits each time.
FittedBox fit_box(const Vec3& half, const std::array<Vec3, 4>& particles) {
  FittedBox fitted;
  fitted.centre_w = 0.25 * ((particles[0] + particles[1]) + (particles[2] + particles[3]));
  Mat3 turn = Mat3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 from_w = particles[k] - fitted.centre_w;
    for (int axis = 0; axis < 3; ++axis)
      turn.col(axis) +=
          0.25 * std::numbers::sqrt3 * kTetrahedron[k][idx(axis)] / half[axis] * from_w;
  }
  constexpr int kMostRounds = 50;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!(turn.determinant() > tolerance::flat_box) || !turn.allFinite()) return fitted;
    const Mat3 next = 0.5 * (turn + turn.inverse().transpose());
    const double change = (next - turn).cwiseAbs().maxCoeff();
    turn = next;
    if (change <= tolerance::fitted_box) break;
  }
  if (!fitted.centre_w.allFinite()) return fitted;
  fitted.orientation_wb = normalised(Quat(turn));
  fitted.found = true;
  return fitted;
}

}  // namespace tumble
