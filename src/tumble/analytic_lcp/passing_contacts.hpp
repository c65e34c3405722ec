/// \file
/// \brief Contacts of bodies that have no contact area until they overlap.
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

}  // namespace tumble
