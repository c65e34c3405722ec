/// \file
/// \brief Chronological collisions and analytic contact forces in one simulator (thesis 3.3.1).
///
/// Uses the chapter on geometric stability.
#pragma once

#include "tumble/analytic_lcp/contact_forces.hpp"
#include "tumble/analytic_lcp/drift_correction.hpp"
#include "tumble/analytic_lcp/forced_flight.hpp"
#include "tumble/analytic_lcp/impact_search.hpp"
#include "tumble/analytic_lcp/island_damping.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <string>
#include <vector>

namespace tumble {

/// Friction of the analytic technique.
enum class AnalyticFriction : std::uint8_t {
  none,     ///< none, in contacts and in collisions
  coulomb,  ///< Coulomb's, in contacts and in collisions
  damping   ///< none, but bodies in contact are damped, as the thesis proposes in 5.3
};

/// Options of the analytic technique.
struct AnalyticOptions {
  AnalyticFriction friction = AnalyticFriction::coulomb;  ///< in contacts and collisions
  int directions = 8;                           ///< of the pyramid of friction in contacts: 4 or 8
  std::string solver = "augmented_lagrangian";  ///< of the problems without friction, by name
  StableRule stable_boxes = StableRule::off;    ///< bodies left out of the contact forces
  StickyOptions sticky;                         ///< which collisions stick
  ImpactOrder impacts = ImpactOrder::simultaneous;  ///< how several collisions at once are resolved
  double resolution = tolerance::event_resolution;  ///< [s] how exactly collisions are searched for
  int event_cap = 200;  ///< flights in one step, after which its rest is one step of TimeStepping
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  PoseUpdate pose = PoseUpdate::separate;           ///< how bodies that push each other fly
  DampingShares damping;  ///< damping: how much is left of the motion of bodies in contact
};

template <class Visitor>
void describe(AnalyticOptions& o, Visitor& v) {
  v.word("friction", o.friction,
         {{"coulomb", AnalyticFriction::coulomb},
          {"none", AnalyticFriction::none},
          {"damping", AnalyticFriction::damping}},
         "Coulomb friction, none, or none and damping of bodies in contact (thesis 5.3)");
  v.word("stable_boxes", o.stable_boxes,
         {{"off", StableRule::off},
          {"corners", StableRule::corners},
          {"hull", StableRule::hull},
          {"equilibrium", StableRule::equilibrium}},
         "friction=none or damping: rule for geometrically stable boxes, which need no contact "
         "forces (thesis 5.4)");
  v.word("directions", o.directions, {{"8", 8}, {"4", 4}},
         "directions of the friction pyramid of contacts");
  v.word("solver", o.solver, contact_solver_words(), "solver of contact forces without friction");
  v.word("impacts", o.impacts, impact_words(), kImpactsMeaning);
  v.number("sticky", o.sticky.threshold, 0.0, 1e6, "-",
           "collisions slower than this times sqrt(g L) do not bounce (thesis 4.3)");
  v.number("resolution", o.resolution, tolerance::least_event_resolution, 1.0, "s",
           "time resolution of the search for impacts");
  v.whole("event_cap", o.event_cap, 1, 1000000,
          "limit of collisions and ends of sliding in a step; the rest is one step of "
          "time_stepping");
  v.number("damping_velocity", o.damping.velocity, 0.0, 1.0, "-",
           "friction=damping: factor of velocities in 1/60 s (k1 of the thesis)");
  v.number("damping_spin", o.damping.spin, 0.0, 1.0, "-",
           "friction=damping: factor of angular velocities in 1/60 s (k2)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  v.word("pose", o.pose, words_of(pose_updates()), kPoseMeaning);
}

/// Collisions in the order of their times, and exact contact forces in between: what the thesis could not join (3.3.1).
///
/// A step is a series of flights. Before each flight the collisions of the instant are resolved, and the contact forces
/// are computed. Then all bodies move with constant forces until the next collision, until something stops sliding, or
/// until the end of the step.
///
/// **Collisions** (ImpactSolver): points that touch and approach faster than the resting speed. All contacts of their
/// island take part, so that a stack passes a blow on. Slow ones have restitution 0 (sticky_restitution()) and become
/// resting contacts.
///
/// **Forces** (ContactForces) are computed twice: at the start of the flight, and at the state to which these forces lead
/// in half of its time. The second ones act during the flight (midpoint rule, order 2). Where hardly anything moves, the
/// first ones do, and where friction would add energy by the second ones (counted in `fallbacks`).
///
/// **Sliding** that ends within a flight ends the flight, so that friction does not reverse a body's motion.
///
/// **Bodies that turn together** about a point outside of them move along arcs with PoseUpdate::exponential (PivotUpdate).
/// The forces at the start show which body supports which; impacts are searched along the arcs.
///
/// **Drift.** The forces themselves remove small speeds and gaps of contacts, as far as they only have to push; overlap
/// beyond the slop is removed by moving bodies (DriftCorrection).
///
/// **Stable boxes** (5.4) can be left out of the forces, without friction or with damping: see HeldBodies. Collisions still
/// act on them.
///
/// **Substitutes**, counted in `fallbacks`:
/// - Painlevé: where friction has no solution, the island takes one step at the level of velocities (VelocityStep).
/// - Simultaneous impacts whose friction does not settle are solved as one such step of length 0.
/// - One step of TimeStepping replaces the rest of a step if an island with friction is too large for exact impacts (more
///   than 150 points) or forces (FrictionLemkeSolver::kMostUnknowns), and after `event_cap` flights, four substitutes, or
///   300 million multiplications. Without Coulomb's friction the rest is flown without collisions in place of the last,
///   and the step ends as StepStatus::event_cap. Where repair then would lift bodies, since a light one turns far into a
///   heavy one, that step is divided, in up to 64 parts.
///
/// **Limit.** Corners of a fast body hit one after the other, and each throws the next one down: a toy brick that falls
/// 100 m on a plate leaves sideways at 2.8 m/s, whatever the step. In a step of velocities all corners arrive at once, and
/// it stays.
///
/// If no solver has an answer, the step ends as StepStatus::unsolved, the bodies stay in the state of that moment, and
/// unsolved_problem() can be stored.
/// \par Cost
/// Per flight two problems for each island, twice as many where something slides, and a test of all near pairs; more for
/// a collision. Problems with friction are dense, O(N³) for N unknowns, ten for each point that may stick; larger ones
/// become steps of velocities, so that a step of a collapsing pile of forty boxes takes a tenth of a second.
/// \algorithm{Collisions in the order of time with analytic contact forces: section 3.3.1}
/// \deviation{The thesis did not get its two parts to work together; this is our way to do it.}
/// \verified{A box bounces, sticks, rests, slides and topples in one run of the joined simulator}
class Analytic : public Cloned<Technique, Analytic> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range, a solver that there is not, or the one
  ///         that tries everything, which is for a few contacts only; for stable boxes with friction
  explicit Analytic(const AnalyticOptions& options = {});
  /// A copy with all memory; its storage begins empty.
  Analytic(const Analytic& other);
  Analytic& operator=(const Analytic&) = delete;
  ~Analytic() override = default;

  [[nodiscard]] std::string_view name() const override { return "analytic"; }
  StepReport step(World& world, double dt) override;
  /// \copydoc Technique::contacts
  /// Impulses of every collision of the step, and the forces of its last flight at the pose in the
  /// middle of it, where they are found. Between bodies that are left out as stable no force is
  /// known, and their contacts are not listed.
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<Diagnostic> diagnostics() const override;
  /// The problem that the last step could not solve; nullptr if there is none; valid until the next step.
  [[nodiscard]] const LcpProblem* unsolved_problem() const {
    return unsolved_ ? &forces_.unsolved() : nullptr;
  }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

  /// The bodies that the last forces left out as stable.
  /// \return by body index, a Hold; empty with stable_boxes=off or before the first step
  [[nodiscard]] std::span<const char> held() const { return forces_.held().held(); }

 private:
  // How far a step has come.
  struct Progress {
    double dt = 0.0;      // [s]
    double passed = 0.0;  // [s]
    [[nodiscard]] double left() const { return dt - passed; }
  };
  // The flight that begins.
  struct Plan {
    double time = 0.0;       // [s] how long it is to be
    double forces_at = 0.0;  // [s] from its start, the pose for which forces were found
  };

  StepReport step_part(World& world, double dt);
  void find_candidates(const World& world, double left, bool carried);
  void carry(const World& world);
  void find_near(const World& world, StepReport& report);
  void leave_out_flush_pairs(const World& world);
  bool collide(World& world, const Progress& progress, StepReport& report);
  void resolve(std::span<const int> which, const World& world, const Progress& progress,
               StepReport& report);
  bool resolve_by_velocities(const World& world, const Progress& progress, StepReport& report);
  [[nodiscard]] bool is_too_large(std::span<const Contact> impact) const;
  void finish_by_velocities(World& world, Progress& progress, StepReport& report);
  bool find_forces(World& world, const Progress& progress, Plan& plan, StepReport& report);
  bool improve_forces(World& world, const Progress& progress, Plan& plan, StepReport& report);
  bool take_midway(World& world, const Plan& plan, StepReport& report);
  [[nodiscard]] bool hardly_moves(const World& world, double time) const;
  void fly(World& world, const Plan& plan, bool to_the_end, Progress& progress, StepReport& report);
  void book_work(const World& world, double time, StepReport& report);
  void record_impact(const Contact& contact, double time);
  void record_forces(double time, double duration, StepReport& report);
  void finish(World& world, const Progress& progress, StepReport& report);

  AnalyticOptions options_;
  BoundingTree broad_phase_;
  ContactForces forces_;
  ImpactSearch search_;
  ImpactSolver impacts_;
  VelocityStep unsettled_;  // of impacts that ImpactSolver leaves
  DriftCorrection hold_;
  IslandDamping damping_;
  bool unsolved_ = false;
  std::int64_t work_ = 0;   // multiplications of the solvers of forces, in this step
  bool too_large_ = false;  // an island, for exact impacts or forces with friction

  // Memory from flight to flight: axes of contacts, and which bodies were pushed.
  ContactList resting_;

  // Of one flight, kept so that a warm step asks for no memory.
  ForcedFlight flight_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> resting_pairs_;
  std::vector<PushedPair> pushed_;
  std::vector<MovingBody> moving_;      // where the forces are found
  std::vector<MovingBody> ended_;       // where the flight ends
  ContactList near_;                    // all points within the margin
  ContactList midway_;                  // points that rest, half a flight later
  ContactList island_;                  // contacts that collide together
  std::vector<Wrench> first_wrenches_;  // of the start of the flight
  std::vector<Acceleration> first_accelerations_;
  Islands islands_;
  double recorded_at_ = 0.0;   // [s] of the pose for which the last forces were found
  double recorded_for_ = 0.0;  // [s] how long they were to act
  int rewound_ = 0;            // bodies that were put back for the collision of this instant
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
