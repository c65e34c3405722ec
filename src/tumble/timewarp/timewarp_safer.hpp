/// \file
/// \brief The synchronised timewarp that also tests neighbours (thesis 5.1, A.1: SAFERSYNCTIMEWARP).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

namespace tumble {

/// TimewarpSimple with a check before each collision: bodies near the two are moved to that time, to
/// find out whether one of them has collided earlier.
///
/// Near bodies are those that may have touched one of the two until then (F7). If two of them overlap
/// at that time, and collided before it by more than the resolution, that collision goes into the
/// queue and the present one back to it (F5, F6). So a collision whose bodies would have separated by
/// the end of the frame is found if another collision happens near it while they overlap. Other short
/// overlaps are missed as before, and a collision that was resolved too early is not rolled back.
/// \par Cost
/// That of TimewarpSimple, and for each collision two flights for every near body and a test for every
/// pair of them.
/// \algorithm{SAFERSYNCTIMEWARP: section 5.1 and appendix A.1}
/// \deviation{Resting pairs are deferred to the end of the frame, since the listing would not terminate.}
/// \deviation{Immovable bodies are not stamped, and collisions predicted with them are kept.}
/// \verified{At the end of a frame no body's time stamp is ahead of its state}
class TimewarpSafer final : public Cloned<SynchronisedTimewarp, TimewarpSafer> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSafer(const TimewarpOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_safer"; }
  /// Advances the world.
  /// \return the report; `restarts` counts the collisions put back for an earlier one
  /// \throws std::invalid_argument for a dt that is not finite and above 0
  StepReport step(World& world, double dt) override;
};

}  // namespace tumble
