/// \file
/// \brief Bodies that support any load on top, by static equilibrium (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The largest set of bodies that stays at rest under any load on top.
///
/// A set of bodies that neither rise, sink nor tip (tolerance::resting_speed) is load-proof if
/// 1. movable bodies outside the set touch it from above only, with vertical normals, and
/// 2. contacts within it, and with immovable bodies, can balance a load that acts straight down on
///    any corner of any member's outline.
///
/// Every load from outside is a sum of such loads. Their equilibrium, together with rest, satisfies all
/// conditions of the complementarity problem of the contact forces, whose accelerations are unique:
/// no member accelerates under any load. That is the thesis's promise (5.4) without its rule: bodies
/// may touch side by side, and corners may overhang if neighbours prevent tipping. Every body that is
/// stable by the rule is load-proof; its own weight is a sum of such loads, too.
///
/// The union of two load-proof sets is load-proof, so there is a largest. It is found by starting with
/// all bodies and removing those that break a condition, in any order. Members by the rule of the
/// hull are known beforehand and treated as immovable.
/// \par Cost
/// A static equilibrium for each corner of each undecided body, repeated at most as often as bodies are
/// removed. For the analysis of structures, not for every step.
/// \algorithm{Every load on top: sections 5.4 and 6.3.1}
/// \verified{Load-proof bodies do not accelerate, whatever is put on top}
class LoadProof {
 public:
  /// Finds the set.
  /// \param stable    out: one for each body index, 1 if it is immovable or a member
  void run(const World& world, std::span<const Contact> contacts, std::vector<char>& stable);

 private:
  void collect(std::span<const Contact> contacts, std::span<const char> members);
  [[nodiscard]] bool touched_from_outside(std::span<const Contact> contacts,
                                          std::span<const char> members, int body) const;
  bool carries_corners(const World& world, int body);

  GeometricStability rule_;
  double vertical_ = 0.0;  // [-] sine, see exact_vertical()
  StaticEquilibrium equilibrium_;
  ContactList within_;
  std::vector<char> known_;  // stable by the rule of the hull
  std::vector<Vec2> outline_;
  std::vector<Vec2> hull_;
};

}  // namespace tumble
