/// \file
/// \brief Which pairs can meet within the coming step.
#pragma once

#include "tumble/geometry/broad_phase.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Looks for pairs of bodies that can meet within a step of free flight.
class NearPairs {
 public:
  // Makes the storage.
  NearPairs() : broad_phase_(make_broad_phase("bounding_tree")) {}

  // Finds the pairs whose ways through the step, as wide as half a diagonal, overlap.
  // dt: [s] the step
  std::span<const IndexPair> find(const World& world, double dt);

 private:
  std::unique_ptr<BroadPhase> broad_phase_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
};

}  // namespace tumble::chapters
