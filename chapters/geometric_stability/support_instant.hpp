/// \file
/// \brief A scene at its first instant: who is stable, and what the contact forces do (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// What a rule says about one body.
struct RuleAnswer {
  bool stable = false;    ///< whether it is geometrically stable
  std::string told;       ///< why, or what speaks against it
  std::vector<char> all;  ///< by body index: whether that body is stable
};

/// Bodies at rest with their contacts, and the questions that the figures on support ask.
class SupportInstant {
 public:
  /// Gathers the contacts.
  /// \param world  the bodies; kept
  explicit SupportInstant(World world);

  /// Takes all that touches a body from below away, as if it stood on nothing.
  /// \param body  its index
  void take_support(int body);

  /// What a rule says, with the exact tolerances of the technique `analytic`.
  /// \param rule  `corners` or `hull`
  /// \param body  its index
  /// \return the verdict and its reason
  [[nodiscard]] RuleAnswer ask(StableRule rule, int body) const;

  /// Whether every load on a body is carried, as LoadProof finds it.
  /// \param body  its index
  /// \return true if so
  [[nodiscard]] bool load_proof(int body) const;

  /// How a body starts to move under the forces of the whole complementarity problem, without
  /// friction and with no body left out.
  /// \param body  its index
  /// \param load  [N] a weight on `at_w`, beside gravity; at least 0
  /// \param at_w  [m] where it presses on the body
  /// \return [m/s²] the largest acceleration of a corner of the body
  /// \throws std::runtime_error if the problem was not solved
  [[nodiscard]] double acceleration(int body, double load = 0.0,
                                    const Vec3& at_w = Vec3::Zero()) const;

  /// The same under the worst of loads on the corners of its upper face.
  /// \param body  its index, of an upright box
  /// \param load  [N] weight, on one corner at a time
  /// \return [m/s²] the largest acceleration of a corner of the body
  [[nodiscard]] double worst_acceleration(int body, double load) const;

  /// The bodies.
  /// \return as given
  [[nodiscard]] const World& world() const { return world_; }
  /// What touches.
  /// \return sorted by id
  [[nodiscard]] const ContactList& contacts() const { return contacts_; }

 private:
  World world_;
  ContactList contacts_;
};

/// The body on which a contact presses from above.
/// \param contact  with a vertical normal
/// \return the index of the upper body
[[nodiscard]] int upper_body(const Contact& contact);

/// The other body of a contact.
/// \param contact  with a vertical normal
/// \return the index of the lower body
[[nodiscard]] int lower_body(const Contact& contact);

}  // namespace tumble::chapters
