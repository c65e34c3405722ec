/// \file
/// \brief A step that is halved as often as the bodies need it (thesis 6.3.1).
#pragma once

#include "tumble/dynamics/wrapped_technique.hpp"
#include "tumble/filtering/corner_motion.hpp"
#include "tumble/filtering/tolerances.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <memory>
#include <string_view>
#include <vector>

namespace tumble {

/// When a step is halved. All numbers are free of size, mass and gravity.
struct AdaptiveStepOptions {
  int halvings = 4;  ///< a step is at most divided by 2 to this power, 0 to kMostHalvings
  int fewest = 0;  ///< and at least by 2 to this one, 0 to `halvings`; equal to it: fixed sub-steps
  /// [-] How far two bodies that are near may move against each other in a sub-step, as a share of the
  /// shorter of their shortest edges; above 0. Bodies do not pass through each other at 0.2
  double movement = tolerance::adaptive_movement;
  /// [rad] How far a body that is near another one may turn in a sub-step; above 0
  double turn = tolerance::adaptive_turn;
  /// [-] Overlap that calls for smaller steps, as a share of the shortest edge that moves; above 0
  double overlap = tolerance::adaptive_overlap;
  /// [-] A corner of a body in contact that turns round on a way of this share of its shortest edge, there
  /// and back in two sub-steps, chatters and calls for smaller steps; above 0. Infinity: never
  double shake = tolerance::adaptive_shake;
  int calm = 4;  ///< whole steps without a call before one halving is taken back, at least 1

  static constexpr int kMostHalvings = 20;  ///< a millionth of a step
};

/// Lets any technique take smaller steps while something moves far, overlaps or chatters.
///
/// The thesis hopes (6.3.1) that smaller steps make chatter less and rest come sooner. All bodies
/// share one step, halved k times, \f$h = \Delta t / 2^k\f$; whole steps stay what they were, so that
/// frames are at the same times whatever happens in between.
///
/// **How k is found**, before each sub-step: the larger of two numbers.
/// - *What is about to happen.* Of two bodies whose ways in the sub-step come near each other, none may
///   move against the other by more than `movement`, nor turn by more than `turn`. A body that flies
///   alone takes whole steps, however fast it is.
/// - *What has happened.* A sub-step that finds overlap, or a corner in contact that is moved to and
///   fro, asks for one halving more; after `calm` whole steps without such a call one is taken back.
///
/// A longer sub-step begins only at multiples of its length, else they would not fill the step. No
/// sub-step is taken again: what is found counts for the next one.
///
/// **Time.** The last sub-step is as long as is left to the end: that is \f$h\f$ but for the rounding of
/// the clock. World::time() after the step is the sum of the time before and `dt`, to the bit, as without
/// halving. World::steps() counts sub-steps. A step that ends as StepStatus::unsolved or not_finite ends
/// with the sub-step that did.
///
/// **Report.** Sums over the sub-steps; `contacts` and contacts() are those of the last one. Looking
/// ahead costs a broad phase for each sub-step, which no count contains.
/// \par Determinism
/// No clock is asked. What is remembered from step to step is part of clone(). With `halvings` 0 all
/// bits are those of the technique alone.
/// \algorithm{Synchronised halving of the step: section 6.3.1}
/// \deviation{Not in the thesis, which only suggests smaller steps.}
/// \verified{A step without halvings has the bits of the technique alone}
class AdaptiveStep : public WrappedTechnique {
 public:
  /// Wraps a technique.
  /// \param inner    what advances the world; its thresholds should know the step that they are given
  /// \param options  when to halve
  /// \throws std::invalid_argument for no technique, or an option out of range
  explicit AdaptiveStep(std::unique_ptr<Technique> inner, const AdaptiveStepOptions& options = {});
  /// A copy with all memory.
  /// \param other the original
  AdaptiveStep(const AdaptiveStep& other);

  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;

  /// The sub-steps of the last step.
  /// \return [s] their lengths in order; valid until the next step
  [[nodiscard]] std::span<const double> substeps() const { return substeps_; }
  /// Who was in contact in any sub-step of the last step.
  /// \return ids, ascending; valid until the next step
  [[nodiscard]] std::span<const BodyId> touched() const { return touched_; }

 private:
  /// How a body in contact has moved in a sub-step.
  struct Way {
    BodyId id{};
    Corners way_w;  // [m] of each corner
  };
  [[nodiscard]] int halvings_for(const World& world, double dt, int least);
  void find_near(const World& world, double h);
  [[nodiscard]] bool takes_call(const World& world, const StepReport& report) const;
  void remember_corners(const World& world);
  void take_ways(const World& world);

  AdaptiveStepOptions options_;
  std::unique_ptr<BroadPhase> broad_phase_;

  // Memory from step to step.
  int level_ = 0;           // halvings that what has happened asks for
  std::int64_t quiet_ = 0;  // for how long nothing has called, in the shortest sub-steps
  std::vector<Way> ways_;   // of the last sub-step, ascending by id
  std::vector<double> substeps_;
  std::vector<BodyId> touched_;

  // Storage of one sub-step.
  std::vector<Corners> before_;   // by index
  std::vector<Way> ways_before_;  // of the sub-step before
  std::vector<BodyId> touching_;  // ascending
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
};

}  // namespace tumble
