/// \file
/// \brief Changes of contact in a run, and which of them another run does not have (claim 6.2f).
#pragma once

#include "exterior_rotation/geometric_contacts.hpp"

#include <vector>

namespace tumble::chapters {

/// What changed about a joint.
enum class ChangeKind : std::uint8_t {
  lost,     ///< corners touch no longer
  found,    ///< corners touch again; also if others were lost in the same step
  overlap,  ///< the bodies are found in each other
  cleared   ///< they are no longer
};

/// A joint is seen otherwise than in the step before.
struct ContactChange {
  int step = 0;                        ///< after which it is first seen, from 1
  int joint = 0;                       ///< its place
  ChangeKind kind = ChangeKind::lost;  ///< what it is
  int touching = 0;                    ///< of a change of touching: the corners that do now

  /// Whether two are the same, but for the step.
  /// \param other the other one
  /// \return true if joint, kind and corners are equal
  [[nodiscard]] bool same(const ContactChange& other) const {
    return joint == other.joint && kind == other.kind && touching == other.touching;
  }
};

/// The changes of contact of a run.
/// \param looks  at all joints, by step; the first one is at the start
/// \return in the order of steps. What touches and what is overlapped change one by one: a step can
///         have both for a joint
std::vector<ContactChange> changes_of(const std::vector<std::vector<ContactSet>>& looks);

/// The changes that another run does not have.
///
/// Each change of the other run answers for one change at most, the first one that is within reach.
/// \param changes  of the run that is judged
/// \param other    of the run that judges
/// \param within   steps that the same change may be earlier or later, from 0
/// \return those that nothing answers for
std::vector<ContactChange> changes_not_in(const std::vector<ContactChange>& changes,
                                          const std::vector<ContactChange>& other, int within);

}  // namespace tumble::chapters
