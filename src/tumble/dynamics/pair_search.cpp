/// \file
/// \brief The time at which two bodies in flight begin to overlap (thesis 3.2, 3.3.1, 5.1).
#include "tumble/dynamics/pair_search.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/safe_flight.hpp"

#include <algorithm>
#include <string>

namespace tumble {

void require_valid(const SearchOptions& options, double start, double end) {
  require::finite(start, "start");
  require::finite(end, "end");
  require::positive(options.resolution, "options.resolution");
  // Messages are made only when they are needed: nothing is allocated in a search that goes well.
  if (start > end)
    refuse("end = " + shortest_text(end) + ": expected at least start = " + shortest_text(start));
  if (start + options.resolution <= start || end + options.resolution <= end)
    refuse("options.resolution = " + shortest_text(options.resolution) +
           ": expected more than rounding at the times searched");
  if (options.cap < 2)
    refuse("options.cap = " + std::to_string(options.cap) + ": expected at least 2");
}

namespace {

// Overlap that is no more than rounding: a share of the longest edge of the bodies that move.
double rounding_of(const Flight& flight, const IndexPair& pair) {
  double size = 0.0;
  for (const int body : {pair.first, pair.second}) {
    const BodyProperties& properties = flight.bodies[static_cast<std::size_t>(body)];
    if (properties.movable()) size = std::max(size, properties.size.maxCoeff());
  }
  return tolerance::rounding_overlap * size;
}

}  // namespace

PairCollision bisect_collision(const Flight& flight, const IndexPair& pair, const Bracket& bracket,
                               const SearchOptions& options) {
  const auto gap = [&](double time) { return gap_at(flight, pair, time).distance; };
  const BisectionResult result = bisect(gap, bracket, options.resolution, options.cap);
  PairCollision out;
  out.status =
      result.status == SearchStatus::found ? CollisionStatus::found : CollisionStatus::cap_reached;
  // The separated end, not the middle and not the other one: bodies that were put into overlap
  // would be found at the same time again and again.
  out.time = result.bracket.low;
  out.overlap_time = result.bracket.high;
  out.evaluations = result.evaluations;
  return out;
}

PairCollision advance_to_collision(const Flight& flight, const IndexPair& pair, double start,
                                   double end, const SearchOptions& options) {
  PairCollision out{.time = start};
  Separation gap = gap_at(flight, pair, start);
  ++out.evaluations;
  // Bodies that touch and hardly move against each other would be followed resolution by resolution. An
  // overlap of rounding size may be passed over.
  const double rounding = rounding_of(flight, pair);
  while (out.time < end) {
    if (out.evaluations >= options.cap) {
      out.status = CollisionStatus::cap_reached;
      return out;
    }
    // The plane between the bodies keeps them apart for the time that they need at least to close
    // the gap along its normal. When that is less than the resolution, look there: a gap that is
    // small but opening is left behind, and one that closes has been found.
    gap.distance = std::max(gap.distance, rounding);
    const double safe = safe_flight(flight, pair, gap, out.time, end);
    const double next = std::min(end, out.time + std::max(safe, options.resolution));
    gap = gap_at(flight, pair, next);
    ++out.evaluations;
    if (gap.distance < 0.0) {
      // A safe time that was used in full may end, by rounding, on the wrong side.
      const int before = out.evaluations;
      out = bisect_collision(flight, pair, Bracket{out.time, next}, options);
      out.evaluations += before;
      return out;
    }
    out.time = next;
  }
  return out;
}

PairCollision find_collision(const Flight& flight, const IndexPair& pair, double start, double end,
                             const SearchOptions& options) {
  require_valid(flight, start);
  require_valid(options, start, end);

  PairCollision out{.time = start, .evaluations = 1};
  if (gap_at(flight, pair, start).distance < 0.0) {
    out.status = CollisionStatus::overlapping_at_start;
    return out;
  }
  if (options.method == SearchMethod::conservative)
    return advance_to_collision(flight, pair, start, end, options);

  out.evaluations = 2;
  if (gap_at(flight, pair, end).distance >= 0.0) {
    out.time = end;
    return out;
  }
  out = bisect_collision(flight, pair, Bracket{start, end}, options);
  out.evaluations += 2;
  return out;
}

}  // namespace tumble
