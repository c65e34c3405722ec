/// \file
/// \brief Pairs that collide again and again are left to the end of the frame.
#include "tumble/timewarp/contact_stage.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/flight.hpp"

#include <algorithm>
#include <string>

namespace tumble {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

ContactStage::ContactStage(const ContactRule& rule) : rule_(rule) {
  require::positive(rule.resolution, "resolution");
  require::that(rule.pair_events >= 1,
                "pair_events = " + std::to_string(rule.pair_events) + ": expected 1 or more");
}

void ContactStage::begin() {
  records_.clear();
  entered_ = 0;
}

bool ContactStage::count(const IndexPair& pair, double parting, double gravity) {
  Record& record = record_of(pair);
  ++record.events;
  // A hop takes 2 v / g.
  const bool at_once = 2.0 * parting <= gravity * rule_.resolution;
  if (!at_once && record.events < rule_.pair_events) return false;
  leave(pair);
  return true;
}

void ContactStage::leave(const IndexPair& pair) {
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

std::span<const IndexPair> RestingPairs::find(const World& world, std::span<const IndexPair> held,
                                              std::span<const IndexPair> candidates, double reach,
                                              StepReport& report) {
  const auto movable = [&](int body) { return world.bodies()[at(body)].movable(); };
  const auto join = [&](const IndexPair& pair) {
    for (const int body : {pair.first, pair.second}) joined_[at(body)] = movable(body) ? 1 : 0;
  };
  joined_.assign(at(world.count()), 0);
  pairs_.assign(held.begin(), held.end());
  for (const IndexPair& pair : pairs_) join(pair);

  touching_.clear();
  for (const IndexPair& pair : candidates) {
    if (!movable(pair.first) && !movable(pair.second)) continue;
    ++report.pair_tests;
    const Separation gap =
        gap_between(world.bodies()[at(pair.first)], world.states()[at(pair.first)],
                    world.bodies()[at(pair.second)], world.states()[at(pair.second)]);
    if (gap.distance <= reach) touching_.push_back(pair);
  }
  const auto joins = [&](const IndexPair& pair) {
    if (joined_[at(pair.first)] == 0 && joined_[at(pair.second)] == 0) return false;
    join(pair);
    pairs_.push_back(pair);
    return true;
  };
  while (std::erase_if(touching_, joins) > 0) continue;
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  return pairs_;
}

std::int64_t join_touching(const World& world, std::span<const IndexPair> candidates, double reach,
                           std::vector<IndexPair>& pairs) {
  RestingPairs resting;
  StepReport report;
  const std::span<const IndexPair> all = resting.find(world, pairs, candidates, reach, report);
  pairs.assign(all.begin(), all.end());
  return report.pair_tests;
}

}  // namespace tumble
