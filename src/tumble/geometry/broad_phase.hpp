/// \file
/// \brief Which bodies are near each other: the broad phase of collision detection (thesis 4.1).
#pragma once

#include "tumble/geometry/box.hpp"

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// Two bodies, by their place in an array.
struct IndexPair {
  int first = 0;   ///< the smaller index
  int second = 0;  ///< the larger one

  /// Orders pairs by the first index, then by the second.
  auto operator<=>(const IndexPair&) const = default;
};

/// A way to find all pairs of bounds that overlap without trying every pair.
///
/// The thesis names such methods and does without; its scenes are small. All methods here give the
/// same list, in the same order, for the same bounds, so that a technique may use any of them
/// without changing a bit of its result. What they remember from call to call saves work and
/// nothing else.
///
/// Bounds may reach to infinity, as those of the ground do.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  /// The name that a user calls it by, for example "sweep_and_prune".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Finds all pairs of bounds that overlap; touching counts.
  /// \param out     cleared and filled with every pair once, first < second, sorted by < of pairs
  /// \throws std::invalid_argument for bounds with a NaN, with low above high, or lying entirely
  ///         at infinity
  /// \note Does not allocate when the number of bodies and of pairs is not above that of earlier
  ///       calls.
  void find_pairs(std::span<const Bounds> bounds, std::vector<IndexPair>& out);

  /// The work of the last call: how often two bounds were tested for overlap. Depends on what was remembered.
  [[nodiscard]] std::int64_t pair_tests() const { return pair_tests_; }

  /// A copy with all memory: works exactly like this one from here on.
  [[nodiscard]] virtual std::unique_ptr<BroadPhase> clone() const = 0;

 protected:
  BroadPhase() = default;
  /// Copies the memory, for clone().
  BroadPhase(const BroadPhase& other) = default;
  /// Copies the memory, for clone().
  BroadPhase& operator=(const BroadPhase& other) = default;

  /// Finds the pairs in any order; called with bounds that have been checked.
  /// \param out     empty; to be filled with every pair once, by report()
  virtual void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) = 0;

  /// Tests two bodies, counts that, and adds them if they overlap.
  void test(std::span<const Bounds> bounds, int a, int b, std::vector<IndexPair>& out) {
    ++pair_tests_;
    if (overlap(bounds[static_cast<std::size_t>(a)], bounds[static_cast<std::size_t>(b)]))
      out.push_back(a < b ? IndexPair{a, b} : IndexPair{b, a});
  }

  /// Counts a test of two bounds that are not both bodies'.
  void count_test() { ++pair_tests_; }

 private:
  std::int64_t pair_tests_ = 0;
};

/// Makes a broad phase by name.
/// \param name  "all_pairs", "sweep_and_prune", "hashed_grid", "bounding_tree", "kd_tree" or "octree"
/// \throws std::invalid_argument for another name, listing these
[[nodiscard]] std::unique_ptr<BroadPhase> make_broad_phase(std::string_view name);

/// The names that make_broad_phase() knows, simplest first.
[[nodiscard]] std::span<const std::string_view> broad_phase_names();

}  // namespace tumble
