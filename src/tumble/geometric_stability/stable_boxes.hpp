/// \file
/// \brief Bodies that may be left out of the system of contact forces (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/contact/islands.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"
#include "tumble/geometric_stability/towers.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Degrees of freedom in which a body is treated as immovable. A char, so that 0 means none.
enum class Hold : char {
  free = 0,     ///< none
  upright = 1,  ///< does not rise, sink or tip; may slide and spin about the vertical
  still = 2     ///< does not move at all (tolerance::standstill)
};

/// Cost of one search for stable boxes.
struct StableBoxesReport {
  bool remembered = false;           ///< nothing has changed: result of the last search
  int stable = 0;                    ///< movable bodies that are stable
  int pivots = 0;                    ///< of the static equilibrium
  std::int64_t multiplications = 0;  ///< its cost, independent of the machine
};

/// Finds bodies that stay where they are under any contact forces, so that they can be treated as immovable.
///
/// With `corners` or `hull`: GeometricStability with exact supports, for bodies that neither rise nor
/// sink nor tip. With `equilibrium`, cheapest first:
/// 1. bodies that are stable by the hull; from then on they are treated as immovable;
/// 2. towers on them, replaced by loads (Towers);
/// 3. whole islands of the other bodies that are in equilibrium under their weight and the towers on
///    them (StaticEquilibrium).
///
/// Steps 2 and 3 show that a body does not accelerate in the present state only. So a body that touches
/// another body outside all such groups is in none either.
///
/// **Excluded** are bodies that rise, sink or tip noticeably (tolerance::resting_speed), and those with a
/// gap still to close (tolerance::contact_gap). In towers and islands also bodies that spin; and where a
/// normal is not vertical, all that move, since holding them would brake.
///
/// **Memory.** Contacts, masses, motion and the poses of bodies in contact are stored. As long as they
/// are the same to the bit, as in a pile at rest, the last result is reused; the result never depends
/// on the memory.
/// \par Cost and determinism
/// A comparison of the contacts if nothing has changed, otherwise that of the parts. The result does not
/// depend on the order of bodies or contacts.
/// \algorithm{Leaving stable boxes out: section 5.4}
/// \verified{Leaving stable boxes out changes no acceleration}
class StableBoxes {
 public:
  /// Cap for StaticEquilibrium: for islands with more contact points it takes longer than their forces.
  static constexpr int kMostPoints = 500;

  /// \param rule         definition of stability
  /// \param most_points  `equilibrium`: islands with more contact points are never held
  explicit StableBoxes(StableRule rule, int most_points = kMostPoints)
      : rule_(rule), most_points_(most_points) {}

  /// Finds the stable bodies.
  /// \param contacts  points where forces can act, and no others
  /// \return by index, a Hold: `free` for bodies that may accelerate; valid until the next call
  /// \throws std::invalid_argument for a contact of an unknown body, or a wrong number of bodies
  std::span<const char> find(const World& world, std::span<const MovingBody> bodies,
                             std::span<const Contact> contacts);

  /// Cost of the last find().
  [[nodiscard]] const StableBoxesReport& report() const { return report_; }

 private:
  // Input of a search.
  struct Basis {
    Vec3 gravity_w = Vec3::Zero();
    std::vector<BodyId> ids;
    std::vector<double> inverse_masses;
    std::vector<char> motion;
    std::vector<BodyState> states;  // poses of the bodies
    ContactList contacts;
  };

  void find_motion(const World& world, std::span<const MovingBody> bodies,
                   std::span<const Contact> contacts);
  [[nodiscard]] bool unchanged(const World& world, std::span<const Contact> contacts) const;
  void search(const World& world, std::span<const Contact> contacts);
  void add_balanced(const World& world, std::span<const Contact> contacts);
  void drop_large_islands(const World& world);
  void take_islands(const World& world);
  void take_towers(const World& world);

  StableRule rule_;
  int most_points_;
  GeometricStability geometric_;
  Towers towers_;
  StaticEquilibrium equilibrium_;
  StableBoxesReport report_;
  bool known_ = false;  // whether basis_ and held_ belong to a search
  Basis basis_;
  std::vector<char> motion_;  // by index: motion of a body
  std::vector<char> held_;    // by index: a Hold
  std::vector<char> stable_;  // by index: by the rule of the thesis
  std::vector<char> apart_;   // by index: not part of a tower
  ContactList left_;          // contacts of bodies that are not loads
  std::vector<Load> loads_;   // towers on bodies outside towers
  std::vector<char> drop_;    // by contact in left_: of an island above the cap
  Islands islands_;
};

}  // namespace tumble
