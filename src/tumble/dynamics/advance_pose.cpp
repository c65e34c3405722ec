/// \file
/// \brief Moving a body at constant momenta: four rules for the rotation (thesis 3.1).
#include "tumble/dynamics/advance_pose.hpp"

#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tumble {
namespace {

constexpr std::array<RotationRule, 4> kRules = {RotationRule::frozen, RotationRule::midpoint,
                                                RotationRule::rk4, RotationRule::splitting};

// ω = R I_b^-1 R' L at any orientation, in the world frame.
Vec3 omega_w(const BodyProperties& body, const Quat& q_wb, const Vec3& momentum_w) {
  const Mat3 rotation_wb = q_wb.toRotationMatrix();
  const Vec3 momentum_b = rotation_wb.transpose() * momentum_w;
  return rotation_wb * body.inverse_inertia_b.cwiseProduct(momentum_b);
}

// [S3.1:constant]
Quat frozen(const BodyProperties& body, const BodyState& state, double dt) {
  const Quat& q = state.orientation_wb;
  return turned(q, omega_w(body, q, state.angular_momentum_w), dt);
}

Quat midpoint(const BodyProperties& body, const BodyState& state, double dt) {
  const Vec3& momentum_w = state.angular_momentum_w;
  const Quat& q = state.orientation_wb;
  const Quat half_way = turned(q, omega_w(body, q, momentum_w), 0.5 * dt);
  return turned(q, omega_w(body, half_way, momentum_w), dt);
}
// [S3.1:constant]

// dq/dt = 1/2 (0, ω) q. Stages of a Runge-Kutta step leave the unit sphere; ω depends on the
// direction of q only, which keeps the field smooth around the sphere and the order at 4.
Eigen::Vector4d slope(const BodyProperties& body, const Eigen::Vector4d& q_wxyz,
                      const Vec3& momentum_w) {
  const Quat q(q_wxyz[0], q_wxyz[1], q_wxyz[2], q_wxyz[3]);
  const Vec3 half_omega_w = 0.5 * omega_w(body, normalised(q), momentum_w);
  const Quat rate = Quat(0.0, half_omega_w.x(), half_omega_w.y(), half_omega_w.z()) * q;
  return {rate.w(), rate.x(), rate.y(), rate.z()};
}

Quat rk4(const BodyProperties& body, const BodyState& state, double dt) {
  const Vec3& momentum_w = state.angular_momentum_w;
  const Quat& q = state.orientation_wb;
  const Eigen::Vector4d start(q.w(), q.x(), q.y(), q.z());
  const Eigen::Vector4d k1 = slope(body, start, momentum_w);
  const Eigen::Vector4d k2 = slope(body, start + 0.5 * dt * k1, momentum_w);
  const Eigen::Vector4d k3 = slope(body, start + 0.5 * dt * k2, momentum_w);
  const Eigen::Vector4d k4 = slope(body, start + dt * k3, momentum_w);
  const Eigen::Vector4d end = start + dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
  return normalised(Quat(end[0], end[1], end[2], end[3]));
}

// The body axes ordered by moment of inertia; equal moments in the order of the axes.
std::array<int, 3> axes_by_moment(const Vec3& inertia_b) {
  std::array<int, 3> order = {0, 1, 2};
  const auto sort_pair = [&](std::size_t i, std::size_t j) {
    if (inertia_b[order[j]] < inertia_b[order[i]]) std::swap(order[i], order[j]);
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  return order;
}

// The flow of the part 1/2 c Π_k² of the energy: the body turns about its own axis k by the angle
// α = c Π_k dt, and so the fixed L turns by -α as the body sees it.
void turn_about_axis(int k, double coefficient, double dt, Quat& q_wb, Vec3& momentum_b) {
  const double half_angle = 0.5 * (coefficient * momentum_b[k] * dt);
  const elementary::SinCos half = elementary::sincos(half_angle);
  Quat turn(half.cos, 0.0, 0.0, 0.0);
  turn.vec()[k] = half.sin;
  q_wb = q_wb * turn;

  const int i = (k + 1) % 3;
  const int j = (k + 2) % 3;
  const double sine = 2.0 * half.sin * half.cos;
  const double cosine = 1.0 - 2.0 * half.sin * half.sin;
  const double old_i = momentum_b[i];
  momentum_b[i] = cosine * old_i + sine * momentum_b[j];
  momentum_b[j] = cosine * momentum_b[j] - sine * old_i;
}

// [S3.1:splitting]
Quat splitting(const BodyProperties& body, const BodyState& state, double dt) {
  const auto [a, b, c] = axes_by_moment(body.inertia_b);
  const double middle = body.inverse_inertia_b[b];
  const double excess_a = body.inverse_inertia_b[a] - middle;  // at least 0
  const double excess_c = body.inverse_inertia_b[c] - middle;  // at most 0

  Quat q = state.orientation_wb;
  Vec3 momentum_b = q.toRotationMatrix().transpose() * state.angular_momentum_w;
  turn_about_axis(a, excess_a, 0.5 * dt, q, momentum_b);
  turn_about_axis(c, excess_c, dt, q, momentum_b);
  turn_about_axis(a, excess_a, 0.5 * dt, q, momentum_b);
  // The part L²/(2 I_b) turns the body about L and does not change Π: it commutes with the others.
  return turned(q, middle * state.angular_momentum_w, dt);
}
// [S3.1:splitting]

}  // namespace

std::span<const RotationRule> rotation_rules() { return kRules; }

std::string_view name_of(RotationRule rule) {
  switch (rule) {
    case RotationRule::frozen: return "frozen";
    case RotationRule::midpoint: return "midpoint";
    case RotationRule::rk4: return "rk4";
    case RotationRule::splitting: return "splitting";
  }
  throw std::invalid_argument("tumble: not a rotation rule");
}

void advance_pose(const BodyProperties& body, BodyState& state, double dt, RotationRule rule) {
  if (dt == 0.0 || !body.movable()) return;
  state.position_w += dt * (body.inverse_mass * state.linear_momentum_w);

  // A body without spin keeps its orientation to the last bit; normalising might change one.
  if (state.angular_momentum_w.isZero(0.0)) return;
  switch (rule) {
    case RotationRule::frozen: state.orientation_wb = frozen(body, state, dt); return;
    case RotationRule::midpoint: state.orientation_wb = midpoint(body, state, dt); return;
    case RotationRule::rk4: state.orientation_wb = rk4(body, state, dt); return;
    case RotationRule::splitting: state.orientation_wb = splitting(body, state, dt); return;
  }
  throw std::invalid_argument("tumble: not a rotation rule");
}

double angular_speed_bound(const BodyProperties& body, const BodyState& state, double dt,
                           RotationRule rule) {
  if (rule == RotationRule::frozen) return angular_velocity(body, state).norm();

  const Vec3& u = body.inverse_inertia_b;
  const auto [low, middle, high] = axes_by_moment(body.inertia_b);
  const double u1 = u[low];
  const double u3 = u[high];
  const double spread = u1 - u3;
  const double momentum = state.angular_momentum_w.norm();
  if (rule != RotationRule::splitting) return u1 * momentum * (1.0 + dt * spread * momentum);

  // Σ Π_i² weighted such that no term is negative: nothing cancels for long bars.
  const Vec3 momentum_b =
      state.orientation_wb.toRotationMatrix().transpose() * state.angular_momentum_w;
  double speed2 = 0.0;    // Ω²
  double on_first = 0.0;  // Π_1² (u1 - u3), if as much as the energy allows were on axis 1
  double on_third = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double square = momentum_b[i] * momentum_b[i];
    speed2 += square * ((u1 + u3) * u[i] - u1 * u3);
    on_first += square * (u[i] - u3);
    on_third += square * (u1 - u[i]);
  }
  if (spread == 0.0) return std::sqrt(speed2);  // a cube
  const double swing = (u1 - u[middle]) * std::sqrt(on_first / spread) +
                       (u[middle] - u3) * std::sqrt(on_third / spread);
  return std::sqrt(speed2) * (1.0 + dt * swing);
}

}  // namespace tumble
