/// \file
/// \brief One pass of a stage: predict, gather, collide, keep book.
#include "tumble/impulse_damped/damped_stage.hpp"

#include <algorithm>

namespace tumble {

void DampedStage::predict_and_gather() {
  report.integrations += bodies.predict(world, dt, rotation);
  const PairReport found =
      gatherer.gather(world, world.states(), bodies.predicted, sleeping, 0.0, collisions);
  bodies.clear_tilted(world, collisions);
  // A stable body yields sideways only. Along a normal that leans by a hair that would take an
  // impulse without bounds, so what counts as along the y axis is made so.
  for (Contact& contact : collisions)
    if (bodies.holds_firm(world, contact))
      contact.normal_w = Vec3(0.0, contact.normal_w.y() > 0.0 ? 1.0 : -1.0, 0.0);
  report.pair_tests += found.pair_tests;
}

void DampedStage::run(Contact& collision, double restitution, TemporaryGravity gravity) {
  const CollideResult result = collide.run(world, collision, restitution, gravity, dt, bodies);
  report.energy.restitution += result.restitution;
  report.pivots += result.pivots;
  if (!result.pushed) return;
  ++report.impulses;

  // The pair as it is now, with the impulses of the whole step at its first point.
  const auto before = [](const Contact& a, const Contact& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  const auto place = std::lower_bound(pushed_pairs.begin(), pushed_pairs.end(), collision, before);
  if (place == pushed_pairs.end() || before(collision, *place)) {
    pushed_pairs.insert(place, collision);
    return;
  }
  double sum = 0.0;
  for (int p = 0; p < place->count; ++p)
    sum += place->points[static_cast<std::size_t>(p)].normal_impulse;
  *place = collision;
  place->points[0].normal_impulse += sum;
}

}  // namespace tumble
