/// \file
/// \brief Prisms on blocks, for which a hull can decide and four corners cannot (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A body that is no box, on blocks.
struct PrismOnBlocks {
  World world;           // ground, blocks, and last the prism
  ContactList contacts;  // of the blocks with the ground, and of the prism with the blocks
  std::vector<GeometricStability::Outline> outlines;  // by body index; that of a box is empty
  int prism = 0;                                      // index of the prism
};

// A regular prism that stands upright on blocks of one height near its corners, each of which may miss
// its corner or be missing.
//
// The library knows boxes only. Here the prism is a body as large as the box around it, with the
// inertia of a prism, an outline of its own, and contact points at the corners of the areas in
// which the outline and the tops of blocks overlap.
PrismOnBlocks random_prism(int sides, Random& random);

// The intersection of two convex polygons (Sutherland and Hodgman).
// polygon: [m] counterclockwise
// window: [m] counterclockwise
std::vector<Vec2> common_area(std::vector<Vec2> polygon, const std::vector<Vec2>& window);

}  // namespace tumble::chapters
