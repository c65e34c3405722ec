/// \file
/// \brief The synchronised timewarp that looks at neighbours too (thesis 5.1, A.1: SAFERSYNCTIMEWARP).
///
/// Uses no other chapter.
#pragma once

#include "tumble/timewarp/synchronised_timewarp.hpp"

namespace tumble {

/// As TimewarpSimple, but before two bodies collide everybody near them is put to that time, to see
/// whether a neighbour has met another body earlier.
///
/// Near is a body that may have touched one of the two on the way there (F7). If two of them overlap at that
/// time, and met before it by more than the resolution, that collision goes into the queue and the
/// present one goes back (F5, F6). So bodies that meet on the way to a collision and would have parted
/// by the end of the frame are found, if a collision that is found happens beside them while they
/// overlap. Bodies that are not near a collision, or overlap for shorter than that, are missed as before, and
/// a collision that was resolved too early is not taken back.
/// \par Cost
/// That of TimewarpSimple, and for each collision two flights and a test with each other for
/// every body that is near.
/// \algorithm{SAFERSYNCTIMEWARP: section 5.1 and appendix A.1}
/// \deviation{Pairs that rest on one another are left to the end of the frame, since the listing would not come to its end.}
/// \deviation{Immovable bodies are not stamped, and what was foreseen with them is kept.}
/// \verified{A body that flies past keeps its time and its place}
/// \verified{At the end of a frame no body's time stamp is ahead of its state}
class TimewarpSafer final : public SynchronisedTimewarp {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSafer(const TimewarpOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_safer"; }
  /// Advances the world.
  /// \param world  all bodies; in and out
  /// \param dt     [s] above 0
  /// \return what was done; `restarts` counts the collisions that went back for an earlier one
  /// \throws std::invalid_argument for a dt that is not finite and above 0
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
};

}  // namespace tumble
