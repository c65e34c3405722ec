/// \file
/// \brief The contact areas of a step, kept while bodies rest (thesis 3.2, 6.3.1).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact_damped/contact_patch.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <span>
#include <vector>

namespace tumble {

/// What PersistentManifolds::find() did.
struct ManifoldsFound {
  std::int64_t pair_tests = 0;   ///< pairs of which the geometry was looked at
  std::int64_t points = 0;       ///< contact points there are
  double deepest_overlap = 0.0;  ///< [m] 0 or above
};

/// Finds the contact areas of a step, and keeps those whose bodies have hardly moved.
///
/// An area is kept while neither body has moved by more than `tolerance::kept_motion` of the pair's
/// shortest edge, or turned by as many radians, since it was found, and nobody fell asleep, woke up or was
/// given a velocity: its points, frame and inverse masses stay, and the gaps follow from the small
/// motion to first order. So a island at rest costs a comparison for each pair, nothing is added or
/// dropped, and the impulses of the step before are its solution still. Where an area is found anew it
/// inherits the impulse as a whole, force and centre of pressure, which do not depend on which points
/// stand for it; if its new points cannot bear that without pulling, each takes over from one before.
///
/// Bodies that can come together within the step touch: points that are apart get targets
/// (set_targets()), so a box that falls flat is caught by all of its face at once.
/// \par Cost and determinism
/// No allocation once warm. A copy of it is a snapshot.
class PersistentManifolds {
 public:
  /// Finds the areas of a step.
  /// \param world       where the bodies are
  /// \param bodies      how they would move without contacts, by index
  /// \param candidates  pairs by index, first < second, sorted, each once
  /// \param dt          [s] of the step
  /// \param impulses    [-] impulses of the step before are multiplied by this (the ratio of the steps)
  /// \return counts
  ManifoldsFound find(const World& world, std::span<const MovingBody> bodies,
                      std::span<const IndexPair> candidates, double dt, double impulses);

  /// The areas of the last step, sorted by the ids of their bodies.
  /// \return may be changed; impulses are those that the next step begins with
  [[nodiscard]] std::vector<ContactPatch>& blocks() { return blocks_; }

  /// The areas of the last step, sorted by the ids of their bodies.
  /// \return one for each pair that touches
  [[nodiscard]] const std::vector<ContactPatch>& blocks() const { return blocks_; }

 private:
  ContactPatch* take_old(BodyId first, BodyId second);
  [[nodiscard]] bool keep(const World& world, const IndexPair& pair, const MovingBody& first,
                          const MovingBody& second, double reach, ContactPatch& block) const;

  std::vector<ContactPatch> blocks_;
  std::vector<ContactPatch> before_;
  std::size_t next_ = 0;     // of before_, while they are walked through
  std::uint64_t built_ = 0;  // areas found so far: their stamps
};

}  // namespace tumble
