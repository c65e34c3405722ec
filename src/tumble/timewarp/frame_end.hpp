/// \file
/// \brief The end of a timewarp's frame: who rests is stopped, who overlaps is moved apart (thesis
///        A.1: fixInterpenetration).
#pragma once

#include "tumble/contact/repair.hpp"
#include "tumble/timewarp/instant_impacts.hpp"

#include <memory>
#include <span>
#include <vector>

namespace tumble {

/// Ends a frame.
///
/// Pairs that were left to the end of the frame (see ContactStage) are resolved together, without
/// restitution, and with them those that touch one another and hang together with them through
/// movable bodies. The cubes of a stack fall alike, so that none of them meets another one in a frame;
/// if the lowest alone were stopped at its end, the others would fall on it in the next. To touch is to
/// be no farther apart than gravity brings bodies within a resolution of the search at the frame's last
/// speed of fall, g dt times the resolution.
///
/// Then all bodies that overlap are moved apart. What a pair at rest has fallen in the frame is taken back
/// along the normal only: on a slope of angle θ it creeps by \f$\tfrac12 g\sin\theta\,\Delta t^2\f$ in each.
/// \par Cost
/// A broad phase, a separation for each near pair, and two if anybody rests. No allocation once warm.
/// \verified{A box and a stack of five at rest stay where they are}
class FrameEnd {
 public:
  /// Makes the storage.
  FrameEnd();
  /// Makes new storage; there is nothing to copy.
  FrameEnd(const FrameEnd&) : FrameEnd() {}
  FrameEnd& operator=(const FrameEnd&) = delete;
  ~FrameEnd() = default;

  /// Ends a frame.
  /// \param world       bodies at its end; in and out
  /// \param dt          [s] its length
  /// \param resolution  [s] of the search for collisions
  /// \param held        pairs that were left to it, sorted, each once
  /// \param report      gets counts, energy and the deepest overlap
  /// \param records     gets the contact points of those who rest
  void settle(World& world, double dt, double resolution, std::span<const IndexPair> held,
              StepReport& report, std::vector<ContactRecord>& records);

 private:
  void join_touching(const World& world, double reach, StepReport& report);

  std::unique_ptr<BroadPhase> broad_phase_;
  InstantImpacts impacts_;
  OverlapRepair repair_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> resting_;
  std::vector<IndexPair> touching_;
  std::vector<char> joined_;  // by index: whether a movable body is in one of the resting pairs
};

}  // namespace tumble
