/// \file
/// \brief Which pairs can meet within the coming step.
#pragma once

#include "tumble/geometry/bounding_tree.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Looks for pairs of bodies that can meet within a step of free flight.
class NearPairs {
 public:
  // Finds the pairs whose ways through the step, as wide as half a diagonal, overlap.
  std::span<const IndexPair> find(const World& world, double dt) {
    bounds_.clear();
    for (std::size_t k = 0; k < world.bodies().size(); ++k) {
      const BodyProperties& body = world.bodies()[k];
      const BodyState& state = world.states()[k];
      if (!body.movable()) {
        bounds_.push_back(bounds_of(body, state));
        continue;
      }
      // A parabola stays within g t²/8 of its chord.
      const Vec3& start_w = state.position_w;
      const Vec3 end_w = start_w + dt * (velocity(body, state) + 0.5 * dt * world.gravity_w);
      const double wide = 0.5 * body.size.norm() + dt * dt / 8.0 * world.gravity_w.norm();
      bounds_.push_back({start_w.cwiseMin(end_w) - Vec3::Constant(wide),
                         start_w.cwiseMax(end_w) + Vec3::Constant(wide)});
    }
    broad_phase_.find_pairs(bounds_, pairs_);
    return pairs_;
  }

 private:
  BoundingTree broad_phase_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
};

}  // namespace tumble::chapters
