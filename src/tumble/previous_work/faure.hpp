/// \file
/// \brief Faure's energy method as a technique (thesis 2.6.4).
///
/// Depends on no other technique.
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/math/projected_descent.hpp"
#include "tumble/previous_work/rubbing_points.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <memory>
#include <vector>

namespace tumble {

/// Options of Faure's method.
struct FaureOptions {
  int budget = 60;  ///< steps of the iteration in a step of time, at least 0
  double wanted =
      tolerance::faure_small;  ///< [-] step at which it ends earlier, over that from no impulses
  bool warm = true;            ///< whether it begins with the impulses of the step before
  StickyOptions sticky = {};   ///< which impacts do not bounce
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
};

template <class Visitor>
void describe(FaureOptions& o, Visitor& v) {
  v.whole("budget", o.budget, 0, 1000000, "steps of the iteration in a step of time");
  v.number("wanted", o.wanted, 0.0, 1.0, "-",
           "step at which the iteration ends before its budget, over that from no impulses");
  v.flag("warm", o.warm, "begin with the impulses of the step before");
  v.word("sticky", o.sticky.rule,
         {{"speed", StickyRule::speed},
          {"step_size", StickyRule::step_size},
          {"off", StickyRule::off}},
         "rule for collisions that are too slow to bounce (thesis 4.3)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Faure's energy method: impulses of all contacts at once, by as many steps down the energy as there is time for.
///
/// A step takes resting contacts and impacts together, as `time_stepping` does: points may close their gaps in it and no
/// more, and impacts bounce by Newton's law at each point. ProjectedDescent looks for the impulses. Without
/// friction each of its steps lowers the energy of the motion that is not allowed, so that it can be ended at any time; with friction
/// it need not. An approach that is left when the budget ends makes bodies sink in; they are moved apart after the step.
///
/// **What it cannot do.** With a small budget and without the impulses of the step before ten boxes tremble, by a millimetre with
/// ten steps; warm starts hide that as long as a pile stands. Where bounces at several points or with friction would add
/// energy, nothing bounces in that step (`fallbacks`). Points are looked for
/// within half of the shortest edge, so a fast body may pass through a thin one, and a long one that
/// turns by radians in a step through anything, which a run reports (PassageCheck).
/// \par Cost and determinism
/// O(points) for each step of the iteration. No allocation once warm.
/// \see Faure, "An energy-based approach for contact force computation", Computer Graphics Forum 15(3), 1996.
/// \algorithm{Faure's iteration: section 2.6.4}
/// \deviation{See FaureSolver; impulses of a step of time in place of forces\, so that impacts are no case of their own.}
/// \verified{A stack under Faure's method rests, and sinks in if its budget is small}
class Faure : public Technique {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range
  explicit Faure(const FaureOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "faure"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  /// How far the iteration came in the last step.
  [[nodiscard]] const DescentReport& descent() const { return descent_; }

 private:
  StepReport step_part(World& world, double dt);
  void find_contacts(const World& world, double dt, StepReport& report);
  bool find_least_motions(const World& world, double dt, bool bounce);
  bool push(const World& world, double dt, bool bounce, StepReport& report);
  [[nodiscard]] bool gains(const StepReport& report) const;

  FaureOptions options_;
  BoundingTree broad_phase_;
  RubbingPoints rows_;
  ProjectedDescent<RubbingPoints> iteration_;
  DescentReport descent_;
  OverlapRepair repair_;
  double last_dt_ = 0.0;  // [s] of the step before, or 0
  ContactList contacts_, previous_;

  // Of one step; kept so that a warm step asks for no memory.
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<MovingBody> start_, moving_;
  std::vector<double> least_;  // [m/s] of each point
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
