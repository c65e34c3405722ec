/// \file
/// \brief The default technique: contact areas that stick, slide or let go, solved stiff (thesis 6.3.1).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/graph.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/persistent_manifolds.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace tumble {

/// Options of the technique.
struct ContactDampedOptions {
  /// Sweeps over the areas of a large island that is not solved as a whole, at least 1; small islands, of up
  /// to twenty bodies, get at least fifty.
  int passes = 6;
  int rounds = 100;  ///< of the direct solver, three times as many for a small island; 0: none
  int repair_passes = 50;                           ///< sweeps that end overlap, at least 1
  bool sleeping = false;                            ///< islands at rest are left alone (thesis 4.5)
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  PoseUpdate pose = PoseUpdate::separate;           ///< how bodies that push each other are moved
};

/// Damping as friction between bodies, in place of scaled velocities, free of size and mass.
///
/// What the thesis asks for as future work (6.3.1): its damping slows each body by itself; this one
/// takes energy out of the motion of two bodies *against each other*, where they touch, and what one
/// loses in momentum the other gets. Friction, torsion and the inelastic normal impulse are
/// the only dissipation.
///
/// **A step.** Velocities get their share of gravity. Contact areas are found at the start of the step
/// and kept while their bodies rest (PersistentManifolds). Each island begins with the impulses of the step before
/// and one sweep over its areas (solve_patch()). If that does not settle it, sweeps go on where it moves
/// fast, and all areas are solved together (IslandSolver) where it does not, over some steps until it
/// rests. Bodies that something pushes
/// move with the velocities at the end of the step; the others fly their parabola. Fast impacts
/// bounce. Those that turn together are kept together by PoseUpdate::exponential (PivotUpdate), as
/// velocities agree where the step begins. What overlap is left is taken away by moves
/// that change no velocity.
///
/// **Why it is stiff, quiet and fast at once.** An area sticks as a whole, by one product with a 6×6
/// inverse. The impulses of the step before solve the next one as long as nothing changes, and nothing
/// does, because areas are kept; so a island at rest is one sweep that finds nothing to do. While it
/// lands, the direct solver carries weight through all levels at once.
///
/// All thresholds are shares of the size, of gravity times the step, or of sqrt(g L).
/// \par Cost
/// At rest about 0.4 us for each pair that touches.
/// \algorithm{Contact-wise damping: section 6.3.1}
/// \deviation{Not in the thesis: its damping scales velocities of single bodies.}
/// \verified{Stacks stand for four seconds, from exact and from scattered places}
class ContactDamped : public Technique {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for a count out of range
  explicit ContactDamped(const ContactDampedOptions& options = {});
  /// A copy with all memory.
  /// \param other the original
  ContactDamped(const ContactDamped& other);
  ContactDamped& operator=(const ContactDamped&) = delete;
  ~ContactDamped() override = default;

  [[nodiscard]] std::string_view name() const override { return "contact_damped"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override;

 private:
  void load(const World& world, double dt);
  void find_areas(World& world, double dt, StepReport& report);
  void find_candidates(const World& world, double dt);
  void order_islands(const World& world);
  void solve_island(const World& world, int island, double dt, StepReport& report);
  double sweep(std::span<const int> contacts, bool down, int rounds, double rest,
               StepReport& report);
  [[nodiscard]] bool slides(std::span<const int> contacts, double unit) const;
  [[nodiscard]] std::pair<double, double> unrest(const World& world, int island, double dt) const;
  [[nodiscard]] double swing(const World& world, int island, double dt) const;
  [[nodiscard]] bool hurries(const World& world, int island, double dt) const;
  [[nodiscard]] double hardest(const World& world, int island) const;
  [[nodiscard]] double smallest(int island) const;
  void forget(int island);
  void release(int island);
  void bounce_island(const World& world, int island, double dt, StepReport& report);
  void guard_energy(const World& world, int island, StepReport& report);
  void find_carried(const World& world);
  void move(World& world, double dt, StepReport& report);
  void bounce(World& world, double dt, StepReport& report);
  void repair(World& world, double dt, StepReport& report);
  void account(const World& world, double dt, StepReport& report);
  void tell(const ContactPatch& block, double time) const;
  [[nodiscard]] double speed_scale(const World& world, int island, double dt) const;
  [[nodiscard]] std::span<const int> ordered(int island) const;

  ContactDampedOptions options_;
  std::unique_ptr<BroadPhase> broad_phase_;
  PersistentManifolds areas_;
  IslandSolver island_solver_;
  SleepingRule sleeping_;
  PivotUpdate carried_;
  Islands islands_;
  ContactGraph graph_;
  double last_dt_ = 0.0;  // [s] of the step before
  /// Islands, named by their first body, that the step before solved as a whole; ascending.
  std::vector<BodyId> unsettled_;
  std::vector<BodyId> unsettling_;  // and those of this step
  // What islands were ordered for: how many bodies there were, gravity, the pairs by index and by name.
  int ordered_for_ = -1;
  Vec3 ordered_gravity_w_ = Vec3::Zero();

  // Storage of one step, kept so that a warm step asks for no memory.
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> touching_;               // pairs of the areas
  std::vector<IndexPair> touched_;                // and of the step before
  std::vector<std::pair<BodyId, BodyId>> names_;  // of the areas' bodies
  std::vector<std::pair<BodyId, BodyId>> named_;  // and of the step before
  std::vector<SupportEdge> edges_;
  std::vector<int> order_;          // areas, island by island, from the ground up
  std::vector<int> order_start_;    // of a island's areas in order_
  std::vector<MovingBody> start_;   // before gravity
  std::vector<MovingBody> free_;    // with gravity, without contacts
  std::vector<MovingBody> bodies_;  // at the end
  std::vector<MovingBody> moves_;   // of the repair
  std::vector<MovingBody> moved_;   // velocities with which bodies moved, if something bounced
  std::vector<char> hit_;           // by area: it was, so fast that it does not stick
  bool bounced_ = false;            // something did, in this step
  std::vector<char> flies_;         // by index: nothing pushes it
  std::vector<PushedPair> pushed_;  // by the areas
  double contact_time_ = 0.0;       // [s] of the poses that the contacts belong to
  mutable std::vector<ContactRecord> records_;
  mutable bool recorded_ = false;
};

}  // namespace tumble
