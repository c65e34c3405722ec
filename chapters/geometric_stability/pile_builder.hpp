/// \file
/// \brief Piles that touch exactly, built box by box (thesis 5.4).
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"

#include <vector>

namespace tumble::chapters {

/// Puts boxes on boxes so that they touch to rounding, and keeps clear of near misses.
///
/// Whether a corner is over its support must not hang on a tolerance. So a box is refused if it
/// overlaps another one, or if anything about it is neither exact nor clearly apart: a gap, the
/// distance of a contact point from a corner, the width of a contact area, the lean of a normal. What
/// counts as clearly apart is twice the tolerances of `damped`, and 10^4 times the exact ones.
class PileBuilder {
 public:
  /// Begins with the ground.
  PileBuilder() { world_.add_ground(); }

  /// Adds a box where it is.
  /// \param body   size and mass
  /// \param state  its pose, at rest
  /// \return false if it was refused; the pile is then as before
  bool add(const BodyProperties& body, const BodyState& state);

  /// Adds a box from above: it goes straight down until it touches something.
  /// \param body   size and mass
  /// \param state  its pose, at rest; its height does not matter
  /// \return false if it was refused; the pile is then as before
  bool lower(const BodyProperties& body, const BodyState& state);

  /// The pile so far.
  /// \return the ground and the boxes, in the order of adding
  [[nodiscard]] const World& world() const { return world_; }

 private:
  [[nodiscard]] bool clear(const Box& box) const;
  [[nodiscard]] bool contacts_are_plain() const;

  World world_;
};

/// Everything that touches.
/// \param world   the bodies where they are
/// \param margin  [m] surfaces up to this far apart touch
/// \return contacts sorted by id
ContactList touching(const World& world, double margin = 1e-9);

/// The same bodies, added in another order; the names stay.
/// \param world   the bodies
/// \param random  of the order
/// \return a world in which every body has another index
World reordered(const World& world, Random& random);

/// Brings a list into another order.
/// \param contacts  in and out
/// \param random    of the order
void shuffle(ContactList& contacts, Random& random);

/// The body on which a contact presses from above.
/// \param contact  with a vertical normal
/// \return the index of the upper body
int upper_body(const Contact& contact);

/// The other body of a contact.
/// \param contact  with a vertical normal
/// \return the index of the lower body
int lower_body(const Contact& contact);

}  // namespace tumble::chapters
