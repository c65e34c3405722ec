/// \file
/// \brief The synchronised timewarp in its simple form (thesis 5.1, A.1: SIMPLESYNCTIMEWARP).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

namespace tumble {

/// Collisions in order of time, rolling back only the two bodies of each.
///
/// At the start of a frame every body flies to the frame's end, into its test state. Pairs that overlap
/// there are searched for the time of their collision and put into a queue. The two bodies of the
/// earliest collision, and no others, go back to its time; the collision is resolved, both fly to the
/// end again, and new collisions are predicted for them. So the cost of a collision does not depend on
/// the number of bodies, whereas `basic` rolls back all of them.
///
/// As in the thesis, bodies that collide and separate within a frame, or change places, are missed
/// (T5), with all consequences. Collisions closer than the resolution are resolved in order of the
/// bodies' indices (T9). Resting pairs are deferred to the end of the frame: see ContactStage.
/// \par Cost
/// A frame: n flights and a broad phase. A collision: 4 flights, n comparisons of bounds, and a search
/// for each near pair.
/// \algorithm{SIMPLESYNCTIMEWARP: section 5.1 and appendix A.1}
/// \deviation{Resting pairs are deferred to the end of the frame, since the listing would not terminate.}
/// \deviation{Immovable bodies are not stamped, and collisions predicted with them are kept.}
/// \verified{Three boxes on a line collide at the times of the closed form}
/// \verified{At the end of a frame no body's time stamp is ahead of its state}
class TimewarpSimple final : public Cloned<SynchronisedTimewarp, TimewarpSimple> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSimple(const TimewarpOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_simple"; }
  StepReport step(World& world, double dt) override;
};

}  // namespace tumble
