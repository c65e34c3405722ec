/// \file
/// \brief Contacts of bodies that have no contact area until they overlap, and edges without height that are none.
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Finds what a step would miss: pairs that are apart corner to corner, whose faces do not lie over each
/// other, and that overlap at the end of the step if nothing pushes (thesis 2.6.3).
///
/// Normal and points are those of the overlap at the end, moved back by the motion of the two bodies; the
/// gap is the one that this motion closes, so that the step may close it and no more. Pairs that pass
/// each other have no overlap at the end, and no contact.
/// \par Cost
/// One contact search for each pair without a contact that moves. No allocation once warm.
class PassingContacts {
 public:
  /// Adds contacts.
  /// \param world     the bodies at the start of the step
  /// \param bodies    how they move, one for each body index
  /// \param pairs     that may meet, in ascending order
  /// \param dt        [s] the step
  /// \param rotation  how bodies turn
  /// \param contacts  in and out, in ascending order
  /// \param report    pair tests are counted
  void add(const World& world, std::span<const MovingBody> bodies, std::span<const IndexPair> pairs,
           double dt, RotationRule rotation, ContactList& contacts, StepReport& report);

 private:
  std::vector<BodyState> ended_;  // if nothing pushes
};

/// Whether two boxes would meet at an edge that has no height across the way on which they meet, and that lies in a
/// plane on which another contact holds one of them. A box that slides over flush tiles meets the side of the next
/// one so, and would be stopped by it.
///
/// Both are closed along the direction in which they are apart until they overlap there by `tolerance::flush_overlap`
/// of the shortest edge. If they then overlap in some other direction by less than `tolerance::flush_height`, that is
/// the height of the edge.
/// \param world     where the bodies are
/// \param pair      indices of both
/// \param contacts  of this moment
/// \return whether the pair can be left out; false if one of them is the ground, which has no edges
/// \par Cost
/// One or two calls of separation(), and a look at all contacts if the edge has no height.
[[nodiscard]] bool meets_flush_edge(const World& world, const IndexPair& pair,
                                    std::span<const Contact> contacts);

/// Takes out contacts at such edges.
/// \param world     where the bodies are
/// \param contacts  in and out; the others keep their order
/// \par Cost
/// One call of separation() for each contact whose points lie on a line.
void drop_flush_edges(const World& world, ContactList& contacts);

}  // namespace tumble
