/// \file
/// \brief Timewarp as Mirtich made it: every body has a time of its own (thesis 2.4.3).
///
/// Uses no other chapter.
#pragma once

#include "tumble/dynamics/pair_search.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/timewarp/body_history.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace tumble {

/// Options of the full timewarp.
struct TimewarpFullOptions : TimewarpOptions {
  /// [-] how far a body flies at a time, in steps; 0: as far as the step, or the next
  /// synchronisation, lets it. Above 0 a body may be ahead of the step. Reason: of cubes that meet
  /// somebody every ten steps, pairs are tested least with 8 to 16
  double stride = 8.0;
  static constexpr double kShortestStride = 0.01;  ///< [-] shorter ones would make no progress
  static constexpr double kLongestStride = 1e5;    ///< [-] longer ones would lose digits
  /// Frames from one synchronisation to the next, in which nobody gets ahead; 0: never
  int synchronise_every = 0;
};

/// Names the options to a visitor, see options.hpp.
/// \param o  the options
/// \param v  an OptionDeclarer or OptionReader
template <class Visitor>
void describe(TimewarpFullOptions& o, Visitor& v) {
  describe(static_cast<TimewarpOptions&>(o), v);
  v.number("stride", o.stride, 0.0, TimewarpFullOptions::kLongestStride, "-",
           "steps that a body flies at a time; 0: to the end of the step or the next "
           "synchronisation");
  v.whole("synchronise_every", o.synchronise_every, 0, 1000000,
          "frames from one synchronisation of all bodies to the next; 0: never");
}

/// What a full timewarp has done to the histories, in all steps so far.
struct TimewarpWork {
  std::int64_t cancelled = 0;        ///< collisions that were resolved and undone
  std::int64_t taken_back = 0;       ///< bodies whose local time went back
  std::int64_t most_milestones = 0;  ///< kept at one time, of all bodies together
};

/// Every body flies ahead on its own; who is found to have flown past a collision goes back to it.
///
/// Each body has a history and a **local time** until which it is known. Again and again, the body
/// whose local time is the smallest flies on by a stride. Its flight is tested against the ways of all
/// others, as far as they are known. If it meets somebody at a time t, that body is **taken back** to
/// t. What it did afterwards is undone: each collision of its future is cancelled, which takes back the
/// partner of that collision to the time of it, and so on. Then the two collide.
///
/// The smallest local time is the **global virtual time**. Nobody is ever taken back beyond it, since a
/// flight that is tested begins there: it only grows, collisions before it are final, and milestones
/// before it are dropped. At the end of a step it has reached the step's end; collisions of the step
/// are told in the order of their times, and bodies are shown where they are then. Whoever is ahead
/// stays ahead. A pair of bodies is tested once for each stretch of time that both have flown.
///
/// A pair that rests is left to the end of the frame (see ContactStage, whose rule it is; it is kept
/// here with each collision, since collisions may be cancelled). Bodies that are changed then, by
/// repair of overlap, or between two steps by the user, begin a new history, which takes back all that
/// has met them since. Collisions at equal times are resolved one after the other.
///
/// Bodies that do not turn evenly fly in micro-steps as long as the step in which a flight began, so
/// that their rotation is as good as that of the other forms however long a flight is. Looking at a body between
/// two milestones is not counted as an integration.
/// \par Cost
/// A flight: n comparisons of bounds and searches with those that are near. A collision: two flights
/// more, and what it takes back; a pair that rests costs a look at all that rest.
/// \algorithm{Mirtich's timewarp: section 2.4.3}
/// \deviation{Bodies that stay in contact are left to the end of the frame, where the paper flies contact groups together.}
/// \see Mirtich, "Timewarp rigid body simulation", SIGGRAPH 2000; Jefferson, "Virtual time", ACM
///      Trans. Program. Lang. Syst. 7, 1985.
/// \verified{Swept, full timewarp and a search over all bodies find the same collisions}
class TimewarpFull final : public Technique {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for an option out of range
  explicit TimewarpFull(const TimewarpFullOptions& options = {});
  [[nodiscard]] std::string_view name() const override { return "timewarp_full"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }

  /// What has been done to the histories.
  /// \return counts since it was made
  [[nodiscard]] const TimewarpWork& work() const { return work_; }

  /// The history of a body, as the last step has left it.
  /// \param body  its index in that step; there must have been one
  /// \return with times counted from the end of that step
  [[nodiscard]] const BodyHistory& history(int body) const {
    return histories_[static_cast<std::size_t>(body)];
  }

 private:
  // A collision that was resolved, and may still be cancelled.
  struct Resolved {
    std::int64_t number = 0;
    double time = 0.0;  // [s]
    IndexPair pair;
    bool cancelled = false;
    StepReport booked;                  // its energy and status
    std::array<double, 2> pushes = {};  // [m/s] by how much the speeds of the two changed, at most
    std::vector<Event> events;
    std::vector<ContactRecord> records;
  };
  // A pair that is left to the end of the frame.
  struct Hold {
    IndexPair pair;
    double since = 0.0;  // [s]
    std::int64_t made_by = Milestone::kNoCollision;
    double until = std::numeric_limits<double>::infinity();
    std::int64_t ended_by = Milestone::kNoCollision;
  };
  // Who is met first on a flight, or nobody until a time.
  struct Meeting {
    double time = 0.0;  // [s]
    int other = -1;
  };
  // A body's place in the order of local times; void if its local time has changed since.
  struct Turn {
    double time = 0.0;
    int body = 0;
  };
  static bool later(const Turn& a, const Turn& b) {
    return a.time != b.time ? a.time > b.time : a.body > b.body;
  }

  // timewarp_full.cpp: flights and collisions.
  void begin(const World& world, double dt);
  int next_body();
  void advance(int body);
  [[nodiscard]] double end_of_flight(int body) const;
  Meeting first_meeting(int body, double target);
  void meet(int body, int other, const Bounds& flight, Meeting& best);
  std::optional<Meeting> first_collision(int body, int other, const Milestone& other_from,
                                         double start, double end);
  void collide(int body, const Meeting& meeting);
  void hold_or_release(const Resolved& collision, double parting);

  // timewarp_history.cpp: taking back, and the end of a step.
  void begin_anew(int body, double time, const BodyState& state);
  void wait_for_turn(int body);
  void take_back(int body, double time, bool also_at_it);
  void undo(std::int64_t number);
  Resolved& resolved(std::int64_t number);
  void drop_holds_of(int body);
  [[nodiscard]] bool held(const IndexPair& pair, double time) const;
  [[nodiscard]] bool waits_for_frame(int body) const;
  void show(World& world);
  void tell_final();
  void finish(World& world);
  void settle(World& world);
  void forget_past(double time);
  void count_from_here();
  [[nodiscard]] bool movable(int body) const;
  [[nodiscard]] Milestone milestone(int body, double time, const BodyState& state,
                                    std::int64_t collision) const;
  [[nodiscard]] BodyState flown(int body, const Milestone& from, double time) const;

  TimewarpFullOptions options_;
  InstantImpacts impacts_;
  FrameEnd end_;

  World scratch_;  // bodies as they were when the histories began; states are overwritten
  std::vector<BodyState> shown_;  // by index: as the last step has left the world
  std::vector<BodyHistory> histories_;
  std::vector<Turn> turns_;         // a heap
  std::vector<Resolved> resolved_;  // in the order of their numbers
  std::vector<Hold> holds_;
  std::int64_t next_number_ = 0;
  int flights_since_forgetting_ = 0;
  bool whole_ = false;         // the last step came to its end, so that histories and world agree
  int frames_ = 0;             // since the last synchronisation
  double dt_ = 0.0;            // [s] of this step
  double horizon_ = 0.0;       // [s] nobody flies beyond
  double known_by_all_ = 0.0;  // [s] the global virtual time
  StepReport report_;
  TimewarpWork work_;
  std::vector<std::int64_t> undone_;  // numbers of collisions to cancel
  std::vector<ContactRecord> records_;
  std::vector<IndexPair> resting_;
};

}  // namespace tumble
