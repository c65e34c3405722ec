/// \file
/// \brief The time of the next collision among bodies that fly and bodies that rest.
#include "tumble/analytic_lcp/impact_search.hpp"

#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/index.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/geometry/swept.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tumble {
namespace {

// Whether a point is below the surface and still goes down.
bool sinks(const Contact& contact, const TouchScale& scale) {
  const auto end = contact.points.begin() + contact.count;
  return std::any_of(contact.points.begin(), end, [&](const ContactPoint& point) {
    return point.distance < 0.0 && point.approach_speed < -scale.resting_speed;
  });
}

}  // namespace

FirstImpact ImpactSearch::find(const ForcedFlight& flight, const ImpactSearchTask& task,
                               World& world) {
  FirstImpact result;
  near_.clear();
  for (const Contact& contact : task.near) near_.push_back({contact.first, contact.second});
  far_.clear();
  std::set_difference(task.candidates.begin(), task.candidates.end(), near_.begin(), near_.end(),
                      std::back_inserter(far_));

  // [S3.3.1:halving]
  // Which pairs have met by the end? Then halve the interval between
  // a time when none had and one when some had. All that may be the
  // first are looked at each time, so no third body is missed.
  double before = 0.0;
  double after = task.end;
  involve_all(world);
  // A pair that meets and parts before the end is looked at in the middle of its passage, too.
  list_passages(flight, task.end, world);
  for (const double time : passages_) {
    if (!look(flight, task, time, world, result)) {
      before = time;
    } else if (!far_met_.empty() || passes(near_met_)) {
      after = time;
      result.found = true;
      break;
    }
  }
  result.found = (result.found || look(flight, task, after, world, result)) &&
                 narrow(flight, task, world, result);
  while (result.found && after - before > task.resolution) {
    const double middle = 0.5 * (before + after);
    if (middle == before || middle == after) break;  // no number in between
    const bool met = look(flight, task, middle, world, result);
    (met ? after : before) = middle;
    if (met) keep_those_that_met();
  }
  // [S3.3.1:halving]
  result.time = after;
  std::copy(flight.start().begin(), flight.start().end(), world.states().begin());
  return result;
}

// Whether one of these is looked at all along.
bool ImpactSearch::passes(std::span<const IndexPair> met) const {
  return std::any_of(met.begin(), met.end(), [&](const IndexPair& pair) {
    return std::find(through_.begin(), through_.end(), pair) != through_.end();
  });
}

// Ascending times at which pairs would be in the middle of their passage if they went straight, without turning, and
// only gravity acted. Pairs of which a body turns far, or that touch at the start and go far, are looked at all along.
void ImpactSearch::list_passages(const ForcedFlight& flight, double end, const World& world) {
  passages_.clear();
  through_.clear();
  way_w_.resize(idx(world.count()));
  turned_.assign(way_w_.size(), 0.0);
  bool fast = false;
  for (std::size_t k = 0; k < way_w_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    way_w_[k].setZero();
    if (!body.movable()) continue;
    way_w_[k] = end * (velocity(body, flight.start()[k]) + 0.5 * end * world.gravity_w);
    turned_[k] = 0.5 * body.size.norm() * end * angular_velocity(body, flight.start()[k]).norm();
    fast = fast || way_w_[k].norm() + turned_[k] > 0.5 * body.size.minCoeff();
  }
  if (!fast) return;
  for (const IndexPair& pair : far_) list_passage(flight, pair, end, world);
  for (const IndexPair& pair : near_) list_looks(pair, end, world);
  std::sort(passages_.begin(), passages_.end());
}

void ImpactSearch::list_passage(const ForcedFlight& flight, const IndexPair& pair, double end,
                                const World& world) {
  const std::size_t i = idx(pair.first);
  const std::size_t j = idx(pair.second);
  const BodyProperties& a = world.bodies()[i];
  const BodyProperties& b = world.bodies()[j];
  if (a.shape == Shape::ground || b.shape == Shape::ground) return;
  const SweepResult way =
      sweep(box_of(a, flight.start()[i]), way_w_[i], box_of(b, flight.start()[j]), way_w_[j]);
  // What turns far may be apart at the end where without turning it would not be.
  const bool turns = turned_[i] + turned_[j] > 0.5 * std::min(a.size.minCoeff(), b.size.minCoeff());
  if (way.status == SweepStatus::hit && (way.leave < 1.0 || turns))
    passages_.push_back(0.5 * (way.enter + std::min(way.leave, 1.0)) * end);
  // A thin part of it may pass beside the straight way, too.
  if (turns) list_looks(pair, end, world);
}

// So many that no point comes half through between two of them.
void ImpactSearch::list_looks(const IndexPair& pair, double end, const World& world) {
  constexpr double kMostLooks = 64.0;
  const std::size_t i = idx(pair.first);
  const std::size_t j = idx(pair.second);
  const BodyProperties& a = world.bodies()[i];
  const BodyProperties& b = world.bodies()[j];
  if (a.shape == Shape::ground || b.shape == Shape::ground) return;
  const double half = 0.5 * std::min(a.size.minCoeff(), b.size.minCoeff());
  const double motion = (way_w_[i] - way_w_[j]).norm() + turned_[i] + turned_[j];
  const double looks = std::min(kMostLooks, std::ceil(motion / half));
  if (!(looks > 1.0)) return;
  through_.push_back(pair);
  for (double k = 1.0; k < looks; ++k) passages_.push_back(k / looks * end);
}

void ImpactSearch::involve_all(const World& world) {
  involved_.clear();
  for (int b = 0; b < world.count(); ++b) involved_.push_back(b);
  load_moving_bodies(world, moving_);
}

// Finds the pairs that have met at a time; whether there are any.
bool ImpactSearch::look(const ForcedFlight& flight, const ImpactSearchTask& task, double time,
                        World& world, FirstImpact& result) {
  ++result.evaluations;
  for (const int b : involved_) {
    flight.put(world, b, time, task.rule);
    const BodyProperties& body = world.bodies()[idx(b)];
    const BodyState& state = world.states()[idx(b)];
    moving_[idx(b)].velocity_w = velocity(body, state);
    moving_[idx(b)].angular_velocity_w = angular_velocity(body, state);
    moving_[idx(b)].position_w = state.position_w;
  }
  near_met_.clear();
  result.pair_tests += gather_contacts(world, moving_, near_, 0.0, task.near, overlaps_).pair_tests;
  for (const Contact& contact : overlaps_)
    if (sinks(contact, touch_scale(world, contact.first, contact.second, task.dt)))
      near_met_.push_back({contact.first, contact.second});
  far_met_.clear();
  for (const IndexPair& pair : far_) {
    const std::size_t i = idx(pair.first);
    const std::size_t j = idx(pair.second);
    if (!world.bodies()[i].movable() && !world.bodies()[j].movable()) continue;
    ++result.pair_tests;
    const Separation gap =
        gap_between(world.bodies()[i], world.states()[i], world.bodies()[j], world.states()[j]);
    if (gap.distance < 0.0) far_met_.push_back(pair);
  }
  return !near_met_.empty() || !far_met_.empty();
}

// From here on only these can be the first.
void ImpactSearch::keep_those_that_met() {
  near_.swap(near_met_);
  far_.swap(far_met_);
  involved_.clear();
  for (const std::vector<IndexPair>* pairs : {&near_, &far_})
    for (const IndexPair& pair : *pairs)
      involved_.insert(involved_.end(), {pair.first, pair.second});
  std::sort(involved_.begin(), involved_.end());
  involved_.erase(std::unique(involved_.begin(), involved_.end()), involved_.end());
}

// Keeps the pairs that have met by the end. Those that go down at the start already, as an impact
// left them whose friction has not settled, are not among them: contact forces will stop them.
bool ImpactSearch::narrow(const ForcedFlight& flight, const ImpactSearchTask& task, World& world,
                          FirstImpact& result) {
  keep_those_that_met();
  if (!look(flight, task, 0.0, world, result)) return true;
  const auto take_out = [](std::vector<IndexPair>& pairs, const std::vector<IndexPair>& met) {
    const auto is_met = [&](const IndexPair& pair) {
      return std::find(met.begin(), met.end(), pair) != met.end();
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_met), pairs.end());
  };
  take_out(near_, near_met_);
  take_out(far_, far_met_);
  return !near_.empty() || !far_.empty();
}

}  // namespace tumble
