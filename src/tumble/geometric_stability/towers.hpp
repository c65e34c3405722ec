/// \file
/// \brief Boxes on boxes, seen as one heavier box (thesis 6.3.1, figure 6.4).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/contact.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// What was found about a body by Towers.
enum class TowerState : std::uint8_t {
  none,     ///< not part of a tower: rests on several bodies, or has contacts from the side
  carried,  ///< with what it carries, counts as a load on the body below
  tips  ///< rests on one body, and the centre of it and what it carries is not above the support
};

/// Weight that acts at one place.
struct TowerLoad {
  double mass = 0.0;           ///< [kg]
  Vec3 moment = Vec3::Zero();  ///< [kg m] mass times place, world frame

  /// The centre of mass.
  /// \pre there is a mass
  /// \return [m] world frame
  [[nodiscard]] Vec3 centre_w() const { return moment / mass; }
};

/// Stacks seen as one heavier block.
///
/// A body that rests on one other body only, with vertical normals, and carries nothing that is not
/// known yet, is in balance exactly if its weight and what it carries act above the hull of its
/// support. Then it acts on the body below as a load at that place, whichever way the forces spread
/// over the support. From the top down that decides whole towers, box by box, without a system of
/// equations; what is left is the part of a pile where a box rests on several others.
///
/// Exact for weights at rest without friction, and for these only: a push from the side, or a
/// base that accelerates, can take such a tower apart, as it takes apart any heap.
///
/// Supports must be vertical as exact_vertical() says. Without gravity along -y there are no
/// towers.
/// \par Cost and determinism
/// O(points of contact), each looked at twice. The result does not depend on any order.
/// \algorithm{A stack as one heavier block: section 6.3.1}
/// \verified{A tower stands as long as the centre of what is above is over each support}
class Towers {
 public:
  /// Finds towers.
  /// \param world     the bodies where they are
  /// \param contacts  what touches
  /// \param held      by index, not 0: stays where it is; nobody's load. May be empty
  void run(const World& world, std::span<const Contact> contacts, std::span<const char> held);

  /// What was found, by body index.
  /// \return one for each
  [[nodiscard]] std::span<const TowerState> states() const { return states_; }

  /// The body under a carried one, by body index.
  /// \return -1 for what is not carried
  [[nodiscard]] std::span<const int> carriers() const { return carriers_; }

  /// What a body weighs down with: itself and what is carried, by body index.
  /// \return one for each
  [[nodiscard]] std::span<const TowerLoad> loads() const { return loads_; }

 private:
  void count_neighbours(const World& world, std::span<const Contact> contacts,
                        std::span<const char> held);
  void settle(const World& world, std::span<const Contact> contacts, int body);

  std::vector<TowerState> states_;
  std::vector<int> carriers_;
  std::vector<TowerLoad> loads_;
  std::vector<int> below_;         // by body: the only body below; kNobody, kSeveral
  std::vector<int> above_;         // by body: how many contacts from above are not settled
  std::vector<char> no_tower_;     // by body: never part of one
  std::vector<int> contact_of_;    // by body: the places of contacts with the body below, chained
  std::vector<int> next_contact_;  // by contact: the next one of the same body
  std::vector<int> ready_;         // bodies with nothing unsettled above
  std::vector<Vec2> points_;
  std::vector<Vec2> hull_;
};

}  // namespace tumble
