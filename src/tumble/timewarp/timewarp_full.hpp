/// \file
/// \brief Mirtich's timewarp: every body has its own local time (thesis 2.4.3).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/dynamics/pair_search.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/timewarp/body_history.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace tumble {

/// Options of the full timewarp.
struct TimewarpFullOptions : TimewarpOptions {
  /// [-] length of a flight in steps; 0: to the end of the step or to the next synchronisation. Above
  /// 0 a body may be ahead of the step. Reason: for cubes that collide every ten steps, 8 to 16 need
  /// the fewest pair tests
  double stride = 8.0;
  static constexpr double kShortestStride = 0.01;  ///< [-] a shorter one would make no progress
  static constexpr double kLongestStride = 1e5;    ///< [-] a longer one would lose digits
  /// [-] Cap on micro-steps of a flight. Reason: a million is refused by fly_in_micro_steps().
  static constexpr double kMostMicroSteps = 9e5;
  /// Frames between synchronisations, at which all local times agree; 0: never
  int synchronise_every = 0;
};

template <class Visitor>
void describe(TimewarpFullOptions& o, Visitor& v) {
  describe(static_cast<TimewarpOptions&>(o), v);
  v.number("stride", o.stride, 0.0, TimewarpFullOptions::kLongestStride, "-",
           "steps that a body flies at a time; 0: to the end of the step or the next "
           "synchronisation");
  v.whole("synchronise_every", o.synchronise_every, 0, 1000000,
          "frames between two synchronisations of all bodies; 0: never");
}

/// Rollbacks of a full timewarp, in all steps so far.
struct TimewarpWork {
  std::int64_t cancelled = 0;        ///< collisions that were resolved and undone
  std::int64_t rolled_back = 0;      ///< bodies rolled back
  std::int64_t most_milestones = 0;  ///< kept at one time, of all bodies together
};

/// Optimistic simulation: every body flies ahead on its own and is rolled back if it has flown past a
/// collision.
///
/// Each body has a history and a **local time** until which it is known. Repeatedly, the body with the
/// smallest local time flies on by a stride. Its flight is tested against the known trajectories of all
/// others. If it collides with a body at a time t, that body is **rolled back** to t: each collision
/// in its future is cancelled, which rolls back the partner to the time of that collision, and so on.
/// Then the collision of the two is resolved.
///
/// The smallest local time is the **global virtual time**. It only grows, and no body is ever rolled
/// back beyond it, since every tested flight begins there: earlier collisions are final, earlier
/// milestones are dropped. A step ends when it has reached the step's end; the collisions of the step
/// are reported in order of time, and the world gets the states at that time. Bodies ahead of it stay
/// ahead. A pair is tested once for each interval of time that both have flown.
///
/// Resting pairs are deferred to the end of the frame by the rule of ContactStage; the deferral is kept
/// with its collision, which may be cancelled. A body that is changed then, by repair of overlap, or
/// by the user between two steps, starts a new history, which rolls back all bodies that have collided
/// with it since. Collisions at equal times are resolved one after the other.
///
/// Bodies whose angular velocity is not constant fly in micro-steps of the length of the step in which
/// the flight began, or shorter ones (micro_step_of()), so that long flights are as accurate as those of the other forms. Evaluating a
/// trajectory between two milestones is not counted as an integration.
/// \par Cost
/// A flight: n comparisons of bounds and a search for each near body. A collision: two flights more,
/// and the rollback; a resting pair costs a scan of all resting pairs.
/// \algorithm{Mirtich's timewarp: section 2.4.3}
/// \deviation{Bodies in lasting contact are deferred to the end of the frame, where the paper flies contact groups together.}
/// \see Mirtich, "Timewarp rigid body simulation", SIGGRAPH 2000; Jefferson, "Virtual time", ACM
///      Trans. Program. Lang. Syst. 7, 1985.
/// \verified{Swept, full timewarp and a search over all bodies find the same collisions}
class TimewarpFull final : public Cloned<Technique, TimewarpFull> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for an option out of range
  explicit TimewarpFull(const TimewarpFullOptions& options = {});
  [[nodiscard]] std::string_view name() const override { return "timewarp_full"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }

  /// Counts of rollbacks since it was made.
  [[nodiscard]] const TimewarpWork& work() const { return work_; }

  /// The history of a body after the last step.
  /// \param body  its index in that step, which must have been taken
  /// \return with times counted from the end of that step
  [[nodiscard]] const BodyHistory& history(int body) const {
    return histories_[static_cast<std::size_t>(body)];
  }

 private:
  // A collision that was resolved and may still be cancelled.
  struct Resolved {
    std::int64_t number = 0;
    double time = 0.0;  // [s]
    IndexPair pair;
    bool cancelled = false;
    StepReport booked;                  // its energy and status
    std::array<double, 2> pushes = {};  // [m/s] bounds on the velocity changes of the two
    std::vector<Event> events;
    std::vector<ContactRecord> records;
  };
  // A pair deferred to the end of the frame.
  struct Hold {
    IndexPair pair;
    double since = 0.0;  // [s]
    std::int64_t made_by = Milestone::kNoCollision;
    double until = std::numeric_limits<double>::infinity();
    std::int64_t ended_by = Milestone::kNoCollision;
  };
  // The first collision on a flight; other = -1: none until this time.
  struct Meeting {
    double time = 0.0;  // [s]
    int other = -1;
  };
  // A body's entry in the queue of local times; void if its local time has changed since.
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
  void hold_or_release(const Resolved& collision, double separation_speed);

  // timewarp_history.cpp: rollback, and the end of a step.
  void begin_anew(int body, double time, const BodyState& state);
  void wait_for_turn(int body);
  void roll_back(int body, double time, bool also_at_it);
  void undo(std::int64_t number);
  Resolved& resolved(std::int64_t number);
  void drop_holds_of(int body);
  [[nodiscard]] bool held(const IndexPair& pair, double time) const;
  [[nodiscard]] bool waits_for_frame(int body) const;
  void show(World& world);
  void report_final();
  void finish(World& world);
  void settle(World& world);
  void forget_past(double time);
  void count_from_here();
  // [s] of a flight in this step, at most.
  [[nodiscard]] double longest_flight() const {
    return dt_ * std::max({options_.stride, 1.0 * options_.synchronise_every, 1.0});
  }
  [[nodiscard]] bool movable(int body) const;
  [[nodiscard]] Milestone milestone(int body, double time, const BodyState& state,
                                    std::int64_t collision) const;
  [[nodiscard]] BodyState flown(int body, const Milestone& from, double time) const;

  TimewarpFullOptions options_;
  InstantImpacts impacts_;
  FrameEnd end_;

  World scratch_;                 // bodies when the histories began; states are overwritten
  std::vector<BodyState> shown_;  // by index: states at the end of the last step
  std::vector<BodyHistory> histories_;
  std::vector<Turn> turns_;         // a heap
  std::vector<Resolved> resolved_;  // ascending numbers
  std::vector<Hold> holds_;
  std::int64_t next_number_ = 0;
  int flights_since_forgetting_ = 0;
  bool whole_ = false;         // the last step was completed: histories and world agree
  int frames_ = 0;             // since the last synchronisation
  double dt_ = 0.0;            // [s] of this step
  double horizon_ = 0.0;       // [s] no body flies beyond
  double known_by_all_ = 0.0;  // [s] the global virtual time
  StepReport report_;
  TimewarpWork work_;
  std::vector<std::int64_t> undone_;  // numbers of collisions to cancel
  std::vector<ContactRecord> records_;
  std::vector<IndexPair> resting_;
};

}  // namespace tumble
