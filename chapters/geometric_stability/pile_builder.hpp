/// \file
/// \brief Piles that touch exactly, built box by box (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Puts boxes on boxes so that they touch to rounding, and keeps clear of near misses.
//
// Whether a corner is over its support must not hang on a tolerance. So a box is refused if it
// overlaps another one, or if anything about it is neither exact nor clearly apart: a gap, the
// distance of a contact point from a corner, the width of a contact area, the lean of a normal. What
// counts as clearly apart is twice the tolerances of `damped`, and 10^4 times the exact ones.
class PileBuilder {
 public:
  // Begins with the ground.
  PileBuilder() { world_.add_ground(); }

  // Adds a box where it is.
  bool add(const BodyProperties& body, const BodyState& state);

  // Adds a box from above: it goes straight down until it touches something.
  bool lower(const BodyProperties& body, const BodyState& state);

  // The pile so far.
  [[nodiscard]] const World& world() const { return world_; }

 private:
  [[nodiscard]] bool clear(const Box& box) const;
  [[nodiscard]] bool contacts_are_plain() const;

  World world_;
};

// Everything that touches.
// margin: [m] surfaces up to this far apart touch
ContactList touching(const World& world, double margin = 1e-9);

// The same bodies, added in another order; the names stay.
World reordered(const World& world, Random& random);

// Brings a list into another order.
void shuffle(ContactList& contacts, Random& random);

// The body on which a contact presses from above.
int upper_body(const Contact& contact);

// The other body of a contact.
int lower_body(const Contact& contact);

}  // namespace tumble::chapters
