/// \file
/// \brief Pairs that collide repeatedly in a frame and are deferred to its end.
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/timewarp/instant_impacts.hpp"

#include <vector>

namespace tumble {

/// Conditions under which a pair is deferred to the end of the frame.
struct ContactRule {
  double resolution = tolerance::event_resolution;  ///< [s] of the search for collisions
  /// Collisions of one pair in one frame after which it is always deferred, at least 1. Reason: with
  /// a restitution of 0.9 a ball bounces 87 times before the time between bounces falls from 10 ms to
  /// a microsecond.
  int pair_events = 100;
};

/// The pairs deferred to the end of the frame, so that a timewarp makes progress with resting contacts.
///
/// In the thesis's listings a resting pair collides infinitely often in a frame. Here a pair enters the
/// **contact stage** for the rest of the frame
/// - after a collision from which gravity would bring the two together again within one resolution
///   of the search: \f$2 v'_n/g \le\f$ resolution, with the separation velocity \f$v'_n\f$. So a
///   sequence of bounces ends where single bounces can no longer be resolved, and a resting pair enters
///   after one collision of small impulse;
/// - after `pair_events` collisions in the frame;
/// - when a search for its collision reaches its cap.
///
/// Pairs in the contact stage are not searched. They leave it when an impact changes the velocity of
/// one of their bodies by more than gravity does in a frame. At the end of the frame the remaining
/// pairs are resolved together, without restitution, with the bodies that touch them (see FrameEnd),
/// and their overlap is repaired.
/// \par Cost
/// O(log n) for a pair that has collided in the frame; no allocation once warm.
/// \verified{A train of bounces ends where its hops get shorter than the resolution}
class ContactStage {
 public:
  /// Makes an empty stage.
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event
  explicit ContactStage(const ContactRule& rule);

  /// Starts a frame: the stage is empty and all counts are 0.
  void begin();

  /// Counts a collision and decides whether its pair enters the stage.
  /// \param separation_speed  [m/s] after the collision, at the slowest point with an impulse
  /// \param gravity           [m/s²]
  bool count(const IndexPair& pair, double separation_speed, double gravity);

  /// Puts a pair into the stage.
  void defer(const IndexPair& pair);

  /// Whether a pair is in the stage; true: do not search it.
  [[nodiscard]] bool holds(const IndexPair& pair) const;

  /// Takes a body's pairs out of the stage, as an impact has moved it.
  void release(int body);

  /// Takes out the pairs of bodies that an impact changed by more than gravity does in a frame: they
  /// may collide again with bodies that they rest on.
  /// \param world   bodies after an impact
  /// \param pushed  indices of its movable bodies
  /// \param before  by index: their motion before it
  /// \param dt      [s] length of the frame
  void release_pushed(const World& world, std::span<const int> pushed,
                      std::span<const MovingBody> before, double dt);

  /// Number of entries into the stage in this frame.
  [[nodiscard]] int entered() const { return entered_; }

  /// The pairs in the stage, sorted; valid until the next call of this function.
  [[nodiscard]] std::span<const IndexPair> pairs();

 private:
  struct Record {
    IndexPair pair;
    int events = 0;     // collisions in this frame
    bool held = false;  // in the stage
  };
  Record& record_of(const IndexPair& pair);

  ContactRule rule_;
  int entered_ = 0;
  std::vector<Record> records_;  // of the pairs that collided in this frame, sorted
  std::vector<IndexPair> held_;
};

}  // namespace tumble
