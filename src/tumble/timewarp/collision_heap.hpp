/// \file
/// \brief Priority queue of predicted collisions, earliest first (thesis A.1: collisionHeap).
#pragma once

#include "tumble/geometry/broad_phase.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace tumble {

/// A collision that two bodies will have if neither collides with another body before.
struct ForeseenCollision {
  double time = 0.0;  ///< [s] since the start of the frame
  IndexPair pair;     ///< the two bodies

  /// Orders predicted collisions by time, then by the indices of the bodies.
  auto operator<=>(const ForeseenCollision&) const = default;
};

/// The queue of a timewarp: yields the earliest collision, and drops all collisions of a body at once.
///
/// When the velocity of a body changes, every collision predicted for it becomes invalid. Each entry
/// stores how often its bodies had been invalidated when it was inserted; outdated entries stay in the
/// heap and are skipped when they reach the top.
/// \par Cost and determinism
/// O(log n) to insert or to remove the first, O(1) to invalidate a body. The result does not depend on
/// the order of insertion. No allocation once warm.
/// \algorithm{The queue of collisions: appendix A.1}
/// \verified{The queue yields the earliest collision and drops those of a body}
class CollisionHeap {
 public:
  /// Empties the queue.
  void reset(int bodies);

  /// Adds a collision.
  /// \param collision  its indices are below the number given to reset()
  void insert(const ForeseenCollision& collision);

  /// Drops all collisions of a body.
  void forget(int body);

  /// Whether the queue is empty.
  [[nodiscard]] bool empty() const { return heap_.empty(); }

  /// The earliest collision; the queue must not be empty.
  [[nodiscard]] const ForeseenCollision& first() const { return heap_.front().collision; }

  /// Removes and returns the earliest collision; the queue must not be empty.
  ForeseenCollision remove_first();

  /// All predicted collisions, for observers, earliest first. Allocates.
  [[nodiscard]] std::vector<ForeseenCollision> entries() const;

 private:
  struct Entry {
    ForeseenCollision collision;
    std::uint32_t first_forgotten = 0;  // invalidations of its first body before it was inserted
    std::uint32_t second_forgotten = 0;
  };
  static bool later(const Entry& a, const Entry& b) { return b.collision < a.collision; }
  [[nodiscard]] bool valid(const Entry& entry) const;
  void drop_forgotten();

  std::vector<Entry> heap_;               // the first entry is always valid
  std::vector<std::uint32_t> forgotten_;  // by body: number of invalidations
};

}  // namespace tumble
