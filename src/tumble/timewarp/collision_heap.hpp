/// \file
/// \brief Collisions that are foreseen, the earliest first (thesis A.1: collisionHeap).
#pragma once

#include "tumble/geometry/broad_phase.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// A collision of two bodies, if neither meets anybody else before.
struct ForeseenCollision {
  double time = 0.0;  ///< [s] since the start of the frame
  IndexPair pair;     ///< who
};

/// Whether two foreseen collisions are the same.
/// \param a  the one
/// \param b  the other
/// \return true if pair and time agree
inline bool operator==(const ForeseenCollision& a, const ForeseenCollision& b) {
  return a.time == b.time && a.pair == b.pair;
}

/// The order in which foreseen collisions happen: by time, and by indices at one time.
/// \param a  the one
/// \param b  the other
/// \return true if a comes before b
inline bool operator<(const ForeseenCollision& a, const ForeseenCollision& b) {
  return a.time != b.time ? a.time < b.time : a.pair < b.pair;
}

/// The queue of a timewarp: gives the earliest collision, and forgets those of a body at once.
///
/// A body whose way has changed makes everything wrong that was foreseen for it. Entries remember
/// how often their bodies had been forgotten; those from before are left where they are and skipped
/// when they come to the top.
/// \par Cost and determinism
/// O(log n) to insert and to remove the first, O(1) to forget a body. The order of insertion does not
/// matter. No allocation once warm.
/// \algorithm{The queue of collisions: appendix A.1}
/// \verified{The queue gives the earliest collision and forgets those of a body}
class CollisionHeap {
 public:
  /// Empties it.
  /// \param bodies  how many there are
  void reset(int bodies);

  /// Adds a collision.
  /// \param collision  its bodies are below the number given to reset()
  void insert(const ForeseenCollision& collision);

  /// Forgets all collisions of a body.
  /// \param body its index
  void forget(int body);

  /// Whether nothing is foreseen any more.
  /// \return true if so
  [[nodiscard]] bool empty() const { return heap_.empty(); }

  /// The earliest collision.
  /// \return it; there must be one
  [[nodiscard]] const ForeseenCollision& first() const { return heap_.front().collision; }

  /// Takes the earliest collision out.
  /// \return it; there must be one
  ForeseenCollision remove_first();

  /// All that is foreseen, for whoever wants to look.
  /// \return in their order. Allocates
  [[nodiscard]] std::vector<ForeseenCollision> entries() const;

 private:
  struct Entry {
    ForeseenCollision collision;
    std::uint32_t first_forgotten = 0;  // how often its first body had been forgotten
    std::uint32_t second_forgotten = 0;
  };
  static bool later(const Entry& a, const Entry& b) { return b.collision < a.collision; }
  [[nodiscard]] bool valid(const Entry& entry) const;
  void drop_forgotten();

  std::vector<Entry> heap_;               // the first one is always valid
  std::vector<std::uint32_t> forgotten_;  // by body: how often
};

}  // namespace tumble
