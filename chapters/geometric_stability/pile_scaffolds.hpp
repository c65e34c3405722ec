/// \file
/// \brief Boxes that rest on slanted supports, beside a random pile (thesis 5.4).
#pragma once

#include "tumble/base/random.hpp"

#include "geometric_stability/pile_builder.hpp"

namespace tumble::chapters {

// Adds two fixed blocks with faces at right angles, and a box between that lies on both: it rests,
// and none of its contacts is vertical.
void add_trough(Random& random, PileBuilder& builder);

// Adds a plank with its foot before a kerb that leans on the edge of a block. In two of three cases the
// block has a kerb behind it, and all rest; else the plank pushes it away.
void add_leaning_plank(Random& random, PileBuilder& builder);

}  // namespace tumble::chapters
