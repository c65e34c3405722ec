/// \file
/// \brief The contact patches of a step, kept while bodies rest (thesis 3.2, 6.3.1).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Counts of PersistentManifolds::find().
struct ManifoldsFound {
  std::int64_t pair_tests = 0;   ///< pairs whose geometry was tested
  std::int64_t points = 0;       ///< contact points found
  double deepest_overlap = 0.0;  ///< [m] 0 or above
};

/// The contact patches of a world. Finds those of a step, and keeps those whose bodies have hardly moved.
///
/// A patch is kept while neither body has moved by more than `tolerance::kept_motion` of the pair's
/// shortest edge, or turned by as many radians, since it was built, and neither fell asleep, woke up or was
/// given a velocity: its points, frame and inverse masses stay, and the gaps follow from the small
/// motion to first order. So an island at rest costs a comparison for each pair, no point is added or
/// dropped, and the impulses of the step before still solve it. A patch that is built again
/// takes over the impulse as a whole, force and centre of pressure, which do not depend on the choice of
/// points; if the new points would have to pull for it, each one takes over from a previous one.
///
/// Bodies that can come together within the step get a patch: points with a gap get targets
/// (set_targets()), so a box that falls flat lands on all of its face at once.
/// \par Cost and determinism
/// No allocation once warm. A copy of it is a snapshot.
class PersistentManifolds {
 public:
  /// Finds the patches of a step, with the impulses to start from.
  /// \param bodies         how they would move without contacts, by index
  /// \param candidates     pairs by index, first < second, sorted, each once
  /// \param impulse_ratio  [-] impulses of the step before are multiplied by this (the ratio of the steps)
  ManifoldsFound find(const World& world, std::span<const MovingBody> bodies,
                      std::span<const IndexPair> candidates, double dt, double impulse_ratio);

  /// Makes the patches of a step those of its first part.
  /// \param bodies  velocities without contacts in the part
  /// \param ratio   [-] of the part to the step
  void shorten(std::span<const MovingBody> bodies, double dt, double ratio);

  /// Adds the patches of pairs that find() left out, since they did not come near each other, and that overlap at the
  /// end of the step with the velocities that impulses have given them.
  /// \param bodies  how they move now, by index
  /// \return how many were added; their stamps are above all earlier ones
  int add_missed(const World& world, std::span<const MovingBody> bodies,
                 std::span<const IndexPair> candidates, double dt);

  /// Adds the points of a patch that find() left out, since they were too far apart, and that its bodies can reach with the
  /// velocities that impulses have given them.
  /// \param bodies  how they move now, by index
  /// \param patch   in and out: of patches()
  /// \return whether there are any; then targets are those of the gaps
  bool add_points(const World& world, std::span<const MovingBody> bodies, double dt,
                  ContactPatch& patch);

  /// The stamp of the last patch that was built; it rises with each.
  [[nodiscard]] std::uint64_t last_stamp() const { return built_; }

  /// The patches of the last step, sorted by the ids of their bodies. The next step starts from their impulses.
  [[nodiscard]] std::vector<ContactPatch>& patches() { return patches_; }

  /// Ditto.
  [[nodiscard]] const std::vector<ContactPatch>& patches() const { return patches_; }

 private:
  ContactPatch* previous_patch(BodyId first, BodyId second);
  static bool still_valid(const World& world, const IndexPair& pair, const MovingBody& first,
                          const MovingBody& second, double reach, ContactPatch& patch);
  bool look_for_patch(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
                      const Vec3& rest_w, const Vec3& gained_w, double dt,
                      const ContactPatch* previous);
  ContactPatch make_patch(const World& world, const IndexPair& pair, const Manifold& manifold,
                          const MovingBody& first, const MovingBody& second, double reach);

  std::vector<ContactPatch> patches_;
  std::vector<ContactPatch> previous_;
  std::size_t next_ = 0;     // of previous_, while find() goes through them
  std::uint64_t built_ = 0;  // patches built so far: their stamps
};

}  // namespace tumble
