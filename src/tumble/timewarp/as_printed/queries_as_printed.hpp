/// \file
/// \brief Functions that the listings of the synchronised timewarp call, as printed (thesis A.1).
#pragma once

#include "tumble/base/errata_set.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/options.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// The errata of A.1: T1 to T10 (SIMPLESYNCTIMEWARP) and F1 to F9 (SAFERSYNCTIMEWARP).
inline const ErrataList& errata_of_timewarp() {
  static const ErrataList list(std::array<ErrataGroup, 2>{{{"T", 10}, {"F", 9}}});
  return list;
}

/// Errata of A.1 that are repaired.
using TimewarpErrata = ErrataSetOf<errata_of_timewarp>;

/// The two listings of appendix A.1.
enum class TimewarpListing : std::uint8_t {
  simple,  ///< SIMPLESYNCTIMEWARP
  safer    ///< SAFERSYNCTIMEWARP
};

/// Options of the timewarp as printed.
struct TimewarpAsPrintedOptions {
  TimewarpListing listing = TimewarpListing::simple;  ///< the listing
  TimewarpErrata repaired;                            ///< errata that are mended
  double resolution = tolerance::event_resolution;    ///< [s] of the search for collisions
  int cap = 1000;  ///< [-] cap on passes of the main loop in a frame, at least 1
  int pair_events = ContactRule{}.pair_events;  ///< see ContactRule; used where T6 is mended
  /// Whether collideTwoObjects bounces separating bodies, too. The listings do not define it.
  bool collide_separating = false;
  RotationRule rotation = RotationRule::splitting;  ///< integration of the rotation in flight
};

/// Names the options that the reading as meant lacks to a visitor, see options.hpp.
template <class Visitor>
void describe(TimewarpAsPrintedOptions& o, Visitor& v) {
  v.whole("cap", o.cap, 1, 1000000,
          "reading=as_printed: passes of the main loop in a frame before it is given up");
  v.word("separating", o.collide_separating, {{"ignored", false}, {"collided", true}},
         "reading=as_printed: how collideTwoObjects treats two bodies that separate");
}

/// The two lists of the listings: the one whose momenta collideTwoObjects changes.
enum class CollidedObjects : std::uint8_t {
  valid,  ///< validObjects
  test    ///< testObjects
};

/// The present collision of the main loop, curCollision: one pair, or with T9 mended all pairs that
/// collide within a resolution.
struct PrintedMoment {
  double time = 0.0;             ///< [s] since the start of the frame
  std::vector<IndexPair> pairs;  ///< sorted
  std::vector<int> indices;      ///< objectIndices: the bodies of the pairs, ascending
};

/// The functions that the listings of appendix A.1 call without defining them, each as the print
/// suggests, or with some of the errata mended.
///
/// | errata | as printed                            | mended                                     |
/// |--------|---------------------------------------|--------------------------------------------|
/// | T4     | states count as of the frame's start  | as of their valid times                    |
/// | T5     | overlapping test states are searched  | overlapping swept bounds are searched      |
/// | T6     | a pair may collide endlessly          | ContactStage                               |
/// | T7     | the overlapping end of the bracket    | the end without overlap                    |
/// | T8     | integrateForward is an Euler step     | fly()                                      |
/// | T9     | collisions are resolved one by one    | those within a resolution together         |
/// | F6     | the present pair is in its group      | it is excluded; others must be earlier     |
/// | F7     | near: bounds of the test states       | bounds swept from the valid time on        |
///
/// T7 also decides on bodies that overlap when their search begins: as printed they collide, mended only
/// if the overlap increases. The Euler step of T8 is the semi-implicit one. "Earlier" in F6 means by
/// more than a resolution; as printed, any time is accepted.
///
/// The other errata are in the lines of the listings themselves: see TimewarpAsPrinted.
class PrintedQueries {
 public:
  /// Makes it with its storage.
  /// \throws std::invalid_argument for an option out of range
  explicit PrintedQueries(const TimewarpAsPrintedOptions& options);
  /// A copy with options and contacts; no other state is kept from frame to frame.
  PrintedQueries(const PrintedQueries& other) : PrintedQueries(other.options_) {
    records_ = other.records_;
  }

  /// Starts a frame.
  /// \param world     all bodies; kept until fix_interpenetration()
  /// \param observer  receives the collisions; may be nullptr
  /// \throws std::invalid_argument for a dt that is not above 0
  void begin(World& world, double dt, Observer* observer);

  // The objects of the listings, by index.
  std::vector<BodyState> test;      ///< testObjects
  std::vector<double> valid_times;  ///< [s] validTimes, since the start of the frame
  StepReport report;                ///< of this frame

  /// Whether the lines that stamp a body apply to this one: as printed always (T10); mended, if it is movable.
  [[nodiscard]] bool stamped(int body) const;

  /// integrateForward.
  /// \param time   [s] duration; may be negative
  void integrate_forward(BodyState& state, int body, double time);

  /// findAllCollisions.
  /// \param heap  emptied, then receives them
  void find_all_collisions(CollisionHeap& heap);

  /// removeFirstCollision.
  /// \param heap  is not empty
  /// \param out   receives the collision, and with T9 mended those within a resolution of it
  void remove_first_collision(CollisionHeap& heap, PrintedMoment& out) const;

  /// addCollisionsForObject, for one body or for several, each pair once.
  /// \param bodies  indices, ascending
  void add_collisions_for(std::span<const int> bodies, CollisionHeap& heap);

  /// findNearObjects.
  /// \param moment  the collision; its bodies are always included
  /// \param out     receives indices, ascending
  void find_near_objects(const PrintedMoment& moment, std::vector<int>& out) const;

  /// findCollisionsForGroup, reduced to the earliest collision.
  /// \param group   indices, ascending, with test states at the time of the moment
  /// \param moment  the collision about to be resolved
  std::optional<ForeseenCollision> find_collisions_for_group(std::span<const int> group,
                                                             const PrintedMoment& moment);

  /// collideTwoObjects, at any distance: the impulse acts across a gap.
  /// \param objects  the list to change
  /// \param moment   the collision
  void collide_two_objects(CollidedObjects objects, const PrintedMoment& moment);

  /// fixInterpenetration. Also ends the frame, and resolves the pairs in the contact stage (T6 mended).
  void fix_interpenetration();

  /// The contact points of this frame, each at the time of its collision; valid until the next frame.
  [[nodiscard]] std::span<const ContactRecord> contacts() const { return records_; }

 private:
  // Which errata of this file are mended.
  struct Mended {
    bool valid_times = false;      // T4
    bool ways = false;             // T5
    bool contact_stage = false;    // T6
    bool apart = false;            // T7
    bool exact_flight = false;     // T8
    bool together = false;         // T9
    bool movable_only = false;     // T10
    bool strictly_before = false;  // F6
    bool swept = false;            // F7
  };

  [[nodiscard]] bool movable(int body) const { return world_->bodies()[idx(body)].movable(); }
  [[nodiscard]] Flight flight() const;
  [[nodiscard]] Vec3 gravity_of_flight() const;
  [[nodiscard]] Bounds bounds_of_body(int body) const;
  void search(const IndexPair& pair, CollisionHeap& heap);
  std::optional<double> first_collision(const IndexPair& pair, double end);
  [[nodiscard]] double gap_of(std::span<const BodyState> states, const IndexPair& pair);
  void collide_valid(const PrintedMoment& moment);
  bool bounce_separating(const IndexPair& pair, double time);
  void collide_approaching(std::span<const IndexPair> pairs, double margin, double time);
  int keep_pushed(std::span<const IndexPair> pairs);

  TimewarpAsPrintedOptions options_;
  Mended mended_;
  SearchMethod method_;
  BoundingTree broad_phase_;
  ContactStage stage_;
  InstantImpacts impacts_;
  FrameEnd end_;

  World* world_ = nullptr;  // during a frame
  double dt_ = 0.0;         // [s]
  Observer* observer_ = nullptr;
  std::vector<BodyState> start_;  // of the frame
  std::vector<double> zeros_;     // [s] T4: the valid times used by searches
  std::vector<Bounds> bounds_;    // by index
  std::vector<IndexPair> candidates_;
  std::vector<MovingBody> moving_;  // of the bodies of a collision, before it
  std::vector<IndexPair> approaching_;
  std::vector<IndexPair> missed_;
  std::vector<int> pushed_;  // movable bodies of the collision resolved last
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
