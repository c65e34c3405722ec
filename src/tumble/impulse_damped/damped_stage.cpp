/// \file
/// \brief One pass of a stage: predict, gather, collide, keep book.
#include "tumble/impulse_damped/damped_stage.hpp"

#include <algorithm>

namespace tumble {

void PushedPairs::clear() {
  order_.clear();
  contacts_.clear();
}

void PushedPairs::add(const Contact& collision) {
  const auto place = std::lower_bound(
      order_.begin(), order_.end(), collision, [](const Place& a, const Contact& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
      });
  if (place == order_.end() || place->first != collision.first ||
      place->second != collision.second) {
    order_.insert(place, {collision.first, collision.second, contacts_.size()});
    contacts_.push_back(collision);
    return;
  }
  Contact& pair = contacts_[place->contact];
  double sum = 0.0;
  for (int p = 0; p < pair.count; ++p)
    sum += pair.points[static_cast<std::size_t>(p)].normal_impulse;
  pair.normal_w = collision.normal_w;
  pair.axis = collision.axis;
  pair.count = collision.count;
  std::copy_n(collision.points.begin(), collision.count, pair.points.begin());
  pair.points[0].normal_impulse += sum;
}

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

  pushed_pairs.add(collision);
}

}  // namespace tumble
