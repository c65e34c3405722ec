/// \file
/// \brief Everything is a collision: Mirtich's impulses, one contact point at a time (thesis 2.5.2).
///
/// Uses the chapter `timewarp` for its queue of collisions.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/contact.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/pair_search.hpp"
#include "tumble/previous_work/sliding_impact.hpp"
#include "tumble/previous_work/tolerances.hpp"
#include "tumble/timewarp/collision_heap.hpp"

#include <memory>
#include <string_view>
#include <vector>

namespace tumble {

/// Options of the technique of microcollisions.
struct MicrocollisionsOptions {
  /// [-] slowest rebound, as a share of sqrt(g L); 0: slow impacts are like others, and a bouncing body meets the cap
  double rebound = tolerance::microcollision;
  ImpactEnd end = ImpactEnd::work;  ///< what restitution means
  int event_cap = 2000;  ///< largest number of impacts and of tests without impact in a step
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn in flight
  /// By which bodies near each other are found where a step begins; see make_broad_phase(). It changes no bit of a result
  std::string_view broad_phase = "bounding_tree";
};

template <class Visitor>
void describe(MicrocollisionsOptions& o, Visitor& v) {
  v.number("rebound", o.rebound, 0.0, 1.0, "-",
           "slowest rebound, as a fraction of the speed sqrt(g L)");
  v.word("impact_end", o.end, {{"work", ImpactEnd::work}, {"impulse", ImpactEnd::impulse}},
         "restitution returns a fraction of the work (Stronge) or of the impulse (Poisson)");
  v.whole("event_cap", o.event_cap, 1, 10000000,
          "largest number of impacts and of tests without impact in a step");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  std::vector<Word<std::string_view>> broad_phases;
  for (const std::string_view name : broad_phase_names()) broad_phases.push_back({name, name});
  v.word("broad_phase", o.broad_phase, broad_phases,
         "how near bodies are found (thesis 4.1); changes the work, not the result");
}

/// All contact is a train of collisions: bodies fly, collide at one point, and fly on.
///
/// A queue has the next collision of each pair that is near, found by conservative advancement. The
/// earliest is taken: its two bodies are flown there, all others stay where they are, and their point that approaches fastest
/// gets the impulse of solve_sliding_impact(). Points that move alike, as those of a box that falls flat, are one
/// point in their middle. Then the collisions of the two are searched anew.
///
/// **Microcollisions.** An approach slower than \f$w = \rho\,\sqrt{g L}\f$ (`rebound`, and the shortest movable edge L) is
/// contact. It is turned round, the slip too, and its restitution is raised so that the bodies part with w, if Coulomb's limit
/// allows that:
/// \f[ j = K^{-1} (u' - u), \quad u'_t = -u_t, \quad u'_n = w, \qquad |j_t| \le \mu\,j_n . \tag{1} \f]
/// So a box on a slope slides in one half of a hop as far up as it slides down in the other. If friction does not allow it the point
/// slides as in any impact, until the bodies part with w. Faster impacts too
/// go on to that speed. So each hop off the ground lasts 2 w / g at least, and a step has an end.
///
/// **What it cannot do.** Rest: a box trembles by \f$\tfrac12 \rho^2 L\f$ and with the speed w, on energy that (1) adds
/// (booked). A box on a slope that rocks from edge to edge stays where friction holds an edge that is hit alone, which for a cube takes a
/// coefficient of 0.6; with less it creeps, by up to half of w.
/// A stack of n takes n² times the impacts of a box, and a high one meets `event_cap`:
/// the rest of that step has no impacts, overlap is repaired, and the report says so. Which of several corners that touch at
/// once comes first is the order of their features.
/// \par Cost and determinism
/// An impact: n comparisons of bounds, and a search for each near body. No allocation once warm.
/// \see Mirtich, Canny, "Impulse-based simulation of rigid bodies", I3D 1995; Mirtich, "Impulse-based dynamic simulation of rigid
///      body systems", PhD thesis, Berkeley, 1996.
/// \algorithm{Microcollisions: section 2.5.2}
/// \deviation{Times are those of a conservative search in place of bounds in the queue; bodies touch in place of coming closer than an envelope; slow impacts part with one speed.}
/// \verified{A box on a slope below the angle of friction stays, on a train of microcollisions}
class Microcollisions : public Cloned<Technique, Microcollisions> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range
  explicit Microcollisions(const MicrocollisionsOptions& options = {});
  /// A copy; nothing is remembered from step to step but storage.
  Microcollisions(const Microcollisions& other);
  Microcollisions& operator=(const Microcollisions&) = delete;
  ~Microcollisions() override = default;

  [[nodiscard]] std::string_view name() const override { return "microcollisions"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }

 private:
  // What a step works on.
  struct Part {
    World& world;
    double dt;  // [s]
    StepReport report;
  };
  // The point of a contact that is next.
  struct Approach {
    bool found = false;
    Vec3 point_w = Vec3::Zero();   // [m]
    Vec3 motion_w = Vec3::Zero();  // [m/s] of the second body against the first
  };

  StepReport step_part(World& world, double dt);
  void begin(Part& part);
  [[nodiscard]] Bounds bounds_until_end(const Part& part, int body) const;
  void fly_to(Part& part, int body, double time);
  void search(Part& part, const IndexPair& pair, double start);
  void meet(Part& part, const ForeseenCollision& met);
  bool find_points(Part& part, const ForeseenCollision& met);
  [[nodiscard]] Approach fastest_approach() const;
  void collide(Part& part, const Approach& at, double time);
  void book(Part& part, const Approach& at, const Mat3& yield_w, const Vec3& impulse_w,
            double time);
  void store(Part& part, const IndexPair& pair);
  void finish(Part& part);

  MicrocollisionsOptions options_;
  std::unique_ptr<BroadPhase> broad_phase_;
  CollisionHeap queue_;
  OverlapRepair repair_;
  int left_ = 0;  // impacts and looks that are left in this step

  // Of one step; kept so that a warm step asks for no memory.
  std::vector<double> valid_times_;  // [s] by index, from the start of the part
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<int> movable_;  // of the pair that collides
  std::vector<MovingBody> moving_;
  Contact contact_;  // of that pair
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
