/// \file
/// \brief The single rotation that keeps the nested boxes of figure 6.3 together best (claim 6.2c).
#pragma once

#include "exterior_rotation/group_moves.hpp"

namespace tumble::chapters {

// A frame and what it leaves.
struct BestFrame {
  GroupFrame frame;   // the one with the smallest largest mismatch
  double left = 0.0;  // [m] that mismatch, after one step
};

// The best single rotation in the plane z = 0 for a box that stands on a box that stands on something
// immovable.
//
// Where the centre c is matters to the lower joint only: the two boxes' places differ by an amount in
// which c cancels. For any rate Omega but 0 there is one c that closes the lower joint. So the best frame
// closes it, and the rest is the upper joint's mismatch, a function of Omega alone. Its smallest value
// is looked for on a grid and between its points by Brent's method.
// widest: [rad/s] rates of the frame up to this one are tried, both ways round
BestFrame best_frame(const World& world, std::span<const Joint> joints, double dt, double widest);

}  // namespace tumble::chapters
