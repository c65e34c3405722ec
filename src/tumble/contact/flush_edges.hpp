/// \file
/// \brief Edges without height, which a body that slides over flush neighbours must not hit (thesis 3.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/broad_phase.hpp"
#include "tumble/geometry/separation.hpp"

#include <span>

namespace tumble {

/// How two boxes overlap once they have met: moved together along a direction until they overlap there by
/// `tolerance::flush_overlap` of their size. If they do so by less than `tolerance::flush_height` along another direction, that
/// is the height of the edge at which they meet.
/// \param gap       [m] between them along the normal
/// \param size      [m] shortest edge of the two
/// \return the least overlap, and its direction
[[nodiscard]] Separation closed_along(const Box& first, Box second, const Vec3& normal_w,
                                      double gap, double size);

/// Whether two boxes would meet at an edge that has no height across the way on which they meet, and that lies in a
/// plane on which another contact holds one of them. A box that slides over flush tiles meets the side of the next
/// one so, and would be stopped by it.
///
/// Both are closed along the direction in which they are apart.
/// \return whether the pair can be left out; false if one of them is the ground, which has no edges
/// \par Cost
/// One or two calls of separation(), and a look at all contacts if the edge has no height.
[[nodiscard]] bool meets_flush_edge(const World& world, const IndexPair& pair,
                                    std::span<const Contact> contacts);

/// Takes out contacts at such edges.
/// \param contacts  in and out; the others keep their order
/// \par Cost
/// One call of separation() for each contact whose points lie on a line.
void drop_flush_edges(const World& world, ContactList& contacts);

}  // namespace tumble
