/// \file
/// \brief The time at which two bodies in flight begin to overlap (thesis 3.2, 3.3.1, 5.1).
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/math/bracket.hpp"

namespace tumble {

/// How times of collisions are searched for.
enum class SearchMethod : std::uint8_t {
  /// The thesis's (3.2, 3.3.1): only the end of the interval is tested for overlap, and the time
  /// in between is found by bisection. Bodies that meet and part again within the interval, or
  /// change places, are missed.
  discrete,
  /// Conservative advancement (the thesis names swept volumes, 3.2 and 5.1): time goes on by what
  /// surely is free of contact, so that no overlap of `resolution` or longer is missed, unless it is
  /// no deeper than rounding. Bodies that turn at a constant rate, as cubes do, are found in a few
  /// steps (see safe_flight()). For others it needs to know how fast they can turn, and knows it
  /// well for the rotation rules `splitting` and `frozen`; with the other two, long bars that spin
  /// cost a hundred times more.
  conservative
};

/// How closely, and for how long, to search.
struct SearchOptions {
  SearchMethod method = SearchMethod::discrete;     ///< how
  double resolution = tolerance::event_resolution;  ///< [s] above 0: how closely times are found
  int cap = 1000;  ///< most separations computed for one pair, and most restarts of an event search
};

/// How a search ended.
enum class CollisionStatus : std::uint8_t {
  none,                  ///< no collision until the end
  found,                 ///< a collision, see the time
  overlapping_at_start,  ///< the bodies overlap to begin with: not a collision to be found
  cap_reached            ///< not finished; the bodies are apart at the time
};

/// When two bodies begin to overlap.
struct PairCollision {
  CollisionStatus status = CollisionStatus::none;  ///< how the search ended
  /// [s] found: the last time known to be separated, gap >= 0, so that bodies put there do not
  /// overlap and the search can go on from there; none: the end; overlapping_at_start: the start
  double time = 0.0;
  double overlap_time = 0.0;  ///< [s] found: they overlap here, at most `resolution` later
  int evaluations = 0;        ///< separations computed
};

/// Checks the options of a search.
/// \param start    [s] start of the interval
/// \param end      [s] its end
/// \throws std::invalid_argument for an interval that is not finite or ends before it starts, a
///         cap below 2, or a resolution that is not above 0 or too small to show in the times
void require_valid(const SearchOptions& options, double start, double end);

/// Finds when two bodies in flight begin to overlap.
///
/// Overlap is a gap below 0; bodies that touch exactly do not overlap. A pair that rests on one
/// another and is pressed together "collides" at once, at the start: leave it out, it is a contact.
/// \param start  [s] from when, not before their valid times
/// \param end    [s] until when
/// \throws std::invalid_argument as require_valid() does, for both
/// \par Cost
/// Discrete: 2 + ⌈log2((end - start) / resolution)⌉ separations if there is a collision, else 2.
/// Conservative: a few for bodies that do not turn; more, the faster they spin and the longer they
/// stay close.
PairCollision find_collision(const Flight& flight, const IndexPair& pair, double start, double end,
                             const SearchOptions& options = {});

/// Bisection between a time at which two bodies are apart and one at which they overlap.
/// \param bracket  [s] apart at low, overlapping at high
/// \return found, or cap_reached
PairCollision bisect_collision(const Flight& flight, const IndexPair& pair, const Bracket& bracket,
                               const SearchOptions& options);

/// Conservative advancement of two bodies that are apart at the start.
///
/// A separating direction found at one time stays one for as long as the bodies cannot close their gap
/// along it, so the time may be advanced by that much and the gap measured again.
/// \param start    [s] from when
/// \return found, none, or cap_reached
/// \see Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, PhD thesis, 1996.
/// \algorithm{Swept volumes: section 3.2}
/// \verified{Between two spinning bars no overlap is missed that a fine grid of times shows}
PairCollision advance_to_collision(const Flight& flight, const IndexPair& pair, double start,
                                   double end, const SearchOptions& options);

}  // namespace tumble
