/// \file
/// \brief The synchronised timewarp in its simple form (thesis 5.1, A.1: SIMPLESYNCTIMEWARP).
///
/// Uses no other chapter.
#pragma once

#include "tumble/timewarp/synchronised_timewarp.hpp"

namespace tumble {

/// Collisions in the order of their times, taking back only the two bodies of each.
///
/// At the start of a frame every body flies to the frame's end, into its test state. Pairs that
/// overlap there are searched for the time at which they met, and wait in a queue. Of the earliest one
/// the two bodies, and no others, are put where they were at that time; they collide, fly to the
/// end anew, and what was foreseen for them is found afresh. So a collision costs the same however
/// many bodies there are, where `basic` takes back all of them.
///
/// What it misses is the thesis's own: bodies that meet and part within a frame or change places (T5),
/// and whatever follows from that. Collisions closer than the resolution come in the order of bodies
/// (T9). Bodies that rest on one another are left to the end of the frame: see ContactStage.
/// \par Cost
/// A frame: n flights and a broad phase. A collision: 4 flights, n comparisons of bounds, and the
/// searches of pairs that are near the two.
/// \algorithm{SIMPLESYNCTIMEWARP: section 5.1 and appendix A.1}
/// \deviation{Pairs that rest on one another are left to the end of the frame, since the listing would not come to its end.}
/// \deviation{Immovable bodies are not stamped, and what was foreseen with them is kept.}
/// \verified{Three boxes on a line collide at the times of the closed form}
/// \verified{At the end of a frame no body's time stamp is ahead of its state}
class TimewarpSimple final : public SynchronisedTimewarp {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSimple(const TimewarpOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_simple"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
};

}  // namespace tumble
