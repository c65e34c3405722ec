/// \file
/// \brief The first collision among many bodies in flight (thesis 3.3.1).
#include "tumble/dynamics/event_search.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace tumble {
namespace {

constexpr double kRounding = 1e-9;  // [-] of a distance: far above it

void require_pair(const IndexPair& pair, std::size_t bodies) {
  const bool good =
      0 <= pair.first && pair.first < pair.second && static_cast<std::size_t>(pair.second) < bodies;
  if (good) return;
  refuse("candidate (" + std::to_string(pair.first) + ", " + std::to_string(pair.second) +
         "): expected two indices below " + std::to_string(bodies) + ", the smaller one first");
}

}  // namespace

const FirstEvent& EventSearch::find(const Flight& flight, std::span<const IndexPair> candidates,
                                    double start, double end, const SearchOptions& options) {
  require_valid(flight, start);
  require_valid(options, start, end);
  event_.status = CollisionStatus::none;
  event_.time = end;
  event_.touching.clear();
  event_.overlapping_at_start.clear();
  event_.pair_tests = event_.evaluations = event_.restarts = 0;
  states_.resize(flight.bodies.size());
  times_.assign(flight.bodies.size(), std::numeric_limits<double>::quiet_NaN());

  sort_out_overlaps(flight, candidates, start, options);
  if (options.method == SearchMethod::discrete)
    search_discretely(flight, start, end, options);
  else
    search_conservatively(flight, start, end, options);
  return event_;
}

double EventSearch::gap(const Flight& flight, const IndexPair& pair, double time) {
  ++event_.pair_tests;
  return gap_between(flight.bodies[idx(pair.first)], state(flight, pair.first, time),
                     flight.bodies[idx(pair.second)], state(flight, pair.second, time))
      .distance;
}

// Boxes whose balls are apart are so too.
bool EventSearch::overlap(const Flight& flight, const IndexPair& pair, double time) {
  const BodyProperties& a = flight.bodies[idx(pair.first)];
  const BodyProperties& b = flight.bodies[idx(pair.second)];
  if (a.shape == Shape::box && b.shape == Shape::box) {
    const Vec3 between_w =
        state(flight, pair.second, time).position_w - state(flight, pair.first, time).position_w;
    const double reach = 0.5 * (1.0 + kRounding) * (a.size.norm() + b.size.norm());
    if (between_w.squaredNorm() > reach * reach) {
      ++event_.pair_tests;
      return false;
    }
  }
  return gap(flight, pair, time) < 0.0;
}

const BodyState& EventSearch::state(const Flight& flight, int body, double time) {
  if (times_[idx(body)] != time) {
    times_[idx(body)] = time;
    states_[idx(body)] = state_at(flight, body, time);
  }
  return states_[idx(body)];
}

// Pairs that overlap to begin with are a class of their own. The others are searched, in the order
// of their indices, so that the order of the candidates does not matter.
void EventSearch::sort_out_overlaps(const Flight& flight, std::span<const IndexPair> candidates,
                                    double start, const SearchOptions& options) {
  apart_.clear();
  for (const IndexPair& pair : candidates) {
    require_pair(pair, flight.bodies.size());
    const bool movable = flight.bodies[static_cast<std::size_t>(pair.first)].movable() ||
                         flight.bodies[static_cast<std::size_t>(pair.second)].movable();
    if (movable) apart_.push_back(pair);
  }
  std::sort(apart_.begin(), apart_.end());

  const auto overlaps = [&](const IndexPair& pair) {
    const double gap_now = gap(flight, pair, start);
    if (gap_now >= 0.0) return false;
    const double gap_soon = gap(flight, pair, start + options.resolution);
    event_.overlapping_at_start.push_back(StartOverlap{pair, gap_now, gap_soon < gap_now});
    return true;
  };
  apart_.erase(std::remove_if(apart_.begin(), apart_.end(), overlaps), apart_.end());
}

const IndexPair* EventSearch::first_overlap(const Flight& flight, double time,
                                            const IndexPair* except) {
  for (const IndexPair& pair : apart_)
    if (&pair != except && overlap(flight, pair, time)) return &pair;
  return nullptr;
}

void EventSearch::search_discretely(const Flight& flight, double start, double end,
                                    const SearchOptions& options) {
  // [S3.2]
  // Only the end of the interval is tested.
  const IndexPair* current = first_overlap(flight, end, nullptr);
  if (current == nullptr) return;
  // [S3.2]
  double overlap_time = end;
  while (true) {
    // When did this pair go from separation to overlap?
    const PairCollision collision =
        bisect_collision(flight, *current, Bracket{start, overlap_time}, options);
    event_.pair_tests += collision.evaluations;
    event_.evaluations += collision.evaluations;
    event_.time = collision.time;
    if (collision.status != CollisionStatus::found) break;

    // [S3.3.1:restart]
    // Did another pair collide earlier? Then this collision is dropped for that one. The interval
    // shrinks with every restart.
    const IndexPair* earlier = first_overlap(flight, event_.time, current);
    if (earlier == nullptr) {
      event_.status = CollisionStatus::found;
      break;
    }
    if (event_.restarts == options.cap) break;
    ++event_.restarts;
    current = earlier;
    overlap_time = event_.time;
    // [S3.3.1:restart]
  }
  if (event_.status != CollisionStatus::found) {
    event_.status = CollisionStatus::cap_reached;
    event_.time = start;
    return;
  }

  // Ties.
  const double last = std::min(end, event_.time + options.resolution);
  for (const IndexPair& pair : apart_)
    if (&pair == current || overlap(flight, pair, last)) event_.touching.push_back(pair);
}

void EventSearch::search_conservatively(const Flight& flight, double start, double end,
                                        const SearchOptions& options) {
  found_.clear();
  double first = std::numeric_limits<double>::infinity();
  double capped = std::numeric_limits<double>::infinity();
  for (const IndexPair& pair : apart_) {
    // No need to look further than what can still be first, or tie with it.
    const double last = std::min(end, first + options.resolution);
    const PairCollision collision = advance_to_collision(flight, pair, start, last, options);
    event_.pair_tests += collision.evaluations;
    event_.evaluations += collision.evaluations;
    if (collision.status == CollisionStatus::cap_reached) capped = std::min(capped, collision.time);
    if (collision.status != CollisionStatus::found) continue;
    found_.push_back(Candidate{pair, collision.time});
    first = std::min(first, collision.time);
  }
  if (capped < first) {
    event_.status = CollisionStatus::cap_reached;
    event_.time = capped;
    return;
  }
  if (found_.empty()) return;

  event_.status = CollisionStatus::found;
  event_.time = first;
  for (const Candidate& candidate : found_)
    if (candidate.time <= first + options.resolution) event_.touching.push_back(candidate.pair);
}

}  // namespace tumble
