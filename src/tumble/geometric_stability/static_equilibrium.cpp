/// \file
/// \brief Static equilibrium of contact forces, island by island.
#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace tumble {
namespace {

// Two orthogonal directions in the contact plane.
std::pair<Vec3, Vec3> across(const Vec3& normal_w) {
  Eigen::Index least = 0;
  normal_w.cwiseAbs().minCoeff(&least);
  const Vec3 u = normal_w.cross(Vec3::Unit(least)).normalized();
  return {u, normal_w.cross(u)};
}

int pushes_of(const BalanceTask& task, const Contact& contact) {
  const bool rough = task.friction_edges > 0 && contact.friction > 0.0;
  return contact.count * (rough ? task.friction_edges : 1);
}

}  // namespace

const BalanceReport& StaticEquilibrium::solve(const World& world, const BalanceTask& task) {
  require::that(task.friction_edges == 0 || task.friction_edges >= 4,
                "friction_edges = " + std::to_string(task.friction_edges) +
                    ": give 0 for none, or 4 and more");
  report_ = {};
  load(world, task);
  islands_.build(world.bodies(), task.contacts, task.held);
  for (int i = 0; i < islands_.count(); ++i) balance(world, task, i);
  return report_;
}

// Sets the forces on each body and the root S of its inverse inertia; clears the results.
void StaticEquilibrium::load(const World& world, const BalanceTask& task) {
  const std::size_t count = world.bodies().size();
  balanced_.assign(count, 1);
  motion_.assign(count, {});
  acting_.assign(count, {});
  pushed_.assign(count, 0.0);
  slot_.assign(count, -1);  // each body is in one island at most
  root_inertia_w_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    if (task.weight) acting_[k].force_w = body.mass * world.gravity_w;
    // S Sᵀ = R diag(1/I) Rᵀ.
    const Vec3 root = body.inertia_b.cwiseSqrt().cwiseInverse();
    root_inertia_w_[k] = world.states()[k].orientation_wb.toRotationMatrix() * root.asDiagonal();
  }
  for (const Load& load : task.loads) {
    require::that(load.body >= 0 && idx(load.body) < count,
                  "load on body " + std::to_string(load.body) + ": give an index below " +
                      std::to_string(count));
    const Vec3 arm_w = load.point_w - world.states()[idx(load.body)].position_w;
    acting_[idx(load.body)].force_w += load.force_w;
    acting_[idx(load.body)].torque_w += arm_w.cross(load.force_w);
  }
  first_push_.clear();
  int pushes = 0;
  for (const Contact& contact : task.contacts) {
    first_push_.push_back(pushes);
    pushes += contact.count;
  }
  forces_w_.assign(idx(pushes), Vec3::Zero());
}

// Solves one island: its columns, the nearest point of their cone, and the residual.
void StaticEquilibrium::balance(const World& world, const BalanceTask& task, int island) {
  const std::span<const int> members = islands_.bodies(island);
  int columns = 0;
  for (const int c : islands_.contacts(island)) columns += pushes_of(task, task.contacts[idx(c)]);
  for (std::size_t k = 0; k < members.size(); ++k) slot_[idx(members[k])] = static_cast<int>(k);

  // [S6.3.1:balance]
  // Contacts are in equilibrium with the loads if a combination of
  // their unit forces, with no negative coefficient, is opposite to
  // the loads. The residual of the best combination, in the metric of
  // the masses, is the initial acceleration.
  push_place_.clear();
  push_of_w_.clear();
  G_.setZero(static_cast<Eigen::Index>(6 * members.size()), columns);
  for (const int c : islands_.contacts(island)) add_columns(world, task, c);
  d_.setZero(static_cast<Eigen::Index>(6 * members.size()));
  double scale = 0.0;  // [m/s²] largest acceleration without contacts
  for (const int b : members) {
    const BodyProperties& body = world.bodies()[idx(b)];
    const Wrench& acts = acting_[idx(b)];
    d_.segment<3>(6 * slot_[idx(b)]) = acts.force_w / std::sqrt(body.mass);
    d_.segment<3>(6 * slot_[idx(b)] + 3) = root_inertia_w_[idx(b)].transpose() * acts.torque_w;
    const Vec3 spins_w = root_inertia_w_[idx(b)] * d_.segment<3>(6 * slot_[idx(b)] + 3);
    scale = std::max(scale,
                     (acts.force_w / body.mass).norm() + 0.5 * body.size.norm() * spins_w.norm());
  }
  nearest_.solve(G_, d_, result_);
  // [S6.3.1:balance]
  report_.unknowns += columns;
  report_.pivots += result_.pivots;
  report_.multiplications += result_.multiplications;
  take(world, task, island, scale);
}

// Adds the unit forces of a contact's points, as columns.
void StaticEquilibrium::add_columns(const World& world, const BalanceTask& task, int which) {
  const Contact& contact = task.contacts[idx(which)];
  const int edges = pushes_of(task, contact) / std::max(contact.count, 1);
  const auto [u, v] = across(contact.normal_w);
  for (int p = 0; p < contact.count; ++p) {
    for (int e = 0; e < edges; ++e) {
      Vec3 push_w = contact.normal_w;
      if (edges > 1) {  // the edges of a pyramid within Coulomb's cone
        const double turn = 2.0 * std::numbers::pi * e / edges;
        push_w += contact.friction * (elementary::cos(turn) * u + elementary::sin(turn) * v);
      }
      const int column = static_cast<int>(push_place_.size());
      push_place_.push_back(first_push_[idx(which)] + p);
      push_of_w_.push_back(push_w);
      add_push(world, contact, contact.points[idx(p)].position_w, push_w, column);
    }
  }
}

void StaticEquilibrium::add_push(const World& world, const Contact& contact, const Vec3& point_w,
                                 const Vec3& push_w, int column) {
  add_push_on(world, contact.second, point_w, push_w, column);
  add_push_on(world, contact.first, point_w, -push_w, column);
}

void StaticEquilibrium::add_push_on(const World& world, int body, const Vec3& point_w,
                                    const Vec3& push_w, int column) {
  const int slot = slot_[idx(body)];
  if (slot < 0) return;  // held
  const Vec3 arm_w = point_w - world.states()[idx(body)].position_w;
  G_.block<3, 1>(6 * slot, column) = -push_w / std::sqrt(world.bodies()[idx(body)].mass);
  G_.block<3, 1>(6 * slot + 3, column) =
      -(root_inertia_w_[idx(body)].transpose() * arm_w.cross(push_w));
}

// Stores the residual as accelerations; the island is in equilibrium if they are at rounding level.
void StaticEquilibrium::take(const World& world, const BalanceTask& task, int island,
                             double scale) {
  const std::span<const int> members = islands_.bodies(island);
  for (std::size_t j = 0; j < push_place_.size(); ++j)
    forces_w_[idx(push_place_[j])] += result_.f[j] * push_of_w_[j];
  // The rounding of a contact force can accelerate a light body.
  for (const int c : islands_.contacts(island)) {
    const Contact& contact = task.contacts[idx(c)];
    for (int p = 0; p < contact.count; ++p) {
      const double push = forces_w_[idx(first_push_[idx(c)] + p)].norm();
      pushed_[idx(contact.first)] += push;
      pushed_[idx(contact.second)] += push;
    }
  }
  bool balanced = true;
  for (const int b : members) {
    const BodyProperties& body = world.bodies()[idx(b)];
    Acceleration& a = motion_[idx(b)];
    const int row = 6 * slot_[idx(b)];
    const auto rest = [&](int k) {
      return Vec3(result_.rest[idx(row + k)], result_.rest[idx(row + k + 1)],
                  result_.rest[idx(row + k + 2)]);
    };
    a.linear_w = rest(0) / std::sqrt(body.mass);
    a.angular_w = root_inertia_w_[idx(b)] * rest(3);
    const double fastest = a.linear_w.norm() + 0.5 * body.size.norm() * a.angular_w.norm();
    const double rounding = tolerance::rounding * pushed_[idx(b)] / body.mass;
    if (!(fastest <= tolerance::exact_balance * scale + rounding)) balanced = false;
  }
  for (const int b : members) balanced_[idx(b)] = balanced ? 1 : 0;
  report_.balanced = report_.balanced && balanced;
}

}  // namespace tumble
