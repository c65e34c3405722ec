/// \file
/// \brief Random piles of boxes at rest, for judging verdicts on stability (thesis 5.4).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Ingredients of a random pile.
struct PileRecipe {
  int boxes = 12;         // tries to add something; a slab on four pillars counts once
  double tilted = 0.1;    // [-] share of them that come down tilted
  bool scaffolds = true;  // whether there may be a box in a trough, or a plank that leans
};

// A random pile: boxes upon boxes, at rest, that touch exactly.
//
// Heights are few, so that supports of equal height are frequent. Boxes come down within the top of
// another one, over its edge, across two of equal height, beside another one so that faces touch, or on four
// pillars of their own; straight or turned about the vertical; of masses from 0.2 to 5 kg. Some of
// them are immovable, and some come down tilted, so that they lie on an edge or a corner. Beside the
// pile there may be a box in a trough, and a plank that leans on a block: they have contacts
// that are not vertical, and mostly rest.
//
// Nothing is nearly so: see PileBuilder.
World random_pile(std::uint64_t seed, const PileRecipe& recipe = {});

}  // namespace tumble::chapters
