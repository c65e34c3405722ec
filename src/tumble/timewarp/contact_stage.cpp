/// \file
/// \brief Pairs that collide repeatedly in a frame and are deferred to its end.
#include "tumble/timewarp/contact_stage.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <string>

namespace tumble {
ContactStage::ContactStage(const ContactRule& rule) : rule_(rule) {
  require::positive(rule.resolution, "resolution");
  require::that(rule.pair_events >= 1,
                "pair_events = " + std::to_string(rule.pair_events) + ": expected 1 or more");
}

void ContactStage::begin() {
  records_.clear();
  entered_ = 0;
}

bool ContactStage::count(const IndexPair& pair, double separation_speed, double gravity) {
  Record& record = record_of(pair);
  ++record.events;
  // The time between bounces is 2 v / g.
  const bool at_once = 2.0 * separation_speed <= gravity * rule_.resolution;
  if (!at_once && record.events < rule_.pair_events) return false;
  defer(pair);
  return true;
}

void ContactStage::defer(const IndexPair& pair) {
  Record& record = record_of(pair);
  if (record.held) return;
  record.held = true;
  ++entered_;
}

bool ContactStage::holds(const IndexPair& pair) const {
  const auto before = [](const Record& record, const IndexPair& p) { return record.pair < p; };
  const auto place = std::lower_bound(records_.begin(), records_.end(), pair, before);
  return place != records_.end() && place->pair == pair && place->held;
}

void ContactStage::release(int body) {
  for (Record& record : records_) {
    const bool among = record.pair.first == body || record.pair.second == body;
    if (among && record.events < rule_.pair_events) record.held = false;
  }
}

void ContactStage::release_pushed(const World& world, std::span<const int> pushed,
                                  std::span<const MovingBody> before, double dt) {
  const double gained_by_gravity = world.gravity_w.norm() * dt;
  for (const int index : pushed) {
    const auto body = static_cast<std::size_t>(index);
    const MovingBody now = moving_body_of(world.bodies()[body], world.states()[body]);
    if (fastest_point_change(world.bodies()[body], before[body], now) > gained_by_gravity)
      release(index);
  }
}

std::span<const IndexPair> ContactStage::pairs() {
  held_.clear();
  for (const Record& record : records_)
    if (record.held) held_.push_back(record.pair);
  return held_;
}

ContactStage::Record& ContactStage::record_of(const IndexPair& pair) {
  const auto before = [](const Record& record, const IndexPair& p) { return record.pair < p; };
  const auto place = std::lower_bound(records_.begin(), records_.end(), pair, before);
  if (place != records_.end() && place->pair == pair) return *place;
  return *records_.insert(place, Record{pair});
}

}  // namespace tumble
