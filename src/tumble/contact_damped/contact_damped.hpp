/// \file
/// \brief The default technique: contact patches that stick, slide or open, solved stiffly (thesis 6.3.1).
///
/// Depends on contact, contact_patches, dynamics, geometry and math, on no other technique.
///
/// **Reading order.** This header and ContactDamped::step() in contact_damped.cpp; then what that uses:
/// 1. contact_patches/contact_patch.hpp: where two bodies touch, the unit of all solving; persistent_manifolds.hpp finds the
///    patches of a step and keeps them while bodies rest, without edges of no height (grazed_edges.hpp);
///    island_order.hpp groups and orders them.
/// 2. contact_patches/patch_solver.hpp: one patch by itself (its friction: minimum_in_ball()). island.hpp: a sweep over all
///    patches of an island.
/// 3. solve_island.cpp: the impulses of an island, as plan_island() in island_plan.cpp says; island_block.hpp: what sweeps leave of
///    it; island_energy.cpp: impulses that would add energy.
/// 4. island_solver.hpp: the direct solver, in island_setup.cpp, island_solver.cpp (ADMM) and island_newton.cpp
///    (Newton steps), with the arithmetic of island_math.hpp.
/// 5. missed_and_turning.cpp: islands that have to be solved once more; step_parts.hpp: when a step is divided.
/// 6. body_motion.hpp, move_bodies.cpp: poses; bounce.cpp and bounce_order.hpp: restitution; correct_and_account.cpp: overlap and
///    the energy account.
///
/// Iteration counts and residuals are in tolerances.hpp; one that a single file uses is at its head.
#pragma once

#include "tumble/contact/pivot_update.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/contact_damped/island.hpp"
#include "tumble/contact_damped/island_block.hpp"
#include "tumble/contact_damped/island_order.hpp"
#include "tumble/contact_damped/island_plan.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/kept_solution.hpp"
#include "tumble/contact_patches/patch_solver.hpp"
#include "tumble/contact_patches/persistent_manifolds.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <memory>
#include <vector>

namespace tumble {

/// Options of the technique.
struct ContactDampedOptions {
  /// Sweeps over an island, each in one direction, at most: at least 1. Each island gets one, and a second if that
  /// changes something, whatever this says. Small islands, of up to 20 bodies, get at least fifty, unless so many of
  /// these move that they exceed the budget together; a large one little of which moves up to a hundred.
  int sweeps = 6;
  /// ADMM iterations of the direct solver, at most: three times as many for a small island. 0: it is not used.
  int admm_iterations = 100;
  /// Work on a large island in motion. If its patches times `admm_iterations` exceed it, the island is only swept: budget
  /// over patches times, but at least `sweeps` times and at most 24, or 100 if little of it moves (or `sweeps`, if more).
  /// Bounces and turns no longer divide a step when it has cost twice as much. A quiet island that
  /// costs too much to solve at once is swept within it, too, as long as sweeps keep it from sinking.
  /// Of 1000 cubes that fall together a step takes about 20 ms so.
  int budget = 50000;
  int correction_sweeps = 50;  ///< of the overlap correction, at most; at least 1
  /// Parts of a step, at most. Above 1, a step is divided in which bodies that touch move by more than 4 % of an edge
  /// into each other, or edges along each other; in large islands the work is divided, too. For small worlds of fast
  /// bodies: of 500 random ones without friction 8 instead of 23 end with an overlap above 1 % with 4 parts.
  int parts = 1;
  bool sleeping = false;  ///< islands at rest are not simulated (thesis 4.5)
  RotationRule rotation = RotationRule::splitting;  ///< how orientations are integrated
  PoseUpdate pose = PoseUpdate::exponential;        ///< how bodies that push each other are moved
};

/// Damping as friction between bodies, in place of scaled velocities, independent of size and mass.
///
/// The thesis proposes this as future work (6.3.1): its damping slows each body by itself; this one
/// removes energy from the motion of two bodies *relative to each other*, where they touch, so that momentum is
/// conserved. Friction, torsion and the inelastic normal impulse are the only dissipation.
///
/// **A step**, as step() does it, for each of its parts. It has one, unless boxes that move against each other by half an edge
/// or more meet (time_to_fast_meeting()), a body that may touch another turns by more than a radian, an impact makes one turn
/// so far that it would sink into another, a bounce sends a body on towards another (time_to_first_bounce()), or
/// ContactDampedOptions::parts asks for more:
/// 1. Velocities get their share of gravity.
/// 2. Contact patches are found where bodies touch, or will within the time that is left of the step, and kept while
///    their bodies rest (PersistentManifolds). They are grouped by islands (IslandOrder).
/// 3. Each island is solved by solve_island(). It starts with the impulses of the step before and one Gauss-Seidel sweep
///    down; if that changes something, one up. If it is not settled, plan_island() chooses: a bounded number of sweeps in a
///    heap in which much moves; where little of a large island does, sweeps as long as they converge; more sweeps where it
///    slides; in a large heap that comes to rest, sweeps and then the bodies that these leave, by themselves (IslandBlock);
///    all patches at once (IslandSolver) elsewhere, and where sweeps were not enough. Impulses that would add much energy are
///    corrected by sweeps. Where much moves and bodies would still sink deeply, all patches at once are tried, too; wherever
///    some still sink, normal impulses are found by themselves. An island is solved again where bodies are sent into others
///    that were out of reach, and where they turn so far that they sink along the way.
/// 4. Bodies held by something immovable move with their velocity at the end of the step, which is what contacts ask for; the
///    others fly their parabola, also those that only push each other. One that turns by more than a quarter of a radian does
///    so bit by bit, since no rule keeps its energy at once. Bodies that turn together are moved together
///    (PoseUpdate::exponential, PivotUpdate), unless they would sink so.
/// 5. Fast impacts bounce by Newton's restitution, at all points of an island at once: points that push and were
///    approached part with e times the speed on arrival, those that push without approach stay together. More sweeps find
///    these velocities; where they do not settle, all normal impulses are solved for together. A row of touching bodies that
///    is hit leaves as one piece, apart from the body that hit it; across gaps, one bounce follows the other, in up to
///    kMostBounces parts of the step. Where that asks for more energy than there is, limit_bounce() takes as much of it as
///    there is. A bounce is over then: the next step starts with no more impulse than this one (forget_bounces()).
/// 6. Overlap beyond a slop is corrected by displacements; a body keeps its velocity in its own frame, and so its energy.
/// 7. After all parts, islands at rest are put to sleep if that is on.
///
/// **Why it is stiff, quiet and fast.** A patch sticks as a whole, by one product with a 6×6
/// inverse. The impulses of the step before solve the next one as long as nothing changes, and nothing
/// does, because patches are kept; so an island at rest costs one sweep that changes nothing. While it
/// lands, the direct solver carries weight through all levels at once.
///
/// All thresholds are shares of the size, of gravity times the step, or of sqrt(g L).
/// \par Cost
/// At rest about 0.4 us for each pair that touches.
/// \par Extending it
/// Another solver is one more IslandMethod with its limits in IslandPlan (solve_again() only sweeps where sweeps have to do):
/// plan_island() chooses it, run_plan() runs it, accept() judges it, and what it keeps between steps is a member of
/// ContactDamped::Memory. It counts its work in StepReport::iterations. Its result is, within the cones of friction, the
/// `impulse` of each point and the three sums of friction of each patch, and in Island::now the velocities that these
/// impulses give, with MovingBody::changed of each body that gets one. It ends as IslandOutcome::swept unless it writes
/// ContactPatchPoint::solver_impulse too.
/// \algorithm{Contact-wise damping: section 6.3.1}
/// \deviation{Not in the thesis: its damping scales velocities of single bodies.}
/// \verified{Stacks stand for four seconds, from exact and from scattered places}
class ContactDamped : public Technique {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a count out of range
  explicit ContactDamped(const ContactDampedOptions& options = {});
  /// A copy with all memory.
  ContactDamped(const ContactDamped& other) = default;
  ContactDamped& operator=(const ContactDamped&) = delete;
  ~ContactDamped() override = default;

  [[nodiscard]] std::string_view name() const override { return "contact_damped"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override;

 private:
  // Kept between steps.
  struct Memory {
    BoundingTree broad_phase;
    PersistentManifolds manifolds;
    IslandOrder order;
    IslandSolver island_solver;
    SleepingRule sleeping;
    double last_dt = 0.0;  // [s] of the step before
  };
  // Velocities of a step, by body index.
  struct Velocities {
    std::vector<MovingBody> start;          // before gravity
    std::vector<MovingBody> free;           // with gravity, without contacts
    std::vector<MovingBody> end;            // with impulses
    std::vector<MovingBody> before_bounce;  // `end` before something bounced: bodies moved with it
  };
  // Storage of one step, kept so that a warm step allocates nothing.
  struct Storage {
    double step = 0.0;  // [s] the whole step
    int parts = 1;      // into which it is divided
    std::int64_t work =
        0;  // sweeps and iterations in the step so far, each times the patches of its island
    bool small_sinks = false;  // bodies of a small island sink into each other by turning
    bool crowded = false;      // small islands in motion are too many to solve each as if by itself
    std::vector<Bounds> bounds;
    std::vector<IndexPair> candidates;  // pairs that may touch
    std::vector<IndexPair> touching;    // bodies of the patches
    std::vector<char> in_flight;        // by body index: pushed by nothing that is held
    std::vector<char> sinks;            // by body index: it would, carried by others
    std::vector<char> hit;              // by patch: an impact too fast to stick
    std::vector<char> bounced;          // by patch: whether its island did
    std::vector<PushedPair> pushed;     // pairs with an impulse
    std::vector<Quat> start_wb;         // orientations at the start of the step
    std::vector<PatchImpulses>
        impulses_before_bounce;                  // by patch: impulses before something bounced
    KeptSolution kept;                           // of an island, while raised targets are tried
    KeptSolution kept_swept;                     // ditto, while a solver is tried
    KeptSolution kept_block;                     // of a block or after the direct solver, ditto
    IslandBlock block;                           // what sweeps leave of one
    std::vector<MovingBody> held;                // velocities with friction alone
    PivotUpdate pivots;                          // bodies that are moved together
    std::vector<MovingBody> displacements;       // of the overlap correction
    std::vector<OverlapCorrection> corrections;  // ditto, by patch
  };

  // A bounce in the middle of a step.
  struct FirstBounce {
    double time = 0.0;  // [s] from the start of the part
    int island = -1;
  };

  [[nodiscard]] FirstBounce first_bounce(const World& world, double dt);
  [[nodiscard]] int parts_of_step(double left, int k) const;
  [[nodiscard]] double length_of_part(const World& world, double left, int k) const;
  void shorten(double dt, double part, const World& world);
  double step_part(World& world, double dt, int k, StepReport& report);
  void solve(World& world, double dt, StepReport& report);
  void load(const World& world, double dt);
  void find_patches(World& world, double dt, StepReport& report);
  void find_candidates(const World& world, std::span<const MovingBody> moves, double dt);
  [[nodiscard]] bool is_sent_elsewhere(const World& world, double dt) const;
  bool find_missed(const World& world, double dt);
  void solve_missed(const World& world, double dt, StepReport& report);
  void solve_again(const Island& island, StepReport& report);
  void solve_turning(const World& world, double dt, StepReport& report);
  Island view_of_island(const World& world, int k, double dt);
  [[nodiscard]] IslandEffort effort() const;
  // Whether the step so far has cost twice its budget: it ends as cheaply as it can.
  [[nodiscard]] bool costs_too_much() const {
    return storage_.work >= 2 * std::int64_t{options_.budget};
  }
  [[nodiscard]] bool is_crowded(const World& world, double dt);
  void solve_island(const Island& island, StepReport& report);
  IslandOutcome run_plan(const Island& island, const IslandPlan& plan, const FirstSweeps& first,
                         StepReport& report);
  void accept(const Island& island, const IslandPlan& plan, IslandOutcome outcome,
              StepReport& report);
  void find_pivots(const World& world, double dt);
  bool drop_sinking_pivots(const World& world, double dt);
  bool carry(int k, double dt, World& world, StepReport& report) const;
  void move(World& world, double dt, StepReport& report);
  void bounce(World& world, double dt, StepReport& report);
  void forget_bounces();
  void correct_overlaps(World& world, double dt, StepReport& report);
  void store_bounced_velocities(World& world);
  void account(const World& world, StepReport& report) const;
  void notify_observer(const ContactPatch& patch, double dt) const;
  void forget_removed_bodies(const World& world);

  ContactDampedOptions options_;
  Memory memory_;
  Velocities velocities_;
  Storage storage_;
  double contact_time_ = 0.0;                   // [s] of the poses that the contacts belong to
  mutable std::vector<ContactRecord> records_;  // made by contacts()
  mutable bool recorded_ = false;
};

}  // namespace tumble
