/// \file
/// \brief Support between bodies: components by Tarjan's search, levels by the longest way.
#include "tumble/contact/graph.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <string>

namespace tumble {
namespace {

constexpr int kUnvisited = -1;  // the search has not come here
constexpr int kOpen = -1;       // the body's component is not complete

}  // namespace

void support_edges(std::span<const Contact> contacts, const Vec3& gravity_w,
                   std::vector<SupportEdge>& edges) {
  require::finite(gravity_w, "gravity_w");
  // stableNormalized() gives 0 for 0: then no contact is against gravity.
  const Vec3 up_w = -gravity_w.stableNormalized();
  edges.clear();
  for (const Contact& contact : contacts) {
    const int direction = support_direction(contact.normal_w, up_w);
    if (direction > 0) edges.push_back({contact.first, contact.second});
    if (direction < 0) edges.push_back({contact.second, contact.first});
  }
}

void ContactGraph::build(std::span<const BodyProperties> bodies,
                         std::span<const SupportEdge> edges) {
  store_edges(bodies, edges);
  find_components();
  find_levels();
  sort_by_level();
}

std::span<const int> ContactGraph::bodies_of_level(int level) const {
  const auto begin = idx(level_start_[idx(level)]);
  return std::span<const int>(order_).subspan(begin, idx(level_start_[idx(level) + 1]) - begin);
}

// Groups the edges by supporter with a counting sort.
void ContactGraph::store_edges(std::span<const BodyProperties> bodies,
                               std::span<const SupportEdge> edges) {
  const int count = static_cast<int>(bodies.size());
  edge_start_.assign(bodies.size() + 1, 0);
  for (const SupportEdge& e : edges) {
    const bool good = e.supporter >= 0 && e.supporter < count && e.supported >= 0 &&
                      e.supported < count && e.supporter != e.supported;
    if (!good)  // the message costs more than the check
      refuse("edge " + std::to_string(e.supporter) + " -> " + std::to_string(e.supported) +
             ": give two different indices below " + std::to_string(count));
    if (bodies[idx(e.supported)].movable()) ++edge_start_[idx(e.supporter) + 1];
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) edge_start_[b + 1] += edge_start_[b];

  // Each start serves as the place of the next edge of its body; afterwards it has moved on to
  // the start of the next body, so that all of them move up by one place.
  head_.resize(idx(edge_start_[bodies.size()]));
  for (const SupportEdge& e : edges)
    if (bodies[idx(e.supported)].movable())
      head_[idx(edge_start_[idx(e.supporter)]++)] = e.supported;
  for (std::size_t b = bodies.size(); b > 0; --b) edge_start_[b] = edge_start_[b - 1];
  edge_start_[0] = 0;
}

void ContactGraph::find_components() {
  const std::size_t count = edge_start_.size() - 1;
  visit_.assign(count, kUnvisited);
  earliest_.assign(count, 0);
  next_edge_.assign(edge_start_.begin(), edge_start_.end() - 1);
  component_.assign(count, kOpen);
  finished_.clear();
  int visits = 0;
  for (std::size_t root = 0; root < count; ++root)
    if (visit_[root] == kUnvisited) search_from(static_cast<int>(root), visits);
}

// Tarjan's depth-first search, with its own stack of bodies in place of recursion: a tower of
// 100 000 boxes must not end the program.
void ContactGraph::search_from(int root, int& visits) {
  const auto enter = [&](int body) {
    visit_[idx(body)] = earliest_[idx(body)] = visits++;
    path_.push_back(body);
    open_.push_back(body);
  };
  enter(root);
  while (!path_.empty()) {
    const int body = path_.back();
    if (next_edge_[idx(body)] < edge_start_[idx(body) + 1]) {
      // One more edge to follow. Its end is new: go there first. Or it is open, so it has a way
      // back to here and both are in one component. Or it is complete and does not matter.
      const int head = head_[idx(next_edge_[idx(body)]++)];
      if (visit_[idx(head)] == kUnvisited) {
        enter(head);
      } else if (component_[idx(head)] == kOpen) {
        earliest_[idx(body)] = std::min(earliest_[idx(body)], visit_[idx(head)]);
      }
      continue;
    }
    // Nothing left to follow from here. If no way led back behind this body, it was the first of
    // its component, and the open bodies since then are the others.
    path_.pop_back();
    if (earliest_[idx(body)] == visit_[idx(body)]) {
      const auto begin = std::find(open_.rbegin(), open_.rend(), body).base() - 1;
      const int name = *std::min_element(begin, open_.end());
      for (auto member = begin; member != open_.end(); ++member) component_[idx(*member)] = name;
      finished_.insert(finished_.end(), begin, open_.end());
      open_.erase(begin, open_.end());
    }
    // The one that led here gets to know how far back there is a way.
    if (!path_.empty()) {
      int& earliest = earliest_[idx(path_.back())];
      earliest = std::min(earliest, earliest_[idx(body)]);
    }
  }
}

// The search finishes a component after all that it supports, hence backwards every component
// comes after all its supporters: when its turn comes its level is final.
void ContactGraph::find_levels() {
  level_.assign(component_.size(), 0);  // of a component, at the place of its name
  for (auto body = finished_.rbegin(); body != finished_.rend(); ++body) {
    const int lower = component_[idx(*body)];
    for (int e = edge_start_[idx(*body)]; e < edge_start_[idx(*body) + 1]; ++e) {
      const int upper = component_[idx(head_[idx(e)])];
      if (upper != lower) level_[idx(upper)] = std::max(level_[idx(upper)], level_[idx(lower)] + 1);
    }
  }
  for (std::size_t b = 0; b < level_.size(); ++b) level_[b] = level_[idx(component_[b])];
}

// A counting sort by level, which keeps the order of indices.
void ContactGraph::sort_by_level() {
  const int levels = level_.empty() ? 0 : 1 + *std::max_element(level_.begin(), level_.end());
  level_start_.assign(idx(levels) + 1, 0);
  for (const int level : level_) ++level_start_[idx(level) + 1];
  for (std::size_t k = 0; k < idx(levels); ++k) level_start_[k + 1] += level_start_[k];

  order_.resize(level_.size());
  for (std::size_t b = 0; b < level_.size(); ++b)
    order_[idx(level_start_[idx(level_[b])]++)] = static_cast<int>(b);
  for (std::size_t k = idx(levels); k > 0; --k) level_start_[k] = level_start_[k - 1];
  level_start_[0] = 0;
}

}  // namespace tumble
