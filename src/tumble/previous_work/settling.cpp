/// \file
/// \brief Potential energy minimised step by step, without velocities.
#include "tumble/previous_work/settling.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

constexpr int kMostRounds = 5;  // of a step; each shortens the fall by what was too far

// [m] how far a corner goes at most
double farthest_of(const World& world, std::span<const MovingBody> moving) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < moving.size(); ++k)
    farthest =
        std::max(farthest, moving[k].velocity_w.norm() + 0.5 * world.bodies()[k].size.norm() *
                                                             moving[k].angular_velocity_w.norm());
  return farthest;
}

// Where edges cross, bodies turn so far in a step that the faces beside them go in: their corners are points too.
void add_corners(const World& world, double margin, Contact& contact) {
  if (contact.axis == kNoAxis) return;  // one of the two is the ground
  const IndexPair pair{contact.first, contact.second};
  Manifold manifold;
  if (!touch_pair(world, world.states(), pair, margin, contact.axis, manifold)) return;
  const auto box = [&](int k) { return box_of(world.bodies()[idx(k)], world.states()[idx(k)]); };
  add_face_points(box(pair.first), box(pair.second), margin, manifold);
  set_points(manifold, contact);
}

}  // namespace

Settling::Settling(const SettlingOptions& options) : options_(options) {
  require::positive(options.reach, "reach");
  require::that(options.budget >= 1,
                "budget = " + std::to_string(options.budget) + ": expected 1 or more");
}

std::unique_ptr<Technique> Settling::clone() const { return std::make_unique<Settling>(*this); }

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
  find_contacts(world, reach, report);

  // [S2.7.1:step]
  // A free body would fall by τ² g. The nearest displacements to that with which no point goes in are the minimum. If they leave
  // the trust region, once more with a shorter fall.
  double share = 1.0;
  for (int round = 0; round < kMostRounds; ++round) {
    time_squared *= share;
    moving_ = still_;
    for (std::size_t k = 0; k < moving_.size(); ++k)
      if (world.bodies()[k].movable()) moving_[k].velocity_w = time_squared * world.gravity_w;
    scale_forces(time_squared);
    const DescentReport found =
        program_.solve(moving_, contacts_, gaps_, tolerance::settling_step, options_.budget);
    report.iterations += found.iterations;
    share = std::min(1.0, reach / farthest_of(world, moving_));
    if (share == 1.0) break;
  }
  move(share, world);
  // [S2.7.1:step]

  records_.clear();
  for (const Contact& contact : contacts_) {
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

// All points that come near each other when both bodies move as far as they may.
void Settling::find_contacts(const World& world, double reach, StepReport& report) {
  const double margin = 2.0 * reach;
  std::swap(previous_, contacts_);
  repair_bounds(world, margin, bounds_);
  near_.find_pairs(bounds_, pairs_);
  load_moving_bodies(world, still_);
  const GatherReport found = gather_contacts(world, still_, pairs_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = found.deepest_overlap;
  for (Contact& contact : contacts_) add_corners(world, margin, contact);
  carry_over_impulses(previous_, contacts_);
  gaps_.clear();
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) gaps_.push_back(contact.points[idx(k)].distance);
}

// The forces to start from, times τ².
void Settling::scale_forces(double time_squared) {
  const double share = last_time_squared_ > 0.0 ? time_squared / last_time_squared_ : 0.0;
  for (Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) contact.points[idx(k)].normal_impulse *= share;
  last_time_squared_ = time_squared;
}

void Settling::move(double share, World& world) const {
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    BodyState& state = world.states()[k];
    state.position_w += share * moving_[k].velocity_w;
    state.orientation_wb = turned(state.orientation_wb, moving_[k].angular_velocity_w, share);
  }
}

}  // namespace tumble
