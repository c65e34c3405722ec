/// \file
/// \brief Bounces that follow each other within a step (thesis 4.3).
#pragma once

#include "tumble/contact_damped/island.hpp"

namespace tumble {

/// [-] Parts of a step that end with a bounce, at most. Reason: a row of ten boxes passes a push on in nine bounces. (4.3)
inline constexpr int kMostBounces = 20;

/// [-] Share of a step within which two bounces count as simultaneous. Reason: at 1 m/s and 60 Hz 17 micrometres, near the gap
/// at which boxes count as touching. (4.3)
inline constexpr double kSimultaneous = 1e-3;

/// The slowest approach [m/s] that bounces; slower ones stick.
/// \param size     [m] shortest edge
/// \param dt       [s] of the whole step
[[nodiscard]] double slowest_bounce(double gravity, double size, double dt);

/// Whether a patch was hit: one of its points has an impulse and approached fast.
/// \param patch    after its impulses were found
/// \param slowest  [m/s] slowest_bounce()
[[nodiscard]] bool was_hit(const ContactPatch& patch, double slowest);

/// The time of the first bounce that leaves another patch of its island open. All impacts of a step bounce at its end at
/// once, as they should in a row of boxes that touch; across gaps, however small, one follows the other, and the step has to end
/// in between.
/// \param island  after its impulses were found
/// \param step    [s] the whole step, of which this may be a part
/// \return [s] just after the first such bounce, less than island.dt; or island.dt
/// \par Cost
/// A comparison for each two patches of the island, if one of them was hit and bounces.
[[nodiscard]] double time_to_first_bounce(const Island& island, double step);

/// Lets patches that are still open when an island bounces ask for nothing. A body that arrives is slowed for the whole part of the
/// step, and one that flies along with it would meet it.
/// \param island  the targets of such patches are changed
/// \param time    [s] of the bounce
void release_open_patches(const Island& island, double time);

}  // namespace tumble
