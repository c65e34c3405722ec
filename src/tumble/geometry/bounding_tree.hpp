/// \file
/// \brief The broad phase that keeps bodies in a tree of bounds (thesis 4.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/geometry/broad_phase.hpp"

namespace tumble {

/// A binary tree: the leaves are the bodies, and every node bounds all below it.
///
/// Leaves are a little wider than their bodies, so that a body which moves slowly stays in its leaf
/// for many steps; when it leaves, the leaf is taken out and inserted anew. A leaf is inserted
/// where it adds least surface to the tree: the chance that a box meets a node is about
/// proportional to the node's surface. On the way back up, a child and a grandchild change places
/// where that saves surface, which keeps the tree shallow.
///
/// Pairs of leaves that overlap are remembered: what overlaps can only be among them, and they change with
/// the leaves alone. A leaf that is new is tested against the tree. If most of them are, the tree is tested
/// against itself: of two nodes that overlap the larger one is replaced by its children. Sizes may be mixed at
/// will. Bodies that reach to infinity stay outside the tree and are tested against all others.
///
/// The tree depends on the past; the pairs do not.
///
/// \see Goldsmith, Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", IEEE Computer
///      Graphics and Applications 7(5), 1987, for the cost by surface.
/// \algorithm{Spatial subdivision: section 4.1}
/// \verified{All broad phases agree on thousands of random scenes}
class BoundingTree final : public Cloned<BroadPhase, BoundingTree> {
 public:
  [[nodiscard]] std::string_view name() const override { return "bounding_tree"; }

 private:
  static constexpr int kNone = -1;

  // A leaf has a body and no children, an inner node two children and no body.
  struct Node {
    Bounds bounds;
    int parent = kNone;
    int left = kNone;
    int right = kNone;
    int body = kNone;
  };
  // Two nodes still to be tested against each other; twice the same: its children are.
  struct NodePair {
    int a = kNone;
    int b = kNone;
  };

  void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) override;
  void update(std::span<const Bounds> bounds);
  void pair_leaves();
  void pair_all_leaves();
  void pair_new_leaf(int body);
  void remember(int a, int b);

  void insert_leaf(int leaf);
  void remove(int leaf);
  [[nodiscard]] int best_sibling(const Bounds& bounds) const;
  void refit_upwards(int node);
  void improve(int node);
  void replace_child(int parent, int old_child, int new_child);
  int new_node();
  [[nodiscard]] Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] const Node& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] bool is_leaf(int node) const { return at(node).left == kNone; }

  std::vector<Node> nodes_;  // in no order
  std::vector<int> free_;    // nodes not in use
  std::vector<int> leaf_;    // of every body; kNone: outside the tree
  std::vector<int> outside_;
  std::vector<IndexPair> near_;  // bodies whose leaves overlap, sorted
  std::vector<char> changed_;    // of every body: its leaf is new, or gone, since near_ was found
  std::vector<int> new_leaves_;  // the bodies whose leaf is new
  std::vector<NodePair> stack_;
  int root_ = kNone;
};

}  // namespace tumble
