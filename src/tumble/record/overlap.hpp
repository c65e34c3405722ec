/// \file
/// \brief Contacts and overlap of bodies, from poses alone.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Up to which distance two surfaces count as touching: tolerance::touching of the shortest edge of the
/// two. The ground has no size of its own.
/// \param b  the other, not the ground as well
/// \return [m]
double touching_distance(const BodyProperties& a, const BodyProperties& b);

/// Measures poses of any origin.
class OverlapMeter {
 public:
  /// Looks at all pairs of which one can move: the least translation over the 15 axes that parts two
  /// boxes, and the depth of the lowest corner under the ground.
  /// \param bodies  the constant parts
  /// \param states  their poses, finite, in the same order
  /// \return [m] the deepest penetration; 0 if no pair overlaps
  double look(std::span<const BodyProperties> bodies, std::span<const BodyState> states);

  /// The same for the pairs of a world that no joint joins.
  /// \param world  the bodies, their states finite
  double look(const World& world);

  /// How deep each body is in others [m], by index as of the last look: its deepest penetration, 0 or above.
  [[nodiscard]] std::span<const double> depths() const { return depths_; }

  /// Bodies that touch another one.
  /// \return by index as of the last look: 1 for those within touching_distance(), else 0
  [[nodiscard]] std::span<const char> in_contact() const { return in_contact_; }

 private:
  void find_pairs(std::span<const BodyProperties> bodies, std::span<const BodyState> states);
  double measure(std::span<const BodyProperties> bodies, std::span<const BodyState> states);

  BoundingTree broad_phase_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<char> in_contact_;
  std::vector<double> depths_;
};

}  // namespace tumble
