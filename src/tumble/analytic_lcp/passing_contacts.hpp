/// \file
/// \brief Contacts of bodies that have no contact area until they overlap, and points that a turn brings in.
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
///
/// Pairs with a contact may miss points: edges that meet in one point have no other, though a turn about it
/// brings more of the two bodies together. Which points these are shows once the step has been tried.
/// \par Cost
/// One contact search for each pair without a contact that moves, and for each pair with one of bodies that turn.
/// No allocation once warm.
class PassingContacts {
 public:
  /// Adds contacts.
  /// \param world     the bodies at the start of the step
  /// \param pairs     that may meet, in ascending order
  /// \param contacts  in and out, in ascending order
  /// \param report    pair tests are counted
  void add(const World& world, std::span<const MovingBody> bodies, std::span<const IndexPair> pairs,
           double dt, RotationRule rotation, ContactList& contacts, StepReport& report);

  /// Finds contacts of pairs that have one, and that overlap all the same once the step is done, by more than
  /// tolerance::missed_overlap of their size.
  /// \param world     the bodies at the end of the step that was tried
  /// \param start     their states at its start
  /// \param before    how they moved at its start, one for each body index
  /// \param bodies    how they moved during it
  /// \param contacts  of the step, in ascending order
  /// \param out       those and the new ones, in ascending order, if there is a new one; a pair may have several
  /// \param report    pair tests are counted
  /// \return whether there is a new one
  bool find_missed(const World& world, std::span<const BodyState> start,
                   std::span<const MovingBody> before, std::span<const MovingBody> bodies,
                   double dt, const ContactList& contacts, ContactList& out, StepReport& report);

 private:
  std::vector<BodyState> ended_;  // if nothing pushes
};

}  // namespace tumble
