/// \file
/// \brief Checks of a run that know no technique: what no scene can do.
#include "tumble/record/run_checks.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/geometry/swept.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/overlap.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

Energy energy_of_body(const World& world, std::size_t k) {
  return energy_of(world.bodies()[k], world.states()[k], world.gravity_w);
}

// The part of a body that stays inside it while it turns by an angle. A corner at |h| from the centre moves by at most
// angle · |h|; a cube within the largest ball inside stays there however far the body turns.
Box core_of(const BodyProperties& body, const BodyState& state, double angle) {
  Box core = box_of(body, state);
  const double ball = tolerance::core_share * core.half.minCoeff() / std::sqrt(3.0);
  core.half = tolerance::core_share * core.half - Vec3::Constant(angle * core.half.norm());
  if (core.half.minCoeff() < ball) core.half.setConstant(ball);
  return core;
}

Bounds widened(Bounds bounds, const Vec3& way_w) {
  bounds.low += way_w.cwiseMin(0.0);
  bounds.high += way_w.cwiseMax(0.0);
  return bounds;
}

}  // namespace

void RunCheck::find(const World& world, const std::string& what) {
  if (!message_.empty()) return;
  message_ = "step " + std::to_string(world.steps()) + " at " + rounded_text(world.time(), 6) +
             " s: " + what;
}

// --- energy -----------------------------------------------------------------------------------------

void EnergyCheck::begin(const World& world) {
  const double kinetic = energy_of(world).kinetic;
  weight_ = lifting_energy(world);
  time_ = world.time();
  energies_.resize(idx(world.count()));
  for (std::size_t k = 0; k < energies_.size(); ++k)
    energies_[k] = energy_of_body(world, k).total();
  allowed_ = std::max(allowed_, tolerance::energy_gain * (kinetic + weight_));
  kinetic_ = std::max(kinetic_, kinetic);
}

void EnergyCheck::on_begin(const World& world) {
  begin(world);
  start_ = energy_of(world).total();
}

void EnergyCheck::on_change(const World& world, double energy_added) {
  start_ += energy_added;
  begin(world);
}

void EnergyCheck::on_step(const World& world, const StepReport& report) {
  double total = 0.0;
  double kinetic = 0.0;
  double most = 0.0;
  double rounding = 0.0;  // [kg m²] m (ε (|x| + L))²
  std::size_t gainer = 0;
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const double off =
        tolerance::rounding * (world.states()[k].position_w.norm() + body.size.maxCoeff());
    if (body.movable()) rounding += body.mass * off * off;
    const Energy energy = energy_of_body(world, k);
    const double now = energy.total();
    total += now;
    kinetic += energy.kinetic;
    if (now - energies_[k] > most) {
      most = now - energies_[k];
      gainer = k;
    }
    energies_[k] = now;
  }
  kinetic_ = std::max(kinetic_, kinetic);
  booked_ += report.energy.total();
  const double gained = total - start_;
  const double unbooked = gained - booked_;
  const double dt = world.time() - time_;
  const double noise = 0.5 * rounding / (dt * dt);  // [J]
  time_ = world.time();
  status_ = StepStatus::done;
  if (!std::isfinite(total)) return;
  std::string what;
  if (gained > allowed_ + noise) {
    what = rounded_text(gained, 6) + " J above the start, which nothing in the scene can add";
  } else if (unbooked > tolerance::unbooked_gain * (kinetic_ + weight_) + noise) {
    what = rounded_text(unbooked, 6) + " J above what is left of the start's after all losses";
  } else {
    return;
  }
  status_ = StepStatus::energy_gained;
  find(world, "the total energy is " + rounded_text(total, 6) + " J, " + what + "; " +
                  world.name(static_cast<int>(gainer)) + " gained " + rounded_text(most, 6) +
                  " J in this step");
}

// --- passages ---------------------------------------------------------------------------------------

void PassageCheck::on_begin(const World& world) {
  time_ = world.time();
  before_.assign(world.states().begin(), world.states().end());
  last_before_ = before_;
  entered_.clear();
}

void PassageCheck::on_change(const World& world, double /*energy_added*/) { on_begin(world); }

void PassageCheck::on_step(const World& world, const StepReport& /*report*/) {
  status_ = StepStatus::done;
  fast_.assign(before_.size(), 0);
  bool any = false;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const double way = (world.states()[k].position_w - before_[k].position_w).norm();
    fast_[k] = way > 0.5 * world.bodies()[k].size.minCoeff() && std::isfinite(way) ? 1 : 0;
    any = any || fast_[k] != 0;
  }
  look_at_entered(world);
  if (any) look_for_passages(world);
  last_before_.swap(before_);
  last_time_ = time_;
  before_.assign(world.states().begin(), world.states().end());
  time_ = world.time();
}

// Pairs whose cores a slow step has brought into each other. Fast bodies have been looked at.
void PassageCheck::on_overlap(const World& world, double deepest) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const BodyProperties& body : world.bodies())
    if (body.shape != Shape::ground) shortest = std::min(shortest, body.size.minCoeff());
  if (!(deepest > (1.0 - tolerance::core_share) * shortest)) return;
  solid_.clear();
  swept_.clear();
  cores_.clear();
  for (std::size_t k = 0; k < before_.size(); ++k) {
    if (world.bodies()[k].shape == Shape::ground) continue;
    solid_.push_back(k);
    cores_.push_back(core_of(world.bodies()[k], world.states()[k], 0.0));
    swept_.push_back(bounds_of(cores_.back()));
  }
  near_.find_pairs(swept_, pairs_);
  before_.swap(last_before_);  // the start of the step, for turn_of()
  std::swap(time_, last_time_);
  for (const IndexPair& pair : pairs_) {
    const std::size_t a = solid_[idx(pair.first)];
    const std::size_t b = solid_[idx(pair.second)];
    const bool known = std::any_of(entered_.begin(), entered_.end(), [&](const Entered& e) {
      return e.first.body == a && e.second.body == b;
    });
    if (known || world.joined(world.ids()[a], world.ids()[b])) continue;
    if (!(separation(cores_[idx(pair.first)], cores_[idx(pair.second)]).distance < 0.0)) continue;
    const Box first = core_of(world.bodies()[a], before_[a], 0.0);
    const Box second = core_of(world.bodies()[b], before_[b], 0.0);
    if (separation(first, second).distance < 0.0) continue;
    entered_.push_back({{a, before_[a], turn_of(world, a)}, {b, before_[b], turn_of(world, b)}});
  }
  before_.swap(last_before_);
  std::swap(time_, last_time_);
}

void PassageCheck::find_passage(const World& world, std::size_t first, std::size_t second) {
  status_ = StepStatus::passed_through;
  find(world, world.name(static_cast<int>(first)) + " went through " +
                  world.name(static_cast<int>(second)) +
                  ": a smaller --dt or a technique that catches it is needed");
}

// [rad] how far a body turned in the step, at most.
double PassageCheck::turn_of(const World& world, std::size_t k) const {
  const BodyProperties& body = world.bodies()[k];
  const BodyState& after = world.states()[k];
  const double spin =
      std::max(angular_velocity(body, before_[k]).norm(), angular_velocity(body, after).norm());
  return std::max(angle_between(before_[k].orientation_wb, after.orientation_wb),
                  spin * (world.time() - time_));
}

// Pairs that a step left in each other: whether they are apart now, and where.
void PassageCheck::look_at_entered(const World& world) {
  const auto went_on = [&](Entering& of) -> Vec3 {
    of.turned += turn_of(world, of.body);
    return world.states()[of.body].position_w - of.before.position_w;
  };
  const auto now = [&](std::size_t k) {
    return core_of(world.bodies()[k], world.states()[k], 0.0);
  };
  const auto then = [&](const Entering& of) {
    return core_of(world.bodies()[of.body], of.before, of.turned);
  };
  std::erase_if(entered_, [&](Entered& pair) {
    const Vec3 way_of_first_w = went_on(pair.first);
    const Vec3 way_of_second_w = went_on(pair.second);
    if (!way_of_first_w.allFinite() || !way_of_second_w.allFinite()) return true;
    if (separation(now(pair.first.body), now(pair.second.body)).distance < 0.0) return false;
    const SweepResult swept =
        sweep(then(pair.first), way_of_first_w, then(pair.second), way_of_second_w);
    if (swept.status == SweepStatus::hit && swept.leave < 1.0)
      find_passage(world, pair.first.body, pair.second.body);
    return true;
  });
}

void PassageCheck::look_for_passages(const World& world) {
  const auto way = [&](std::size_t k) -> Vec3 {
    return world.states()[k].position_w - before_[k].position_w;
  };
  solid_.clear();
  cores_.clear();
  swept_.clear();
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.shape == Shape::ground) continue;
    const Box core = core_of(body, before_[k], turn_of(world, k));
    solid_.push_back(k);
    cores_.push_back(core);
    swept_.push_back(widened(bounds_of(core), way(k)));
  }
  near_.find_pairs(swept_, pairs_);
  for (const IndexPair& pair : pairs_) {
    const std::size_t a = solid_[idx(pair.first)];
    const std::size_t b = solid_[idx(pair.second)];
    if (fast_[a] == 0 && fast_[b] == 0) continue;
    if (world.joined(world.ids()[a], world.ids()[b])) continue;
    const SweepResult swept =
        sweep(cores_[idx(pair.first)], way(a), cores_[idx(pair.second)], way(b));
    if (swept.status != SweepStatus::hit) continue;
    if (swept.leave < 1.0) {
      find_passage(world, a, b);
      return;
    }
    entered_.push_back({{a, before_[a], turn_of(world, a)}, {b, before_[b], turn_of(world, b)}});
  }
}

void PassageCheck::at_end(const World& world) {
  OverlapMeter meter;
  meter.look(world);
  for (std::size_t k = 0; k < idx(world.count()); ++k) {
    const double depth = meter.depths()[k];
    const double edge = world.bodies()[k].size.minCoeff();
    if (world.bodies()[k].shape == Shape::ground || !(depth > tolerance::deep_overlap * edge))
      continue;
    status_ = StepStatus::passed_through;
    find(world, world.name(static_cast<int>(k)) + " is left " + rounded_text(depth, 3) +
                    " m deep in another body, " + rounded_text(100.0 * depth / edge, 2) +
                    " % of its shortest edge");
    return;
  }
}

// --- turning ----------------------------------------------------------------------------------------

void TurnCheck::on_begin(const World& world) { time_ = world.time(); }

void TurnCheck::on_step(const World& world, const StepReport& /*report*/) {
  const double dt = world.time() - time_;
  time_ = world.time();
  if (!message().empty()) return;
  for (std::size_t k = 0; k < idx(world.count()); ++k) {
    const double turn = dt * angular_velocity(world.bodies()[k], world.states()[k]).norm();
    if (!(turn > tolerance::most_turn)) continue;
    find(world,
         world.name(static_cast<int>(k)) + " rotates by " + rounded_text(turn, 3) +
             " rad in a step, and above 1 rad not every technique finds its contacts and keeps its "
             "energy: --dt " +
             rounded_text(0.5 * dt / turn, 2) + " is small enough");
    return;
  }
}

}  // namespace tumble
