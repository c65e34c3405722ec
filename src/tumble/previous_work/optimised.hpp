/// \file
/// \brief Animation by optimisation: the nearest poses without overlap, then the momenta (thesis 2.7.2).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/math/projected_descent.hpp"
#include "tumble/previous_work/near_points.hpp"
#include "tumble/previous_work/rubbing_points.hpp"

#include <vector>

namespace tumble {

/// Options of animation by optimisation.
struct OptimisedOptions {
  double reach = 0.25;        ///< [-] largest movement of a body in a round, over the shortest edge
  int rounds = 100;           ///< quadratic programs for the poses of a step, at most
  int budget = 200;           ///< steps of the iteration of a quadratic program
  StickyOptions sticky = {};  ///< which impacts do not bounce
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn in flight
};

/// Names the options to a visitor, see options.hpp.
template <class Visitor>
void describe(OptimisedOptions& o, Visitor& v) {
  v.number("reach", o.reach, 0.01, 1.0, "-",
           "largest movement of a body in a round, over the shortest edge");
  v.whole("rounds", o.rounds, 1, 100000, "quadratic programs for the poses of a step, at most");
  v.whole("budget", o.budget, 1, 1000000, "steps of the iteration of a quadratic program");
  v.word("sticky", o.sticky.rule,
         {{"speed", StickyRule::speed},
          {"step_size", StickyRule::step_size},
          {"off", StickyRule::off}},
         "rule for collisions that are too slow to bounce (thesis 4.3)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Work of the quadratic programs since construction: points times unknowns of each product, as if with a full matrix.
struct OptimisedWork {
  std::int64_t poses = 0;    ///< multiplications for the poses
  std::int64_t momenta = 0;  ///< multiplications for the momenta
};

/// Milenkovic and Schmidl's steps of any length: no time of a collision, no force.
///
/// **Poses.** Each body has a target q*, the pose of free flight at the end of the step. The poses of the step are those
/// nearest to all targets that do not overlap,
/// \f[ \tfrac12 (q - q^*)^{\mathsf T} M (q - q^*) \quad\text{least for}\quad J q + d \ge 0 , \f]
/// with a half space for each point of the planes that separate two bodies. Half spaces are right for small moves
/// only: in a round no corner moves farther than `reach`, then they are made anew, until nothing moves. So bodies go to
/// their targets on a way without overlap, and pass through nothing.
///
/// **Momenta.** Those of free flight at the end of the step, plus impulses p at the points that touch now: of all
/// that contacts may give, those with the least kinetic energy. Without bounces that is where no point goes in.
///
/// **Friction** limits the multipliers of both programs across the normal, by Coulomb's coefficient times the one along it: sliding
/// points are held back as far as they may. Where the iteration for the momenta does not end because more push allows more friction,
/// pushes are found alone, and then friction that goes with them (`fallbacks`). The paper has it in forces of a third program, for the next step.
///
/// **Energy.** Bodies that are lifted to make room, and fly no more, have energy that none of them had. The excess over the energy
/// of the start is taken from the speed of the bodies that touch. Impulses that add energy, which the iteration with friction may leave
/// at its budget, are made smaller all alike until they add none: that keeps the momentum.
///
/// **What it cannot do.** A bounce is at the end of its step, with the speed of the start of it. A body that is stopped on its way
/// stays until the end of the step; one that is hit off its middle turns aside on its way and goes round the
/// obstacle, without an impulse, if the way is long enough. It turns by half a turn in a step at most on its way; what turns farther takes the shorter one. A long body that is turned
/// aside keeps its angular momentum, or the energy of its spin if that would grow by more than tolerance::optimised_spin_up. Where the
/// rounds end before the way does, bodies stop where they are, the last tenth of the rounds parts them, and the step ends as StepStatus::event_cap.
/// \par Cost and determinism
/// At most `rounds` + 2 quadratic programs, each of `budget` steps of O(points). No allocation once warm.
/// \see Milenkovic, Schmidl, "Optimization-based animation", SIGGRAPH 2001.
/// \algorithm{Animation by optimisation: section 2.7.2}
/// \deviation{A descent with a budget in place of exact quadratic programs\; friction in both of them in place of a third.}
/// \verified{A box that falls lands in one step of any length}
class Optimised : public Cloned<Technique, Optimised> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range
  explicit Optimised(const OptimisedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "optimised"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  /// What the programs have cost so far.
  [[nodiscard]] const OptimisedWork& work() const { return work_; }

 private:
  void find_poses(World& world, double dt, StepReport& report);
  double go_on(World& world, bool fly_on, double& reach, StepReport& report);
  void find_momenta(World& world, double dt, StepReport& report);
  void end_spin_up(World& world);
  bool push(const World& world, double dt, bool bounce, StepReport& report);
  void give_pushes(const World& world, StepReport& report);
  void weaken(const World& world, StepReport& report);
  void take_gain(double gain, StepReport& report);
  std::int64_t solve(StepReport& report);

  OptimisedOptions options_;
  NearPoints near_, touching_;
  double last_dt_ = 0.0;  // [s] of the step before, or 0
  OptimisedWork work_;

  // Of one step; kept so that a warm step asks for no memory.
  RubbingPoints rows_;
  ProjectedDescent<RubbingPoints> descent_;
  std::vector<BodyState> targets_;
  std::vector<MovingBody> before_, free_, moving_;
  std::vector<char> pushed_;  // by body index: something is in its way
  std::vector<double> least_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
