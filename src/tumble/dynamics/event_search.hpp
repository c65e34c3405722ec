/// \file
/// \brief The first collision among many bodies in flight (thesis 3.3.1).
#pragma once

#include "tumble/dynamics/pair_search.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// A pair that overlaps when a search begins.
struct StartOverlap {
  IndexPair pair;          ///< the two
  double gap = 0.0;        ///< [m] below 0: how deep
  bool deepening = false;  ///< whether they are deeper in one resolution later
};

/// The first collision of an interval, and what it took to find it.
struct FirstEvent {
  /// none, found or cap_reached; pairs that overlap at the start are listed apart, below.
  CollisionStatus status = CollisionStatus::none;
  /// [s] found: the last time at which all searched pairs are known to be apart; none: the end;
  /// cap_reached: a time at which they are apart and up to which no collision is known
  double time = 0.0;
  /// Found: all pairs of the event, sorted.
  std::vector<IndexPair> touching;
  /// Pairs that overlap at the start, sorted. They are not searched: a bisection would give them
  /// the start itself, for ever. Their owner treats them as contacts.
  std::vector<StartOverlap> overlapping_at_start;
  std::int64_t pair_tests = 0;   ///< separations computed in all
  std::int64_t evaluations = 0;  ///< those of them that narrowed down a time
  std::int64_t restarts = 0;     ///< searches begun again for a pair that collides earlier
};

/// Searches the first collision among pairs of bodies in flight.
///
/// The discrete search is the thesis's: if a pair overlaps at the end of the interval its time is
/// found by bisection; then all other pairs are tested at that time, and if one of them overlaps
/// already, it collided earlier and the search begins again with that pair and an interval that
/// ends there. The conservative search takes the earliest time of all pairs and needs no restarts.
///
/// **Ties.** Whatever begins to overlap within one resolution after `time` belongs to the same
/// event: the pair that gave the time and every pair that overlaps (discrete) or was found to
/// (conservative) by `time` + resolution. So a box that lands flat on two boxes is one event with
/// two pairs, whatever the order of the candidates. They are sorted by index, which is the order
/// of the ids, and are meant to be resolved together.
///
/// **Progress.** A search that starts at the time of the last event does not overlap, but it finds
/// the same pair again at once if that still approaches. Bodies at rest on one another do so in
/// every step. The caller leaves out pairs in resting contact, and caps the events of a step.
///
/// Holds buffers only; results do not depend on earlier searches. Does not allocate when there are
/// not more pairs than before.
/// \algorithm{The search for a collision that starts again for a missed third body: section 3.3.1}
/// \verified{A third body that collided earlier restarts the discrete search}
class EventSearch {
 public:
  /// Searches.
  /// \param candidates  pairs that may collide, in any order; two immovable bodies are skipped
  /// \param start       [s] start of the interval, not before any valid time
  /// \param end         [s] its end
  /// \return the first event; valid until the next search
  /// \throws std::invalid_argument for a flight, an interval or options as require_valid() refuses
  ///         them, or a pair that does not name two bodies, the smaller index first
  /// \par Cost
  /// Discrete, per search: 2 separations per pair, and per restart one more per pair and
  /// ⌈log2(interval / resolution)⌉.
  const FirstEvent& find(const Flight& flight, std::span<const IndexPair> candidates, double start,
                         double end, const SearchOptions& options = {});

 private:
  struct Candidate {
    IndexPair pair;
    double time = 0.0;
  };

  void sort_out_overlaps(const Flight& flight, std::span<const IndexPair> candidates, double start,
                         const SearchOptions& options);
  double gap(const Flight& flight, const IndexPair& pair, double time);
  bool overlap(const Flight& flight, const IndexPair& pair, double time);
  const BodyState& state(const Flight& flight, int body, double time);
  void search_discretely(const Flight& flight, double start, double end,
                         const SearchOptions& options);
  const IndexPair* first_overlap(const Flight& flight, double time, const IndexPair* except);
  void search_conservatively(const Flight& flight, double start, double end,
                             const SearchOptions& options);

  FirstEvent event_;
  std::vector<IndexPair> apart_;  // the candidates that are apart at the start, sorted
  std::vector<Candidate> found_;  // conservative: every collision found
  // Where bodies are at the time that was last asked for, which is asked for again for all their pairs.
  std::vector<BodyState> states_;
  std::vector<double> times_;
};

}  // namespace tumble
