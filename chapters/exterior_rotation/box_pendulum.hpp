/// \file
/// \brief A box that hangs on one of its edges and swings (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

namespace tumble::chapters {

// The period of a box that swings about one of its long edges.
//
// With \f$d\f$ from the edge to the centre, \f$p^2 = 3g/4d\f$ and K the complete elliptic integral of
// modulus \f$\sin\tfrac{\theta_0}2\f$, by GSL: \f$T = 4K/p\f$.
// width: [m] of the box, across the edge
// height: [m] of the box, across the edge
// amplitude: [rad] how far it swings to each side, 0 to below pi; 0 gives the limit of small swings
// Returns [s] of a swing to and fro
double exact_swing_period(double width, double height, double amplitude);

// A box that hangs under a fixed beam, on one edge that is a joint.
struct HungBox {
  World world;  // the beam, then the box, released at the amplitude
  Glued glued;  // has found the joint, which is an edge

  // Hangs the box up, lets the technique find the joint, and pulls the box aside.
  // width: [m] across the edge; the edge is 1 m long and along z, at the origin
  // height: [m] across the edge
  // amplitude: [rad] of its centre about the edge, from straight below, towards +x
  HungBox(double width, double height, double amplitude, const GluedOptions& options);

  // Where the box is in its swing.
  // Returns [rad] of its centre about the edge, from straight below; -pi to pi
  [[nodiscard]] double angle() const;

  // Its energy.
  // Returns [J] kinetic and potential, above the origin
  [[nodiscard]] double energy() const;
};

// A swing that was simulated.
struct MeasuredSwing {
  double period = 0.0;  // [s] twice the time from one passage straight below to the next
  double apart = 0.0;   // [m] how far the edge has come apart then
};

// Lets a box swing until it has hung straight down for the second time, each passage found by halving
// the step.
// width: [m] of the box, across the edge
// height: [m] of the box, across the edge
// amplitude: [rad] how far it swings to each side, above 0
// accuracy: [-] of dormand_prince, error allowed in a step
MeasuredSwing measure_swing(double width, double height, double amplitude, double accuracy);

}  // namespace tumble::chapters
