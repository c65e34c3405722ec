/// \file
/// \brief Groups of bodies that touch: disjoint sets, then two counting sorts.
#include "tumble/contact/islands.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <string>
#include <utility>

namespace tumble {
namespace {

// Sorts the numbers 0, 1, ... by the island of each into one list with a start for each island.
// Equal ones keep their order. Numbers of no island are left out.
void sort_by_island(std::span<const int> island, int islands, std::vector<int>& sorted,
                    std::vector<int>& start) {
  start.assign(idx(islands) + 1, 0);
  for (const int k : island)
    if (k != Islands::kNone) ++start[idx(k) + 1];
  for (std::size_t k = 0; k < idx(islands); ++k) start[k + 1] += start[k];

  sorted.resize(idx(start.back()));
  for (std::size_t i = 0; i < island.size(); ++i)
    if (island[i] != Islands::kNone) sorted[idx(start[idx(island[i])]++)] = static_cast<int>(i);
  // Each start has moved on to that of the next island.
  for (std::size_t k = idx(islands); k > 0; --k) start[k] = start[k - 1];
  start[0] = 0;
}

}  // namespace

void require_bodies(const IndexPair& contact, int count) {
  const auto in_range = [&](int body) { return body >= 0 && body < count; };
  if (in_range(contact.first) && in_range(contact.second)) return;
  refuse("contact of bodies " + std::to_string(contact.first) + " and " +
         std::to_string(contact.second) + ": give indices below " + std::to_string(count));
}

void Islands::build(std::span<const BodyProperties> bodies, std::span<const Contact> contacts,
                    std::span<const char> walls) {
  pairs_.clear();
  for (const Contact& contact : contacts) pairs_.push_back({contact.first, contact.second});
  build_from_pairs(bodies, pairs_, walls);
}

void Islands::build_from_pairs(std::span<const BodyProperties> bodies,
                               std::span<const IndexPair> contacts, std::span<const char> walls) {
  if (!walls.empty() && walls.size() != bodies.size())
    refuse("walls: " + std::to_string(walls.size()) + " entries for " +
           std::to_string(bodies.size()) + " bodies: give one each, or none");
  const auto movable = [&](std::size_t body) {
    return bodies[body].movable() && (walls.empty() || walls[body] == 0);
  };
  // Join the two sets of every contact under the smaller root: the root of an island is then its
  // smallest index, whatever the order of the contacts.
  parent_.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) parent_[b] = static_cast<int>(b);
  for (const IndexPair& contact : contacts) {
    require_bodies(contact, static_cast<int>(bodies.size()));
    if (!movable(idx(contact.first)) || !movable(idx(contact.second))) continue;
    int lower = root_of(contact.first);
    int upper = root_of(contact.second);
    if (lower > upper) std::swap(lower, upper);
    parent_[idx(upper)] = lower;
  }

  // Number the islands by their roots. A root has the smallest index of its island, so that it
  // gets its number before the others ask for it.
  int islands = 0;
  island_.assign(bodies.size(), kNone);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!movable(b)) continue;
    const int root = root_of(static_cast<int>(b));
    island_[b] = root == static_cast<int>(b) ? islands++ : island_[idx(root)];
  }
  contact_island_.clear();
  for (const IndexPair& contact : contacts) {
    const int first = island_[idx(contact.first)];
    contact_island_.push_back(first != kNone ? first : island_[idx(contact.second)]);
  }
  sort_by_island(island_, islands, bodies_, body_start_);
  sort_by_island(contact_island_, islands, contacts_, contact_start_);
}

// The smallest index known to be in the body's set. On the way every second body is moved up by
// one generation, which keeps later searches short.
int Islands::root_of(int body) {
  while (parent_[idx(body)] != body) {
    parent_[idx(body)] = parent_[idx(parent_[idx(body)])];
    body = parent_[idx(body)];
  }
  return body;
}

}  // namespace tumble
