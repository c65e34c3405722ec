/// \file
/// \brief Functions that the listings of the synchronised timewarp call (thesis 5.1, A.1).
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/pair_search.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/timewarp/collision_heap.hpp"
#include "tumble/timewarp/contact_stage.hpp"
#include "tumble/timewarp/instant_impacts.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// Resolves resting contacts and repairs overlap at the end of a frame.
///
/// Deferred pairs (see ContactStage) are resolved together, without restitution, with all pairs in
/// contact that are connected to them through movable bodies. The cubes of a stack fall alike, so that
/// none of them collides with another in a frame; if only the lowest were stopped at its end, the
/// others would fall on it in the next. Pairs count as in contact up to a gap of g dt times the
/// resolution: the distance that bodies approach in one resolution at the speed gained in the frame.
///
/// Then all overlapping bodies are moved apart, along the normal only: on a slope of angle θ a resting
/// body creeps by \f$\tfrac12 g\sin\theta\,\Delta t^2\f$ in each frame.
/// \par Cost
/// A broad phase and a separation for each near pair, twice with resting pairs. No allocation once warm.
/// \verified{A box and a stack of five at rest stay where they are}
class FrameEnd {
 public:
  /// Makes it with empty storage.
  FrameEnd() = default;
  /// A copy has fresh storage; there is no state to copy.
  FrameEnd(const FrameEnd&) : FrameEnd() {}

  /// Ends a frame.
  /// \param world       bodies at its end; in and out
  /// \param resolution  [s] of the search for collisions
  /// \param held        deferred pairs, sorted, each once
  /// \param report      gets counts, energy and the deepest overlap
  /// \param records     gets the contact points of resting pairs
  void settle(World& world, double dt, double resolution, std::span<const IndexPair> held,
              StepReport& report, std::vector<ContactRecord>& records);

 private:
  void join_touching(const World& world, double reach, StepReport& report);

  BoundingTree broad_phase_;
  InstantImpacts impacts_;
  OverlapRepair repair_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> resting_;
  std::vector<IndexPair> touching_;
  std::vector<char> joined_;  // by index: whether a movable body is in one of the resting pairs
};

/// Options of all forms of the timewarp.
struct TimewarpOptions {
  double resolution = tolerance::event_resolution;  ///< [s] of the search for collisions
  int pair_events = ContactRule{}.pair_events;      ///< see ContactRule
  RotationRule rotation = RotationRule::splitting;  ///< integration of the rotation in flight

  /// [-] Cap on separations computed in one search. Reason: bricks that spin at 100 rad/s take up to
  /// 2000 at a resolution of a microsecond and 30000 at 1e-14 s.
  static constexpr int kMostSeparations = 50000;
};

template <class Visitor>
void describe(TimewarpOptions& o, Visitor& v) {
  v.number("resolution", o.resolution, tolerance::least_event_resolution, 1.0, "s",
           "time resolution of the search for collisions");
  v.whole("pair_events", o.pair_events, 1, 1000000,
          "collisions of a pair in one frame before it is ignored until the frame's end");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Checks the length of a step.
/// \param options  the resolution must be above the rounding of times up to the longest flight
/// \param steps    [-] number of steps in the longest flight
/// \throws std::invalid_argument for a dt that is not above 0; StepRefused for a resolution too small for it
void require_step(double dt, const TimewarpOptions& options, double steps = 1.0);

/// Checks that all states are finite.
/// \throws std::invalid_argument naming a body whose position or momenta are not finite
void require_finite_states(const World& world);

/// The state of a synchronised timewarp between two collisions, for observers.
struct TimewarpLook {
  const ForeseenCollision* current = nullptr;   ///< the one just resolved; nullptr: none yet
  std::span<const ForeseenCollision> foreseen;  ///< the queue, the earliest first
  std::span<const BodyState> valid;             ///< by index: the valid states
  std::span<const double> valid_times;  ///< [s] by index: their times, from the frame's start
  std::span<const BodyState> test;      ///< by index: the states at the end of the frame
};

/// An observer of a synchronised timewarp.
class TimewarpWatcher {
 public:
  virtual ~TimewarpWatcher() = default;
  /// The queue has been filled, or a collision has been resolved.
  /// \param look  valid during the call
  virtual void on_queue(const TimewarpLook& look) = 0;
};

/// One frame of a synchronised timewarp: two states for each body, and all functions that the listings
/// call without defining them.
///
/// Times are counted from the start of the frame. The **valid state** of a body is in the world and
/// belongs to the body's **valid time**. Its **test state** is its state at the end of the frame if it
/// does not collide. The collision of two bodies is searched from the later of their valid times, each
/// body flown there from its own valid state in one integration (T4, T8); the result is the last time
/// at which they are apart (T7). Two bodies that overlap when their search begins collide at once if
/// the overlap is increasing.
///
/// Pairs that are searched: *discrete*, as in the thesis, those whose test states overlap; a pair that
/// has collided and separated by then, or changed places, is missed (T5). *Conservative*, those whose
/// swept bounds overlap; no overlap of at least one resolution is missed.
///
/// What turns by more than a radian in the frame flies in parts (micro_step_of()), which keeps its energy.
///
/// Immovable bodies are valid at all times: they are not integrated, and collisions predicted with them
/// are kept, as no impact changes them.
/// \par Cost
/// A frame: a broad phase and a search for each near pair. Each body of a collision: n comparisons of
/// bounds and a search for each near pair.
class TimewarpFrame {
 public:
  /// Makes the frame.
  /// \throws std::invalid_argument for an option out of range
  TimewarpFrame(const TimewarpOptions& options, SearchMethod method);
  /// A copy with options and contacts; no other state is kept from frame to frame.
  TimewarpFrame(const TimewarpFrame& other) : TimewarpFrame(other.options_, other.method_) {
    records_ = other.records_;
  }

  /// Starts a frame.
  /// \param world     all bodies; kept until finish()
  /// \param observer  receives the collisions; may be nullptr
  /// \throws std::invalid_argument for a dt that is not above 0
  void begin(World& world, double dt, Observer* observer);

  // The objects of the listings, by index.
  std::vector<BodyState> test;      ///< the test states
  std::vector<double> valid_times;  ///< [s] since the start of the frame
  StepReport report;                ///< of this frame

  /// Whether a body is movable; false: it is neither integrated nor invalidated.
  [[nodiscard]] bool movable(int body) const;

  /// Integrates a body in free flight: integrateForward.
  /// \param time   [s] duration
  void integrate_forward(BodyState& state, int body, double time);

  /// Finds the collisions of all pairs: findAllCollisions.
  void find_all_collisions(CollisionHeap& heap);

  /// Finds the collisions of some bodies, each pair once: addCollisionsForObject.
  /// \param bodies  indices, ascending; their valid and test states must be up to date
  void add_collisions_of(std::span<const int> bodies, CollisionHeap& heap);

  /// The bodies that may have touched one of two by a time, the two included: findNearObjects. Their
  /// bounds, swept from the valid time until then, overlap those of one of the two.
  /// \return indices, ascending; valid until the next call
  std::span<const int> find_near(const ForeseenCollision& collision);

  /// The earliest collision in a group before another collision: findCollisionsForGroup. Pairs are
  /// tested in their test states.
  /// \param group  indices, ascending, with test states at the time of the other collision
  /// \param other  the collision about to be resolved; its pair is excluded
  /// \return the earliest, if it precedes the other by more than a resolution
  std::optional<ForeseenCollision> first_of_group(std::span<const int> group,
                                                  const ForeseenCollision& other);

  /// Resolves simultaneous collisions: collideTwoObjects. The valid states must be of that time.
  /// \param pairs  the colliding pairs, sorted
  /// \param time   [s] since the start of the frame
  void collide(std::span<const IndexPair> pairs, double time);

  /// Resolves resting contacts (see FrameEnd), repairs overlap (fixInterpenetration) and ends the
  /// frame. The valid states must be those at its end.
  void finish();

  /// The contact points of this frame, each at the time of its collision; valid until the next frame.
  [[nodiscard]] std::span<const ContactRecord> contacts() const { return records_; }

  /// Passes the present state to a watcher.
  /// \param watcher  nullptr: none
  /// \param current  the collision just resolved; nullptr: none yet
  void show(TimewarpWatcher* watcher, const ForeseenCollision* current,
            const CollisionHeap& heap) const;

 private:
  [[nodiscard]] Flight flight(const IndexPair& pair);
  [[nodiscard]] Bounds bounds_of_body(int body) const;
  void search(const IndexPair& pair, CollisionHeap& heap);
  std::optional<double> first_collision(const IndexPair& pair, double end);
  void report_collisions(std::span<const Contact> contacts, double time, int rewinds);

  TimewarpOptions options_;
  SearchMethod method_;
  BoundingTree broad_phase_;
  ContactStage stage_;
  InstantImpacts impacts_;
  FrameEnd end_;

  World* world_ = nullptr;  // during a frame
  double dt_ = 0.0;         // [s]
  Observer* observer_ = nullptr;
  std::vector<Bounds> bounds_;       // by index
  std::vector<double> micro_steps_;  // [s] by index: of the pair that is searched
  std::vector<IndexPair> candidates_;
  std::vector<int> near_;
  std::vector<int> pushed_;         // movable bodies of an impact, ascending
  std::vector<MovingBody> before_;  // by index: their motion before it
  std::vector<Event> events_;       // of one impact
  std::vector<ContactRecord> records_;
};

/// A synchronised timewarp without its main loop: frame, queue of collisions, watcher.
class SynchronisedTimewarp : public Technique {
 public:
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return frame_.contacts();
  }

  /// Sets an observer of the queue, called after each collision.
  /// \param watcher  nullptr: none. Not owned
  void watch(TimewarpWatcher* watcher) { watcher_ = watcher; }

 protected:
  /// Makes the technique.
  /// \param method  which pairs are searched, and how
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  SynchronisedTimewarp(const TimewarpOptions& options, SearchMethod method)
      : frame_(options, method) {}

  TimewarpFrame frame_;                 ///< one frame
  CollisionHeap collision_heap_;        ///< the queue
  TimewarpWatcher* watcher_ = nullptr;  ///< see watch()
};

}  // namespace tumble
