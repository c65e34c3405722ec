/// \file
/// \brief The islands of a step, and the order of sweeps over their patches.
#include "tumble/contact_damped/island_order.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>

namespace tumble {

void IslandOrder::update(const World& world, std::span<const ContactPatch> patches,
                         std::span<const IndexPair> pairs) {
  new_ids_.clear();
  for (const ContactPatch& patch : patches) new_ids_.emplace_back(patch.first_id, patch.second_id);
  if (std::equal(pairs.begin(), pairs.end(), pairs_.begin(), pairs_.end()) && new_ids_ == ids_ &&
      body_count_ == world.count() && gravity_w_ == world.gravity_w)
    return;
  pairs_.assign(pairs.begin(), pairs.end());
  std::swap(ids_, new_ids_);
  body_count_ = world.count();
  gravity_w_ = world.gravity_w;
  build(world, patches);
}

void IslandOrder::build(const World& world, std::span<const ContactPatch> patches) {
  islands_.build_from_pairs(world.bodies(), pairs_);
  const double g = world.gravity_w.norm();
  edges_.clear();
  if (g > 0.0) {
    for (const ContactPatch& patch : patches) {
      const int direction = support_direction(patch.frame_w.col(2), -world.gravity_w / g);
      if (direction > 0) edges_.push_back({patch.first, patch.second});
      if (direction < 0) edges_.push_back({patch.second, patch.first});
    }
  }
  graph_.build(world.bodies(), edges_);
  order_.clear();
  start_.assign(1, 0);
  levels_.clear();
  const auto level = [&](int patch) {
    const IndexPair& pair = pairs_[idx(patch)];
    return std::max(graph_.level(pair.first), graph_.level(pair.second));
  };
  for (int island = 0; island < islands_.count(); ++island) {
    const std::span<const int> contacts = islands_.contacts(island);
    order_.insert(order_.end(), contacts.begin(), contacts.end());
    std::sort(order_.begin() + start_.back(), order_.end(),
              [&](int a, int b) { return level(a) != level(b) ? level(a) < level(b) : a < b; });
    start_.push_back(static_cast<int>(order_.size()));
    levels_.push_back(contacts.empty() ? 0 : level(order_.back()));
  }
}

std::span<const int> IslandOrder::upward(int island) const {
  const auto begin = idx(start_[idx(island)]);
  return std::span<const int>(order_).subspan(begin, idx(start_[idx(island) + 1]) - begin);
}

}  // namespace tumble
