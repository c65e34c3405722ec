/// \file
/// \brief Towers of boxes, each treated as one heavier box (thesis 6.3.1, figure 6.4).
#pragma once

#include "tumble/contact/contact.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// State of a body in Towers.
enum class TowerState : std::uint8_t {
  none,       ///< not part of a tower: rests on several bodies, or has side contacts
  supported,  ///< in equilibrium on one body; with all above it, a load on that body
  tips        ///< rests on one body, but the common centre of mass is not above the support
};

/// Weight that acts at one point.
struct TowerLoad {
  double mass = 0.0;           ///< [kg]
  Vec3 moment = Vec3::Zero();  ///< [kg m] mass times position, world frame

  /// The centre of mass.
  /// \pre mass > 0
  /// \return [m] world frame
  [[nodiscard]] Vec3 centre_w() const { return moment / mass; }
};

/// Stacks treated as one heavier block.
///
/// A body that rests on only one other body, with vertical normals, and whose load is known, is in
/// equilibrium exactly if the centre of its weight and its load is above the hull of its support. It
/// then acts on the body below as a load at that centre, however the forces are distributed over the
/// support. From the top down that decides whole towers, box by box, without a system of equations;
/// the rest of a pile is where a box rests on several others.
///
/// Exact for weights at rest without friction only: a push from the side, or an accelerating base, can
/// overturn such a tower like any stack.
///
/// Supports must be vertical to exact_vertical(). Without gravity along -y there are no towers.
/// \par Cost and determinism
/// O(points of contact), each visited twice. The result does not depend on any order.
/// \algorithm{A stack as one heavier block: section 6.3.1}
/// \verified{A tower stands as long as the centre of the load is above each support}
class Towers {
 public:
  /// Finds towers.
  /// \param held      by index, not 0: treated as immovable and never a load. May be empty
  void run(const World& world, std::span<const Contact> contacts, std::span<const char> held);

  /// State of each body, by index.
  [[nodiscard]] std::span<const TowerState> states() const { return states_; }

  /// The body below a supported one, by index; -1 for other bodies.
  [[nodiscard]] std::span<const int> supports() const { return supports_; }

  /// Load of a body on its support, by index: itself and all above it.
  [[nodiscard]] std::span<const TowerLoad> loads() const { return loads_; }

 private:
  void count_neighbours(const World& world, std::span<const Contact> contacts,
                        std::span<const char> held);
  void settle(const World& world, std::span<const Contact> contacts, int body);

  std::vector<TowerState> states_;
  std::vector<int> supports_;
  std::vector<TowerLoad> loads_;
  std::vector<int> below_;         // by body: the only body below; kNone, kSeveral
  std::vector<int> above_;         // by body: number of unsettled contacts from above
  std::vector<char> no_tower_;     // by body: never part of a tower
  std::vector<int> contact_of_;    // by body: first of its contacts with the body below
  std::vector<int> next_contact_;  // by contact: the next one of the same body
  std::vector<int> ready_;         // bodies without unsettled contacts from above
  std::vector<Vec2> points_;
  std::vector<Vec2> hull_;
};

}  // namespace tumble
