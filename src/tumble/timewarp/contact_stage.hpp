/// \file
/// \brief Pairs that collide again and again are left to the end of the frame.
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/timewarp/instant_impacts.hpp"

#include <vector>

namespace tumble {

/// When a pair is left to the end of the frame.
struct ContactRule {
  double resolution = tolerance::event_resolution;  ///< [s] of the search for collisions
  /// Collisions of one pair in one frame after which it is left in any case, at least 1. Reason:
  /// with a restitution of 0.9 a ball bounces 87 times before its hops get shorter than a
  /// microsecond from 10 ms.
  int pair_events = 100;
};

/// The end of bouncing: a timewarp makes progress although bodies rest on one another.
///
/// In the listings of the thesis a resting pair collides infinitely often in a frame. Here a pair
/// goes to the **contact stage** for the rest of the frame
/// - after a collision from which gravity would bring the two together again within one resolution
///   of the search: \f$2 v'_n/g \le\f$ resolution, with the speed \f$v'_n\f$ at which they part. So
///   a bouncing train ends where its hops cannot be told apart any more, and a pair at rest goes
///   after one collision that hardly pushes;
/// - after `pair_events` collisions in the frame;
/// - when a search for its collision meets its cap.
///
/// Pairs in the contact stage are not searched. They come back when an impact changes the velocity of
/// one of their bodies by more than gravity does in a frame. At the end of the frame those still in it
/// are resolved together, without restitution, with whoever touches them (see FrameEnd), and the
/// overlap that is there is repaired.
/// \par Cost
/// O(log n) for a pair that has collided in the frame; no allocation once warm.
/// \verified{A train of bounces ends where its hops get shorter than the resolution}
class ContactStage {
 public:
  /// Makes it.
  /// \param rule  when pairs are left to it
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event
  explicit ContactStage(const ContactRule& rule);

  /// Starts a frame: nobody is in the stage, nobody has collided.
  void begin();

  /// Counts a collision and decides.
  /// \param pair     who collided
  /// \param parting  [m/s] how fast they part, at the slowest place that was pushed
  /// \param gravity  [m/s²]
  /// \return whether the pair goes to the stage
  bool count(const IndexPair& pair, double parting, double gravity);

  /// Leaves a pair to the stage.
  /// \param pair who
  void leave(const IndexPair& pair);

  /// Whether a pair is in the stage.
  /// \param pair who
  /// \return true: it is not to be searched
  [[nodiscard]] bool holds(const IndexPair& pair) const;

  /// Gives a body's pairs back to the search, as it was pushed.
  /// \param body its index
  void release(int body);

  /// Gives back the pairs of those who were pushed harder than gravity does in a frame: they may
  /// collide again with bodies that they rest on.
  /// \param world   bodies after an impact
  /// \param pushed  indices of its bodies that can move
  /// \param before  by index: how those moved before it
  /// \param dt      [s] length of the frame
  void release_pushed(const World& world, std::span<const int> pushed,
                      std::span<const MovingBody> before, double dt);

  /// How often pairs went to the stage in this frame.
  /// \return from 0
  [[nodiscard]] int entered() const { return entered_; }

  /// The pairs that are in the stage.
  /// \return sorted; valid until the next call of this function
  [[nodiscard]] std::span<const IndexPair> pairs();

 private:
  struct Record {
    IndexPair pair;
    int events = 0;     // collisions in this frame
    bool held = false;  // it is in the stage
  };
  Record& record_of(const IndexPair& pair);

  ContactRule rule_;
  int entered_ = 0;
  std::vector<Record> records_;  // of the pairs that have collided in this frame, sorted
  std::vector<IndexPair> held_;
};

}  // namespace tumble
