/// \file
/// \brief A check of a run by any technique: no body passes through another one.
#include "tumble/record/passage_check.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/geometry/swept.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/overlap.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble {
namespace {

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

// The rotation vector that takes one orientation to another, of all that do the nearest to a guess.
Vec3 turn_near(const Quat& from, const Quat& to, const Vec3& guess_w) {
  const Vec3 shortest_w = rotation_vector(to * from.conjugate());
  const double angle = shortest_w.norm();
  if (!(angle > 0.0)) return shortest_w;
  const Vec3 axis_w = shortest_w / angle;
  return shortest_w + 2.0 * std::numbers::pi *
                          std::round((guess_w.dot(axis_w) - angle) / (2.0 * std::numbers::pi)) *
                          axis_w;
}

}  // namespace

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
  look_for_turns(world);
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
    note_entered(world, a, b);
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

// Two bodies that the step has brought into each other.
void PassageCheck::note_entered(const World& world, std::size_t first, std::size_t second) {
  const auto entering = [&](std::size_t k) { return Entering{k, before_[k], turn_of(world, k)}; };
  entered_.push_back({entering(first), entering(second)});
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
    note_entered(world, a, b);
  }
}

// How a body turned: at the rate of its angular velocity before or after, whichever leads to where it is.
PassageCheck::Turn PassageCheck::turn_in_step(const World& world, std::size_t k) const {
  Turn turn;
  turn.doubt = std::numeric_limits<double>::infinity();
  for (const BodyState& state : {before_[k], world.states()[k]}) {
    const Vec3 guess_w = (world.time() - time_) * angular_velocity(world.bodies()[k], state);
    const Vec3 found_w =
        turn_near(before_[k].orientation_wb, world.states()[k].orientation_wb, guess_w);
    const double doubt = (found_w - guess_w).norm();
    if (doubt < turn.doubt) turn = {found_w, doubt};
  }
  return turn;
}

// Pairs of which a body turns by more than its core would stand: the step in parts, in each a straight way of cores.
void PassageCheck::look_for_turns(const World& world) {
  solid_.clear();
  swept_.clear();
  turns_.clear();
  bool any = false;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const Vec3 way_w = world.states()[k].position_w - before_[k].position_w;
    if (body.shape == Shape::ground || !way_w.allFinite()) continue;
    const double reach = 0.5 * body.size.norm();
    Turn turn{Vec3::Zero(), turn_of(world, k)};
    if (turn.doubt * reach > 0.5 * body.size.minCoeff()) turn = turn_in_step(world, k);
    any = any || !turn.turn_w.isZero(0.0);
    solid_.push_back(k);
    turns_.push_back(turn);
    const Vec3 all_ways = Vec3::Constant(reach);
    swept_.push_back(
        widened({before_[k].position_w - all_ways, before_[k].position_w + all_ways}, way_w));
  }
  if (!any) return;
  near_.find_pairs(swept_, pairs_);
  for (const IndexPair& pair : pairs_) {
    const std::size_t a = solid_[idx(pair.first)];
    const std::size_t b = solid_[idx(pair.second)];
    const bool neither =
        turns_[idx(pair.first)].turn_w.isZero(0.0) && turns_[idx(pair.second)].turn_w.isZero(0.0);
    if (neither || world.joined(world.ids()[a], world.ids()[b])) continue;
    if (!turns_into(world, a, turns_[idx(pair.first)], b, turns_[idx(pair.second)])) continue;
    const auto now = [&](std::size_t k) {
      return core_of(world.bodies()[k], world.states()[k], 0.0);
    };
    if (separation(now(a), now(b)).distance < 0.0) {
      note_entered(world, a, b);
      continue;
    }
    find_passage(world, a, b);
    return;
  }
}

// Whether the cores of two bodies that are apart at the start meet on the way.
bool PassageCheck::turns_into(const World& world, std::size_t first, const Turn& turn_of_first,
                              std::size_t second, const Turn& turn_of_second) const {
  const auto parts_for = [&](std::size_t k, const Turn& turn) {
    const Vec3& size = world.bodies()[k].size;
    return 0.5 * turn.turn_w.norm() * size.norm() / (tolerance::turn_in_part * size.minCoeff());
  };
  const int parts = static_cast<int>(
      std::clamp(std::max(parts_for(first, turn_of_first), parts_for(second, turn_of_second)), 1.0,
                 static_cast<double>(tolerance::most_parts_of_way)));
  const double share = 1.0 / parts;
  const auto way_of = [&](std::size_t k) -> Vec3 {
    return world.states()[k].position_w - before_[k].position_w;
  };
  const auto at = [&](std::size_t k, const Turn& turn, int part) {
    BodyState state = before_[k];
    state.position_w += part * share * way_of(k);
    state.orientation_wb = turned(state.orientation_wb, turn.turn_w, part * share);
    return core_of(world.bodies()[k], state, share * turn.turn_w.norm() + turn.doubt);
  };
  for (int part = 0; part < parts; ++part) {
    const SweepResult swept = sweep(at(first, turn_of_first, part), share * way_of(first),
                                    at(second, turn_of_second, part), share * way_of(second));
    if (swept.status != SweepStatus::no_hit)
      return part > 0 || swept.status != SweepStatus::overlapping_at_start;
  }
  return false;
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

}  // namespace tumble
