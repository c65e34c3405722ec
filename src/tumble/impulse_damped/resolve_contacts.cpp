/// \file
/// \brief The listing RESOLVECONTACTS, and shock propagation.
#include "tumble/impulse_damped/damped_stage.hpp"

#include <algorithm>

namespace tumble {

void resolve_contacts(DampedStage& stage, int passes) {
  // [RESOLVECONTACTS:1-7]
  // As with collisions, but gravity is in the velocities too,
  // and the bodies do not bounce: they are slowed down more and
  // more, and in the last pass stopped.
  for (int pass = 1; pass <= passes; ++pass) {
    stage.predict_and_gather();
    const double restitution = -1.0 + static_cast<double>(pass) / passes;
    for (Contact& collision : stage.collisions)
      stage.run(collision, restitution, TemporaryGravity::velocity_plus_gravity);
    ++stage.report.iterations;
  }
  // [RESOLVECONTACTS:1-7]
}

void ShockPropagation::run(DampedStage& stage, int passes) {
  stage.predict_and_gather();
  support_edges(stage.collisions, stage.world.gravity_w, edges_);
  graph_.build(stage.world.bodies(), edges_);
  const auto upper_level = [&](const Contact& c) {
    return std::max(graph_.level(c.first), graph_.level(c.second));
  };
  std::vector<MovingBody>& moving = stage.bodies.moving;
  for (int level = 1; level < graph_.level_count(); ++level) {
    // What is below is as heavy as the ground.
    for (const int body : graph_.bodies_of_level(level - 1)) {
      moving[static_cast<std::size_t>(body)].inverse_mass.setZero();
      moving[static_cast<std::size_t>(body)].inverse_inertia_w.setZero();
    }
    for (int pass = 0; pass < passes; ++pass) {
      stage.predict_and_gather();
      for (Contact& collision : stage.collisions)
        if (upper_level(collision) == level)
          stage.run(collision, 0.0, TemporaryGravity::velocity_plus_gravity);
      ++stage.report.iterations;
    }
  }
  for (int body = 0; body < graph_.count(); ++body) stage.bodies.set_ease(stage.world, body);
}

}  // namespace tumble
