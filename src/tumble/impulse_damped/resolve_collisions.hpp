/// \file
/// \brief The listing RESOLVECOLLISIONS (thesis 5.2, A.2).
#pragma once

#include "tumble/impulse_damped/collision_noise.hpp"
#include "tumble/impulse_damped/damped_stage.hpp"

namespace tumble {

/// The listing RESOLVECOLLISIONS: bodies that will overlap at the end of the step bounce, pass by
/// pass.
///
/// Restitution is used in every pass, also on what earlier passes left of an approach (so a stack
/// that is not quite at rest bounces a little). A body at rest does not bounce: gravity is in its
/// predicted place but not in its velocity, and so it does not approach.
/// \param stage   velocities in and out
/// \param passes  NUM_COLLISION_ITERATIONS, at least 0
/// \param noise   what is left to chance (thesis 4.2)
/// \param random  the stream of this step
/// \algorithm{RESOLVECOLLISIONS: appendix A.2}
/// \verified{A box at rest does not bounce though restitution is 0.9}
void resolve_collisions(DampedStage& stage, int passes, const NoiseOptions& noise,
                        const Random& random);

}  // namespace tumble
