/// \file
/// \brief Groups of bodies that touch one another, directly or over others (thesis 4.5).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tumble {

/// Checks the bodies of a contact.
/// \throws std::invalid_argument for an index out of range
void require_bodies(const IndexPair& contact, int count);

/// Movable bodies that are connected through contacts.
///
/// An immovable body passes nothing on, so two heaps on one ground are two islands. Every movable
/// body is in exactly one island, by itself if it touches no other movable one; immovable bodies
/// are in none. Contacts with an immovable body belong to the movable one's island; a contact of two
/// immovable bodies belongs to none.
///
/// Islands are sorted by their smallest body index; bodies and contacts within one are ascending.
/// \par Cost and determinism
/// O((bodies + contacts) log bodies), in practice linear; no allocation once the storage is warm.
/// Which bodies form an island does not depend on the order of the contacts.
/// \see Tarjan, van Leeuwen, "Worst-case analysis of set union algorithms", J. ACM 1984.
class Islands {
 public:
  /// Finds the islands.
  /// \param bodies    the constant parts, for the immovable ones
  /// \param contacts  bodies that touch; only their indices `first` and `second` are read
  /// \param walls     by body index, not 0: counts as immovable. May be empty: no other body does
  /// \throws std::invalid_argument for an index out of range, or walls of another length
  void build(std::span<const BodyProperties> bodies, std::span<const Contact> contacts,
             std::span<const char> walls = {});

  /// Finds the islands from pairs of bodies that touch; their places count as those of contacts.
  /// \param pairs   indices of bodies that touch, each pair in either order
  /// \param walls   see build()
  /// \throws std::invalid_argument for an index out of range, or walls of another length
  void build_from_pairs(std::span<const BodyProperties> bodies, std::span<const IndexPair> pairs,
                        std::span<const char> walls = {});

  /// How many islands there are.
  [[nodiscard]] int count() const { return static_cast<int>(body_start_.size()) - 1; }

  /// The bodies of an island.
  /// \param island from 0, below count()
  /// \return at least one index, ascending
  [[nodiscard]] std::span<const int> bodies(int island) const {
    return part(bodies_, body_start_, island);
  }

  /// The contacts of an island: places in the list of contacts that build() got, ascending.
  [[nodiscard]] std::span<const int> contacts(int island) const {
    return part(contacts_, contact_start_, island);
  }

  /// The island of a body: from 0; kNone for an immovable body.
  [[nodiscard]] int island_of(int body) const { return island_[static_cast<std::size_t>(body)]; }

  /// No island.
  static constexpr int kNone = -1;

 private:
  int root_of(int body);
  static std::span<const int> part(std::span<const int> all, std::span<const int> start, int k) {
    const auto begin = static_cast<std::size_t>(start[static_cast<std::size_t>(k)]);
    const auto end = static_cast<std::size_t>(start[static_cast<std::size_t>(k) + 1]);
    return all.subspan(begin, end - begin);
  }

  std::vector<IndexPair> pairs_;  // of the contacts
  std::vector<int> parent_;       // towards a smaller index of the same island; a root is its own
  std::vector<int> island_;
  std::vector<int> contact_island_;
  std::vector<int> bodies_;
  std::vector<int> contacts_;
  std::vector<int> body_start_ = {0};     // island k has bodies_[body_start_[k]], ...
  std::vector<int> contact_start_ = {0};  // ditto
};

}  // namespace tumble
