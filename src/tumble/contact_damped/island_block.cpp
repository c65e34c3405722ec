/// \file
/// \brief The block of an island that sweeps leave unsolved.
#include "tumble/contact_damped/island_block.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace tumble {
namespace {

// [-] Bodies all of whose patches are solved together, at most. Reason: of 8, 10, 16 and 64 the one with which a heap of a thousand
// cubes with a tower comes to rest soonest; with 64 most solutions do not converge. (6.3.1)
constexpr std::size_t kMostBodies = 16;

// [-] Change of a patch by a sweep, as a share of g dt, from which on its bodies are among them. Reason: of 3e-4, 1e-3 and 3e-3
// the one with which ten heaps take least time. The change of bodies would not show one that is wedged: what its patches do to it
// cancels. (6.3.1)
constexpr double kLeastChange = 1e-3;

}  // namespace

std::span<double> IslandBlock::changes(const Island& island) {
  changes_.resize(island.all_patches.size());
  return changes_;
}

// Marks the bodies whose patches have changed most.
void IslandBlock::choose(const Island& island) {
  const double least = kLeastChange * unit_speed(island);
  most_.clear();
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const double by = changes_[idx(contact)];
    if (!(by > least)) continue;
    for (const int body : {patch.first, patch.second})
      if (island.world.bodies()[idx(body)].movable()) most_.emplace_back(by, body);
  }
  std::sort(most_.begin(), most_.end(), std::greater<>());
  chosen_.assign(island.now.size(), 0);
  std::size_t count = 0;
  for (const auto& [by, body] : most_) {
    if (chosen_[idx(body)] != 0) continue;
    if (++count > kMostBodies) break;
    chosen_[idx(body)] = 1;
  }
}

Island IslandBlock::find(const Island& island) {
  choose(island);
  const auto keep_chosen = [](std::span<const int> from, std::vector<int>& to,
                              const auto& is_chosen) {
    to.clear();
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), is_chosen);
    return std::span<const int>(to);
  };
  const auto of_chosen = [&](int contact) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    return chosen_[idx(patch.first)] != 0 || chosen_[idx(patch.second)] != 0;
  };
  Island block = island;
  block.patch_indices = keep_chosen(island.patch_indices, patches_, of_chosen);
  block.upward = keep_chosen(island.upward, upward_, of_chosen);
  // Its bodies, moved by all other patches.
  copy_bodies(block, island.now, free_);
  for (const int contact : block.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    Six back = impulse_of(patch);
    for (double& impulse : back) impulse = -impulse;
    apply(back, patch, free_[idx(patch.first)], free_[idx(patch.second)]);
    chosen_[idx(patch.first)] = chosen_[idx(patch.second)] = 1;
  }
  block.free = free_;
  block.bodies =
      keep_chosen(island.bodies, bodies_, [&](int body) { return chosen_[idx(body)] != 0; });
  return block;
}

}  // namespace tumble
