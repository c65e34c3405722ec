/// \file
/// \brief A tree of bounds.
#include "tumble/geometry/bounding_tree.hpp"

#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tumble {
namespace {

Bounds both(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

// Half the surface: the cost of a node.
double surface(const Bounds& b) {
  const Vec3 e = b.high - b.low;
  return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

bool contains(const Bounds& outer, const Bounds& inner) {
  return (outer.low.array() <= inner.low.array()).all() &&
         (outer.high.array() >= inner.high.array()).all();
}

// Wider on all sides by a part of the mean extent.
Bounds widened(const Bounds& b, double part) {
  const Vec3 margin = Vec3::Constant(part / 3.0 * (b.high - b.low).sum());
  return {b.low - margin, b.high + margin};
}

}  // namespace

void BoundingTree::search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) {
  update(bounds);
  pair_leaves();
  // Bodies outside the tree against all; of two of them the one with the lower index tests.
  const int n = static_cast<int>(bounds.size());
  for (const int a : outside_) {
    for (int b = 0; b < n; ++b) {
      const bool done_by_other = leaf_[static_cast<std::size_t>(b)] == kNone && b <= a;
      if (!done_by_other) test(bounds, a, b, out);
    }
  }
  // After the ground, which is the first body of most worlds: then nothing is left to sort.
  for (const IndexPair& pair : near_) test(bounds, pair.first, pair.second, out);
}

void BoundingTree::update(std::span<const Bounds> bounds) {
  // Leaves of bodies that are gone. If a body in the middle was removed, later bodies have moved to
  // lower indices; to the tree that looks as if they had jumped.
  changed_.assign(std::max(bounds.size(), leaf_.size()), 0);
  for (std::size_t body = bounds.size(); body < leaf_.size(); ++body) {
    changed_[body] = 1;
    if (leaf_[body] != kNone) remove(leaf_[body]);
  }
  leaf_.resize(bounds.size(), kNone);
  nodes_.reserve(2 * bounds.size());
  free_.reserve(2 * bounds.size());

  outside_.clear();
  new_leaves_.clear();
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    int& leaf = leaf_[body];
    const Bounds& now = bounds[body];
    const Bounds wide = widened(now, tolerance::tree_slack);
    const bool finite = wide.low.allFinite() && wide.high.allFinite();
    if (finite && leaf != kNone && contains(at(leaf).bounds, now) &&
        contains(wide, at(leaf).bounds)) {
      continue;
    }
    changed_[body] = 1;
    if (leaf != kNone) remove(std::exchange(leaf, kNone));
    if (!finite) {
      outside_.push_back(static_cast<int>(body));
      continue;
    }
    leaf = new_node();
    at(leaf).bounds = widened(now, tolerance::tree_margin);
    at(leaf).body = static_cast<int>(body);
    insert_leaf(leaf);
    new_leaves_.push_back(static_cast<int>(body));
  }
}

void BoundingTree::pair_leaves() {
  // Pairs of leaves that stayed are still right; the others are found anew.
  std::erase_if(near_, [&](const IndexPair& pair) {
    return changed_[static_cast<std::size_t>(pair.first)] != 0 ||
           changed_[static_cast<std::size_t>(pair.second)] != 0;
  });
  if (new_leaves_.empty()) return;
  // On the way down the stack grows by two for each level at which a node meets itself and by one
  // for each level of both nodes below: by four times the number of leaves at most.
  stack_.reserve(4 * leaf_.size() + 4);
  if (2 * new_leaves_.size() > leaf_.size()) {
    near_.clear();
    pair_all_leaves();
  } else {
    for (const int body : new_leaves_) pair_new_leaf(body);
  }
  std::sort(near_.begin(), near_.end());
}

void BoundingTree::pair_all_leaves() {
  stack_.assign(1, {root_, root_});
  while (!stack_.empty()) {
    const NodePair pair = stack_.back();
    stack_.pop_back();
    if (pair.a == pair.b) {
      // What is below one node: below its left child, below its right child, between the two.
      if (is_leaf(pair.a)) continue;
      const Node& node = at(pair.a);
      stack_.push_back({node.left, node.left});
      stack_.push_back({node.right, node.right});
      stack_.push_back({node.left, node.right});
      continue;
    }
    count_test();
    if (!overlap(at(pair.a).bounds, at(pair.b).bounds)) continue;
    if (is_leaf(pair.a) && is_leaf(pair.b)) {
      remember(at(pair.a).body, at(pair.b).body);
      continue;
    }
    // Descend into the larger one; leaves cannot be descended into.
    const bool into_a = is_leaf(pair.b) || (!is_leaf(pair.a) && surface(at(pair.a).bounds) >=
                                                                    surface(at(pair.b).bounds));
    const Node& node = at(into_a ? pair.a : pair.b);
    const int other = into_a ? pair.b : pair.a;
    stack_.push_back({node.left, other});
    stack_.push_back({node.right, other});
  }
}

void BoundingTree::pair_new_leaf(int body) {
  const int leaf = leaf_[static_cast<std::size_t>(body)];
  stack_.assign(1, {root_, leaf});
  while (!stack_.empty()) {
    const int node = stack_.back().a;
    stack_.pop_back();
    if (node == leaf) continue;
    count_test();
    if (!overlap(at(node).bounds, at(leaf).bounds)) continue;
    if (!is_leaf(node)) {
      stack_.push_back({at(node).left, leaf});
      stack_.push_back({at(node).right, leaf});
      continue;
    }
    // Two new leaves meet twice; the pair is that of the lower one.
    const int other = at(node).body;
    if (changed_[static_cast<std::size_t>(other)] == 0 || body < other) remember(body, other);
  }
}

void BoundingTree::remember(int a, int b) {
  near_.push_back(a < b ? IndexPair{a, b} : IndexPair{b, a});
}

void BoundingTree::insert_leaf(int leaf) {
  if (root_ == kNone) {
    root_ = leaf;
    at(leaf).parent = kNone;
    return;
  }
  // A new inner node takes the place of the sibling and holds both.
  const int sibling = best_sibling(at(leaf).bounds);
  const int parent = new_node();
  replace_child(at(sibling).parent, sibling, parent);
  at(parent).left = sibling;
  at(parent).right = leaf;
  at(sibling).parent = parent;
  at(leaf).parent = parent;
  refit_upwards(parent);
}

int BoundingTree::best_sibling(const Bounds& bounds) const {
  // Go down where it is cheapest. Stopping at a node costs the surface of a new node around it and
  // the leaf. Going on costs what this node grows by, and then the same for the child: the whole
  // new node if the child is a leaf, at least what the child grows by if it is not.
  int node = root_;
  while (!is_leaf(node)) {
    const double around = surface(both(at(node).bounds, bounds));
    const double growth = around - surface(at(node).bounds);
    const auto cost_of = [&](int child) {
      const double around_child = surface(both(at(child).bounds, bounds));
      return growth + around_child - (is_leaf(child) ? 0.0 : surface(at(child).bounds));
    };
    const double left = cost_of(at(node).left);
    const double right = cost_of(at(node).right);
    if (around < left && around < right) break;
    node = left <= right ? at(node).left : at(node).right;
  }
  return node;
}

void BoundingTree::remove(int leaf) {
  // The sibling takes the place of the parent.
  const int parent = at(leaf).parent;
  free_.push_back(leaf);
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  const int sibling = at(parent).left == leaf ? at(parent).right : at(parent).left;
  replace_child(at(parent).parent, parent, sibling);
  free_.push_back(parent);
  refit_upwards(at(sibling).parent);
}

void BoundingTree::refit_upwards(int node) {
  for (; node != kNone; node = at(node).parent) {
    at(node).bounds = both(at(at(node).left).bounds, at(at(node).right).bounds);
    improve(node);
  }
}

void BoundingTree::improve(int node) {
  // Swaps one child of the node with a child of the other one, if that makes the other one smaller:
  // the best of four ways, the first of equal ones. The bounds of the node itself stay.
  const std::array<int, 2> children = {at(node).left, at(node).right};
  double most_saved = 0.0;
  int moved_down = kNone, moved_up = kNone;
  for (std::size_t k = 0; k < 2; ++k) {
    const int child = children[k];
    const int other = children[1 - k];
    if (is_leaf(other)) continue;
    // The child goes below the other one in exchange for a grandchild.
    for (const bool left : {true, false}) {
      const int up = left ? at(other).left : at(other).right;
      const int stays = left ? at(other).right : at(other).left;
      const double saved =
          surface(at(other).bounds) - surface(both(at(child).bounds, at(stays).bounds));
      if (!(saved > most_saved)) continue;
      most_saved = saved;
      moved_down = child;
      moved_up = up;
    }
  }
  if (moved_up == kNone) return;
  const int other = at(moved_up).parent;
  replace_child(node, moved_down, moved_up);
  replace_child(other, moved_up, moved_down);
  at(other).bounds = both(at(at(other).left).bounds, at(at(other).right).bounds);
}

void BoundingTree::replace_child(int parent, int old_child, int new_child) {
  at(new_child).parent = parent;
  if (parent == kNone) {
    root_ = new_child;
  } else if (at(parent).left == old_child) {
    at(parent).left = new_child;
  } else {
    at(parent).right = new_child;
  }
}

int BoundingTree::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<int>(nodes_.size()) - 1;
  }
  const int node = free_.back();
  free_.pop_back();
  at(node) = Node{};
  return node;
}

}  // namespace tumble
