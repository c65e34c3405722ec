/// \file
/// \brief Potential energy minimised step by step, without velocities.
#include "tumble/previous_work/settling.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tumble {
namespace {

constexpr int kMostRounds = 5;  // of a step; each shortens the fall by what was too far

}  // namespace

Settling::Settling(const SettlingOptions& options) : options_(options) {
  require::positive(options.reach, "reach");
  require::that(options.budget >= 1,
                "budget = " + std::to_string(options.budget) + ": expected 1 or more");
}

std::vector<std::string> Settling::ignores(const World&) const {
  return {"velocities", "friction", "restitution"};
}

StepReport Settling::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  const double energy = energy_of(world).total();
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    world.states()[k].linear_momentum_w.setZero();
    world.states()[k].angular_momentum_w.setZero();
  }
  const double gravity = world.gravity_w.norm();
  const double reach = options_.reach * movable_edge(world);
  double time_squared = gravity > 0.0 ? reach / gravity : 0.0;  // [s²] τ²
  load_moving_bodies(world, still_);
  points_.find(world, still_, 2.0 * reach, report);  // both bodies may move as far as they may

  // [S2.7.1:step]
  // A free body would fall by τ² g. The nearest displacements to that with which no point goes in are the minimum. If they leave
  // the trust region, once more with a shorter fall.
  double share = 1.0;
  for (int round = 0; round < kMostRounds; ++round) {
    time_squared *= share;
    moving_ = still_;
    for (std::size_t k = 0; k < moving_.size(); ++k)
      if (world.bodies()[k].movable()) moving_[k].velocity_w = time_squared * world.gravity_w;
    points_.scale_impulses(last_time_squared_ > 0.0 ? time_squared / last_time_squared_ : 0.0);
    last_time_squared_ = time_squared;
    const DescentReport found = program_.solve(moving_, points_.contacts(), points_.gaps(),
                                               tolerance::settling_step, options_.budget);
    report.iterations += found.iterations;
    share = std::min(1.0, reach / farthest_move(world, moving_));
    if (share == 1.0) break;
  }
  move_bodies(moving_, share, world);
  // [S2.7.1:step]

  records_.clear();
  for (const Contact& contact : std::as_const(points_).contacts()) {
    for (int k = 0; k < contact.count; ++k) {
      if (!(contact.points[idx(k)].normal_impulse > 0.0)) continue;
      ContactRecord& record = records_.emplace_back(record_of(contact, k, world.time()));
      record.push_w = time_squared > 0.0 ? Vec3(record.push_w / time_squared) : Vec3::Zero();
      record.is_impulse = false;
      ++report.impulses;
    }
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
  report.energy.damping = energy_of(world).total() - energy;
  world.finish_step(dt);
  return report;
}

}  // namespace tumble
