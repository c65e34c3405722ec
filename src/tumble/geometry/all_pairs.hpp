/// \file
/// \brief The broad phase that tries every pair: simplest, and the judge of the others.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/geometry/broad_phase.hpp"

namespace tumble {

/// Tests every pair of bounds: n (n - 1) / 2 tests, no memory.
class AllPairs final : public Cloned<BroadPhase, AllPairs> {
 public:
  [[nodiscard]] std::string_view name() const override { return "all_pairs"; }

 private:
  void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) override;
};

}  // namespace tumble
