/// \file
/// \brief Common parts of all broad phases: the check of their input and the order of their output; and the one that tries
///        every pair.
#include "tumble/geometry/broad_phase.hpp"

#include "tumble/base/cloned.hpp"
#include "tumble/base/error.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/geometry/cell_trees.hpp"
#include "tumble/geometry/hashed_grid.hpp"
#include "tumble/geometry/sweep_and_prune.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace tumble {
namespace {

constexpr std::array<std::string_view, 6> kNames = {
    "all_pairs", "sweep_and_prune", "hashed_grid", "bounding_tree", "kd_tree", "octree"};

// Comparisons with NaN are false, so this refuses NaN as well.
bool sound(const Bounds& b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return (b.low.array() <= b.high.array()).all() && (b.low.array() < kInfinity).all() &&
         (b.high.array() > -kInfinity).all();
}

// Tests every pair of bounds, n (n - 1) / 2 of them: simplest, and the judge of the others.
class AllPairs final : public Cloned<BroadPhase, AllPairs> {
 public:
  [[nodiscard]] std::string_view name() const override { return kNames[0]; }

 private:
  void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) override {
    const int n = static_cast<int>(bounds.size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) test(bounds, a, b, out);
    }
  }
};

}  // namespace

void BroadPhase::find_pairs(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (sound(bounds[i])) continue;
    refuse("bounds[" + std::to_string(i) + "] from " + vector_text(bounds[i].low) + " to " +
           vector_text(bounds[i].high) + ": give low <= high in every coordinate, and no NaN");
  }
  pair_tests_ = 0;
  out.clear();
  search(bounds, out);
  if (!std::is_sorted(out.begin(), out.end())) std::sort(out.begin(), out.end());
}

std::unique_ptr<BroadPhase> make_broad_phase(std::string_view name) {
  if (name == kNames[0]) return std::make_unique<AllPairs>();
  if (name == kNames[1]) return std::make_unique<SweepAndPrune>();
  if (name == kNames[2]) return std::make_unique<HashedGrid>();
  if (name == kNames[3]) return std::make_unique<BoundingTree>();
  if (name == kNames[4]) return std::make_unique<KdTree>();
  if (name == kNames[5]) return std::make_unique<Octree>();
  std::string known;
  for (const std::string_view one : kNames) known.append(known.empty() ? "" : ", ").append(one);
  refuse("broad phase '" + std::string(name) + "': give one of " + known);
  return nullptr;
}

std::span<const std::string_view> broad_phase_names() { return kNames; }

}  // namespace tumble
