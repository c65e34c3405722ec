/// \file
/// \brief The end of a timewarp's frame: resting contacts and repair of overlap (thesis A.1:
///        fixInterpenetration).
#include "tumble/timewarp/frame_end.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/dynamics/flight.hpp"

#include <algorithm>

namespace tumble {

void FrameEnd::settle(World& world, double dt, double resolution, std::span<const IndexPair> held,
                      StepReport& report, std::vector<ContactRecord>& records) {
  const double reach = world.gravity_w.norm() * dt * resolution;
  repair_bounds(world, reach, bounds_);
  broad_phase_.find_pairs(bounds_, candidates_);
  if (!held.empty()) {
    resting_.assign(held.begin(), held.end());
    join_touching(world, reach, report);
    const InstantReport impact = impacts_.resolve(
        world, resting_, {.resolution = resolution, .bounce = false, .dt = dt, .margin = reach},
        report);
    add_records(impact.contacts, world.time() + dt, records);
  }
  book(repair_.run(world, candidates_), report);
}

// Adds the pairs in contact that are connected to the resting ones through movable bodies.
void FrameEnd::join_touching(const World& world, double reach, StepReport& report) {
  const auto movable = [&](int body) { return world.bodies()[idx(body)].movable(); };
  const auto join = [&](const IndexPair& pair) {
    for (const int body : {pair.first, pair.second}) joined_[idx(body)] = movable(body) ? 1 : 0;
  };
  joined_.assign(idx(world.count()), 0);
  for (const IndexPair& pair : resting_) join(pair);

  touching_.clear();
  for (const IndexPair& pair : candidates_) {
    if (!movable(pair.first) && !movable(pair.second)) continue;
    ++report.pair_tests;
    const Separation gap =
        gap_between(world.bodies()[idx(pair.first)], world.states()[idx(pair.first)],
                    world.bodies()[idx(pair.second)], world.states()[idx(pair.second)]);
    if (gap.distance <= reach) touching_.push_back(pair);
  }
  const auto joins = [&](const IndexPair& pair) {
    if (joined_[idx(pair.first)] == 0 && joined_[idx(pair.second)] == 0) return false;
    join(pair);
    resting_.push_back(pair);
    return true;
  };
  while (std::erase_if(touching_, joins) > 0) continue;
  std::sort(resting_.begin(), resting_.end());
  resting_.erase(std::unique(resting_.begin(), resting_.end()), resting_.end());
}

}  // namespace tumble
