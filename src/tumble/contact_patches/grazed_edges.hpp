/// \file
/// \brief Edges without height, which a body that slides over flush neighbours must not hit (thesis 3.2, 6.3.1).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Removes the patches of grazed edges that lie at the height on which one of their bodies lies: a box that slides
/// over flush tiles touches the side of the next one with an edge of height 0.
/// \param bodies   by index, with their positions
/// \param patches  of a step; those with a `flat_w` are looked at, the others keep their order
/// \param since    patches with a stamp up to this one stay: they may have given impulses already
/// \par Cost
/// One comparison for each grazed edge and patch.
void drop_grazed_edges(std::span<const MovingBody> bodies, std::vector<ContactPatch>& patches,
                       std::uint64_t since = 0);

}  // namespace tumble
