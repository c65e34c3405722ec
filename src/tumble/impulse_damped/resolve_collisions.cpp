/// \file
/// \brief The listing RESOLVECOLLISIONS.
#include "tumble/impulse_damped/damped_stage.hpp"

namespace tumble {

void resolve_collisions(DampedStage& stage, int passes, const NoiseOptions& noise,
                        const Random& random) {
  // [RESOLVECOLLISIONS:1-7]
  // Several passes. In each one all bodies are advanced as if
  // nothing were in their way; those that overlap there collide, one
  // pair after the other by age. The places were copies: there
  // is nothing to put back but these.
  for (int pass = 1; pass <= passes; ++pass) {
    stage.predict_and_gather();
    for (Contact& collision : stage.collisions) {
      double restitution = collision.restitution;
      if (!stage.bodies.holds_firm(stage.world, collision) &&
          left_to_chance(collision, stage.bodies.moving, stage.world, noise)) {
        const NoisyCollision noisy = vary(collision, stage.bodies.moving, noise, random);
        collision.normal_w = noisy.normal_w;
        restitution = noisy.restitution;
      }
      stage.run(collision, restitution, TemporaryGravity::velocity_no_gravity);
    }
    ++stage.report.iterations;
  }
  // [RESOLVECOLLISIONS:1-7]
}

}  // namespace tumble
