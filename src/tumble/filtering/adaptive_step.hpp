/// \file
/// \brief Adaptive time step by halving (thesis 6.3.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/dynamics/wrapped_technique.hpp"
#include "tumble/filtering/corner_motion.hpp"
#include "tumble/filtering/tolerances.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <memory>
#include <vector>

namespace tumble {

/// Limits for halving the step. All are independent of size, mass and gravity.
struct AdaptiveStepOptions {
  int halvings = 4;  ///< the step is divided by at most 2 to this power, 0 to kMostHalvings
  int fewest = 0;  ///< and by at least 2 to this one, 0 to `halvings`; equal to it: fixed sub-steps
  /// [-] Largest relative displacement of two near bodies in a sub-step, as a share of the
  /// shorter of their shortest edges; above 0. Bodies do not pass through each other at 0.2
  double movement = tolerance::adaptive_movement;
  /// [rad] Largest rotation of a near body in a sub-step; above 0
  double turn = tolerance::adaptive_turn;
  /// [-] Overlap that requests smaller steps, as a share of the shortest edge of a movable body; above 0
  double overlap = tolerance::adaptive_overlap;
  /// [-] Reversal of a corner in contact that requests smaller steps: displacements in two successive
  /// sub-steps, there and back, as a share of its body's shortest edge; above 0. Infinity: never
  double shake = tolerance::adaptive_shake;
  int calm = 4;  ///< whole steps without a request before one halving is undone, at least 1

  static constexpr int kMostHalvings = 20;  ///< a millionth of a step
};

/// Gives any technique smaller steps while a body moves far, overlaps or chatters.
///
/// The thesis hopes (6.3.1) that smaller steps reduce chatter and shorten settling. All bodies share
/// one step, halved k times, \f$h = \Delta t / 2^k\f$; the whole steps do not change, so that frames are
/// at the same times.
///
/// **Choice of k**, before each sub-step: the larger of two numbers.
/// - *Prediction.* Two bodies whose swept bounds overlap must not move against each other by more than
///   `movement`, nor turn by more than `turn`. A body in free flight takes whole steps at any speed.
/// - *Feedback.* A sub-step with overlap, or with a corner in contact that reverses, requests one more
///   halving; after `calm` whole steps without a request one halving is undone.
///
/// A longer sub-step begins only at multiples of its length, so that the sub-steps fill the step. No
/// sub-step is repeated: its result affects the next one.
///
/// **Time.** The last sub-step takes the remaining time: \f$h\f$ but for rounding. World::time() after
/// the step is the sum of the time before and `dt`, to the bit, as without halving. World::steps()
/// counts sub-steps. A sub-step with StepStatus::unsolved or not_finite ends the step with that status.
///
/// **Report.** Sums over the sub-steps; `contacts` and contacts() are those of the last one. The
/// prediction costs a broad phase for each sub-step, which is not counted.
/// \par Determinism
/// Wall-clock time is not used. clone() copies all memory. With `halvings` 0 the result has the bits of
/// the technique alone.
/// \algorithm{Synchronised halving of the step: section 6.3.1}
/// \deviation{Not in the thesis, which only suggests smaller steps.}
/// \verified{A step without halvings has the bits of the technique alone}
class AdaptiveStep : public Cloned<WrappedTechnique, AdaptiveStep> {
 public:
  /// Wraps a technique.
  /// \param inner  the technique; its thresholds should depend on the step that it is given
  /// \throws std::invalid_argument for no technique, or an option out of range
  explicit AdaptiveStep(std::unique_ptr<Technique> inner, const AdaptiveStepOptions& options = {});

  StepReport step(World& world, double dt) override;

  /// The sub-steps of the last step [s]: their lengths in order; valid until the next step.
  [[nodiscard]] std::span<const double> substeps() const { return substeps_; }
  /// The bodies in contact in any sub-step of the last step: ids, ascending; valid until the next step.
  [[nodiscard]] std::span<const BodyId> touched() const { return touched_; }

 private:
  /// Displacement of a body in contact in a sub-step.
  struct Displacement {
    BodyId id{};
    Corners corners_w;  // [m] of each corner
  };
  [[nodiscard]] int halvings_for(const World& world, double dt, int least);
  void find_near(const World& world, double h);
  [[nodiscard]] bool requests_halving(const World& world, const StepReport& report) const;
  void store_corners(const World& world);
  void store_displacements(const World& world);

  AdaptiveStepOptions options_;
  BoundingTree broad_phase_;

  // Memory from step to step.
  int level_ = 0;           // halvings requested by feedback
  std::int64_t quiet_ = 0;  // time since the last request, in the shortest sub-steps
  std::vector<Displacement> displacements_;  // of the last sub-step, ascending by id
  std::vector<double> substeps_;
  std::vector<BodyId> touched_;

  // Storage of one sub-step.
  std::vector<Corners> before_;                     // by index
  std::vector<Displacement> displacements_before_;  // of the sub-step before
  std::vector<BodyId> touching_;                    // ascending
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
};

}  // namespace tumble
