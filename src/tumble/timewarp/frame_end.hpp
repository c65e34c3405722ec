/// \file
/// \brief The end of a timewarp's frame: resting contacts and repair of overlap (thesis A.1:
///        fixInterpenetration).
#pragma once

#include "tumble/contact/repair.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/timewarp/instant_impacts.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Resolves resting contacts and repairs overlap at the end of a frame.
///
/// Deferred pairs (see ContactStage) are resolved together, without restitution, with all pairs in
/// contact that are connected to them through movable bodies. The cubes of a stack fall alike, so that
/// none of them collides with another in a frame; if only the lowest were stopped at its end, the
/// others would fall on it in the next. Pairs count as in contact up to a gap of g dt times the
/// resolution: the distance that bodies approach in one resolution at the speed gained in the frame.
///
/// Then all overlapping bodies are moved apart, along the normal only: on a slope of angle θ a resting
/// body creeps by \f$\tfrac12 g\sin\theta\,\Delta t^2\f$ in each frame.
/// \par Cost
/// A broad phase and a separation for each near pair, twice with resting pairs. No allocation once warm.
/// \verified{A box and a stack of five at rest stay where they are}
class FrameEnd {
 public:
  /// Makes it with empty storage.
  FrameEnd() = default;
  /// A copy has fresh storage; there is no state to copy.
  FrameEnd(const FrameEnd&) : FrameEnd() {}

  /// Ends a frame.
  /// \param world       bodies at its end; in and out
  /// \param resolution  [s] of the search for collisions
  /// \param held        deferred pairs, sorted, each once
  /// \param report      gets counts, energy and the deepest overlap
  /// \param records     gets the contact points of resting pairs
  void settle(World& world, double dt, double resolution, std::span<const IndexPair> held,
              StepReport& report, std::vector<ContactRecord>& records);

 private:
  void join_touching(const World& world, double reach, StepReport& report);

  BoundingTree broad_phase_;
  InstantImpacts impacts_;
  OverlapRepair repair_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> resting_;
  std::vector<IndexPair> touching_;
  std::vector<char> joined_;  // by index: whether a movable body is in one of the resting pairs
};

}  // namespace tumble
