/// \file
/// \brief Runge-Kutta methods for bodies in joints.
#include "tumble/exterior_rotation/runge_kutta.hpp"

#include "tumble/base/index.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble {
namespace {

// Adds weight * rate to a sum, in the order of the stages.
template <typename Rate>
void add(double weight, const Rate& rate, Rate& sum) {
  sum.x_w += weight * rate.x_w;
  sum.r_w += weight * rate.r_w;
  sum.p_w += weight * rate.p_w;
  sum.l_w += weight * rate.l_w;
}

// Whether all numbers are finite and rotation vectors are below a full turn.
template <typename Rate>
bool within_a_turn(const std::vector<Rate>& changes) {
  return std::all_of(changes.begin(), changes.end(), [](const Rate& c) {
    return c.r_w.norm() < 2.0 * std::numbers::pi && c.x_w.allFinite() && c.p_w.allFinite() &&
           c.l_w.allFinite();
  });
}

}  // namespace

const ButcherTable& midpoint_table() {
  static const ButcherTable table = {
      .stages = 2, .order = 2, .a = {{{}, {1.0 / 2}}}, .b = {0.0, 1.0}};
  return table;
}

const ButcherTable& classical_table() {
  static const ButcherTable table = {.stages = 4,
                                     .order = 4,
                                     .a = {{{}, {1.0 / 2}, {0.0, 1.0 / 2}, {0.0, 0.0, 1.0}}},
                                     .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
  return table;
}

const ButcherTable& dormand_prince_table() {
  static const ButcherTable table = {
      .stages = 7,
      .order = 5,
      .a = {{{},
             {1.0 / 5},
             {3.0 / 40, 9.0 / 40},
             {44.0 / 45, -56.0 / 15, 32.0 / 9},
             {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
             {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
             {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}},
      .b = {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0.0},
      .error = {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
                -1.0 / 40}};
  return table;
}

// dt times the weighted sum of the slopes.
void RungeKutta::change(const std::array<double, ButcherTable::kMostStages>& weights, int stages,
                        double dt, std::vector<Rate>& out) const {
  out.assign(start_.size(), Rate{});
  for (int s = 0; s < stages; ++s) {
    if (weights[idx(s)] == 0.0) continue;
    for (std::size_t k = 0; k < out.size(); ++k)
      add(dt * weights[idx(s)], slopes_[idx(s)][k], out[k]);
  }
}

double RungeKutta::step(const ButcherTable& table, double dt, std::span<const Joint> joints,
                        JointForces& forces, World& world, std::span<const Wrench> pushes) {
  start_.assign(world.states().begin(), world.states().end());
  const auto put = [&] {  // adds the changes to the start
    for (std::size_t k = 0; k < start_.size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      BodyState& state = world.states()[k];
      state.position_w = start_[k].position_w + change_[k].x_w;
      state.orientation_wb =
          normalised(rotation_from_vector(change_[k].r_w) * start_[k].orientation_wb);
      state.linear_momentum_w = start_[k].linear_momentum_w + change_[k].p_w;
      state.angular_momentum_w = start_[k].angular_momentum_w + change_[k].l_w;
    }
  };
  const auto too_far = [&] {
    std::copy(start_.begin(), start_.end(), world.states().begin());
    return std::numeric_limits<double>::infinity();
  };
  // [S6.2:rungekutta]
  for (int s = 0; s < table.stages; ++s) {
    // A stage: the state that the slopes so far lead to, and the forces there.
    change(table.a[idx(s)], s, dt, change_);
    if (!within_a_turn(change_)) return too_far();
    put();
    load_moving_bodies(world, moving_);
    forces.hold(world, moving_, joints, wrenches_, pushes);
    slopes_[idx(s)].resize(start_.size());
    for (std::size_t k = 0; k < start_.size(); ++k)
      slopes_[idx(s)][k] = {moving_[k].velocity_w,
                            rotation_vector_rate(change_[k].r_w, moving_[k].angular_velocity_w),
                            wrenches_[k].force_w, wrenches_[k].torque_w};
  }
  // [S6.2:rungekutta]
  // The error, from the weights of two orders; then the result.
  change(table.error, table.stages, dt, change_);
  double error = 0.0;
  const double g = world.gravity_w.norm();
  for (std::size_t k = 0; k < start_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const double size = body.size.minCoeff();
    const double speed = g > 0.0 ? std::sqrt(g * size) : size / dt;
    const Rate& e = change_[k];
    error = std::max({error, e.x_w.norm() / size, e.r_w.norm(),
                      body.inverse_mass * e.p_w.norm() / speed,
                      body.inverse_inertia_b.maxCoeff() * e.l_w.norm() * size / speed});
  }
  change(table.b, table.stages, dt, change_);
  if (!within_a_turn(change_)) return too_far();
  put();
  return error;
}

}  // namespace tumble
