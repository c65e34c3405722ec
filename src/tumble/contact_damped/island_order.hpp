/// \file
/// \brief The islands of a step, and the order of sweeps over their patches (thesis 4.5, 6.3.1).
#pragma once

#include "tumble/contact/graph.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/contact_patches/contact_patch.hpp"
#include "tumble/dynamics/world.hpp"

#include <span>
#include <utility>
#include <vector>

namespace tumble {

/// Islands of bodies that touch, each with its patches in the order from the ground up: by the level of the
/// higher one of a patch's two bodies (ContactGraph).
///
/// Kept while the same bodies touch: normals that turn meanwhile do not change the order.
class IslandOrder {
 public:
  /// Finds islands and order, if the pairs, the number of bodies or gravity have changed.
  void update(const World& world, std::span<const ContactPatch> patches,
              std::span<const IndexPair> pairs);

  /// The islands; their "contacts" are places of patches.
  [[nodiscard]] const Islands& islands() const { return islands_; }

  /// The places of an island's patches, from the ground up.
  [[nodiscard]] std::span<const int> upward(int island) const;

  /// How high an island is: the highest level of a body in it, the ground's being 0.
  [[nodiscard]] int levels(int island) const { return levels_[static_cast<std::size_t>(island)]; }

 private:
  void build(const World& world, std::span<const ContactPatch> patches);

  Islands islands_;
  ContactGraph graph_;
  std::vector<SupportEdge> edges_;
  std::vector<int> order_;   // places of patches, island by island
  std::vector<int> start_;   // of an island in order_
  std::vector<int> levels_;  // by island
  // What they were found for.
  int body_count_ = -1;
  Vec3 gravity_w_ = Vec3::Zero();
  std::vector<IndexPair> pairs_;
  std::vector<std::pair<BodyId, BodyId>> ids_;
  std::vector<std::pair<BodyId, BodyId>> new_ids_;  // storage of update()
};

}  // namespace tumble
