/// \file
/// \brief Support between bodies: the order in which they are held up (thesis 4.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/tolerances.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tumble {

/// One body holds up another one.
struct SupportEdge {
  int supporter = 0;  ///< index of the body below
  int supported = 0;  ///< index of the body that rests on it
};

/// Which body holds up which, by the direction of a contact's normal.
///
/// A contact pushes its second body along the normal. If that push points upwards (against
/// gravity), the second body rests on the first; if it points downwards, the other way round. A
/// contact whose normal is within tolerance::side_contact of the horizontal holds nothing up and
/// gives no edge: books that stand side by side are not in each other's order, and a box that
/// friction holds between two walls rests on nothing. Without gravity there is no up and no edge.
/// \param edges      out: at most one edge for each contact, in the order of the contacts; what
///                   was in it is discarded
/// \throws std::invalid_argument if gravity is not finite
/// \see Guendelman, Bridson, Fedkiw, "Nonconvex rigid bodies with stacking", 2003, section 8.1.
///      They move each body alone for one step and see on which it falls; that costs a search for
///      contacts for each body, and differs where a body slides off another one.
void support_edges(std::span<const Contact> contacts, const Vec3& gravity_w,
                   std::vector<SupportEdge>& edges);

/// The direction of a single contact in the sense of support_edges().
/// \param normal_w  [-] from the first body to the second, length 1, world frame
/// \param up_w      [-] against gravity, length 1, or 0 without gravity; world frame
/// \return 1: the first holds up the second; -1: the second holds up the first; 0: neither
[[nodiscard]] inline int support_direction(const Vec3& normal_w, const Vec3& up_w) {
  const double rise = normal_w.dot(up_w);
  if (rise > tolerance::side_contact) return 1;
  return rise < -tolerance::side_contact ? -1 : 0;
}

/// All bodies in an order in which supporters come before what they support.
///
/// Bodies that hold each other up in a ring (three planks, each with an end on the next one) have
/// no such order; they form one *component* and share a level. The *level* of a body is the number
/// of edges on the longest way up to its component: immovable bodies have level 0, what stands on
/// them level 1, and so on. Any edge between two components leads to a strictly higher level.
///
/// Nothing holds up an immovable body: edges that lead to one are ignored. A component that
/// nothing holds up has level 0, also if it is movable: a falling heap starts counting at its own
/// lowest members.
///
/// The height of contact points or centres is not used. It is no support order: a high plank can
/// carry a small box on its low end.
/// \par Cost and determinism
/// O(bodies + edges), no recursion, and no allocation once the storage is warm. The result depends
/// on the set of edges only, not on their order; double edges do not count twice.
/// \see Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1972.
class ContactGraph {
 public:
  /// Finds components and levels.
  /// \param bodies  the constant parts: which are immovable
  /// \throws std::invalid_argument for an edge with an index out of range or from a body to itself
  void build(std::span<const BodyProperties> bodies, std::span<const SupportEdge> edges);

  /// How many bodies it was built for.
  [[nodiscard]] int count() const { return static_cast<int>(order_.size()); }

  /// How high up a body is.
  [[nodiscard]] int level(int body) const { return level_[static_cast<std::size_t>(body)]; }

  /// The ring of mutual support that a body belongs to, named by its member of smallest index.
  /// \return an index; its own for a body in no ring
  [[nodiscard]] int component(int body) const { return component_[static_cast<std::size_t>(body)]; }

  /// How many levels there are: one more than the highest level; 0 if there are no bodies.
  [[nodiscard]] int level_count() const { return static_cast<int>(level_start_.size()) - 1; }

  /// All bodies from the ground up: indices, ascending by level, those of one level ascending by index.
  [[nodiscard]] std::span<const int> order() const { return order_; }

  /// The bodies of one level.
  /// \param level from 0, below level_count()
  /// \return indices, ascending
  [[nodiscard]] std::span<const int> bodies_of_level(int level) const;

 private:
  void store_edges(std::span<const BodyProperties> bodies, std::span<const SupportEdge> edges);
  void find_components();
  void search_from(int root, int& visits);
  void find_levels();
  void sort_by_level();

  /// The edges that leave body b lead to head_[edge_start_[b]], ... up to edge_start_[b + 1].
  std::vector<int> edge_start_;
  std::vector<int> head_;

  std::vector<int> visit_;      // when the search came to a body, from 0; kUnvisited before
  std::vector<int> earliest_;   // smallest visit number known to be in the body's component
  std::vector<int> next_edge_;  // where the search goes on when it comes back to a body
  std::vector<int> path_;       // bodies between the root of the search and where it is
  std::vector<int> open_;       // bodies visited whose component is not complete
  std::vector<int> finished_;   // bodies of complete components, those on top first

  std::vector<int> component_;
  std::vector<int> level_;
  std::vector<int> order_;
  std::vector<int> level_start_ = {0};  // level k is order_[level_start_[k]], ...
};

}  // namespace tumble
