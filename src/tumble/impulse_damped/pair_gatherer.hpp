/// \file
/// \brief Pairs of bodies that overlap at predicted poses, with a normal and points (thesis 3.3.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Contact normal of two bodies that overlap.
enum class NormalRule : std::uint8_t {
  last_face,       ///< across the face that was closest when the step began: the thesis's
  separation,      ///< the shortest way out: exact for two boxes
  signed_distance  ///< the gradient of a box's distance at the deepest point of the other one
};

/// Contact points of two bodies that overlap.
enum class PointRule : std::uint8_t {
  one,  ///< the centre of the overlap: the thesis's
  area  ///< all points of the contact area
};

/// Counts of a search for pairs.
struct PairReport {
  std::int64_t pair_tests = 0;   ///< separation tests of two bodies
  double deepest_overlap = 0.0;  ///< [m] 0 or above
};

/// Finds the pairs of bodies that overlap at given poses, for methods that let bodies overlap and then apply impulses.
///
/// The separating axis test decides whether two bodies overlap; touching counts. The normal is that of the rule:
/// - `last_face`: the normal of the face that was closest at the start of the step, turned with its body since. It is
///   wrong where edges meet, and where the bodies have moved on to another face;
/// - `separation`: the direction of least overlap, faces preferred (see separation());
/// - `signed_distance`: see deepest_gradient(), and the direction of least overlap where it finds nothing.
///
/// On the ground all rules give +y.
///
/// The point of PointRule::one is the centre of the overlapping points of the contact area, weighted by depth (equally,
/// if all just touch). The thesis leaves it open: a corner would make every box that lands flat spin, and
/// the unweighted centre would jump where a corner separates.
///
/// Only storage is kept from step to step: the closest face is found once for all passes of a step, and a pair of which
/// neither body has moved since the pass before is not tested again.
/// \par Cost and determinism
/// A broad phase and a test for each near pair; six more axes for `last_face` and 52 points for
/// `signed_distance`. No allocation once the storage is warm. The list is sorted by ids.
class PairGatherer {
 public:
  /// Makes a gatherer.
  explicit PairGatherer(NormalRule normals = NormalRule::last_face,
                        PointRule points = PointRule::one);

  /// Finds the overlapping pairs.
  ///
  /// Friction and restitution are combined as gather_contacts() does it. Impulses and approach
  /// speeds are 0 (see stamp_approach_speeds()). Pairs of two immovable or two sleeping bodies are
  /// left out.
  /// \param world     the bodies; its poses are not used
  /// \param last      poses at the start of the step, one for each body index
  /// \param now       poses at which overlap is searched, ditto
  /// \param sleeping  pairs to leave out besides (SleepingRule::needs_test()); nullptr: none
  /// \param margin    [m] surfaces up to this far apart count as touching, at least 0
  /// \param out       is overwritten; sorted by id
  /// \throws std::invalid_argument for spans of the wrong length or a margin below 0
  PairReport gather(const World& world, std::span<const BodyState> last,
                    std::span<const BodyState> now, const SleepingRule* sleeping, double margin,
                    ContactList& out);

 private:
  // The face that was closest at the start of the step.
  struct LastFace {
    IndexPair pair;
    AxisIndex axis = kNoAxis;
    double side = 1.0;  // [-] of the other box: along the axis, or -1 against it
  };

  // What the last search found of a pair that is near.
  struct Searched {
    IndexPair pair;
    int manifold = -1;  // its place among those of the search; -1: they do not touch
  };

  bool place_boxes(std::span<const BodyProperties> bodies, std::span<const BodyState> now,
                   double margin);
  void remember(std::span<const BodyProperties> bodies, std::span<const BodyState> last);
  const LastFace& last_face(const IndexPair& pair);
  void turn_normal(const IndexPair& pair, double margin, Manifold& manifold);

  NormalRule normals_;
  PointRule points_;
  BoundingTree broad_phase_;
  std::vector<Box> boxes_;  // by body, now; that of the ground is not used
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  // Of the last search. A pass of a step moves few bodies, so most pairs are as they were.
  std::vector<BodyState> now_;
  std::vector<Vec3> sizes_;
  std::vector<char> moved_;       // since the search before
  std::vector<Searched> before_;  // sorted by pair
  std::vector<Manifold> manifolds_before_;
  std::vector<Searched> searched_;  // ditto, of the search that is going on
  std::vector<Manifold> manifolds_;
  Manifold manifold_;    // of the pair that is looked at
  double margin_ = 0.0;  // [m]
  // Of the start of the step, which all passes of a step share: found again of bodies whose pose or size has changed.
  std::vector<BodyState> last_;
  std::vector<Vec3> last_sizes_;
  std::vector<Box> last_boxes_;
  std::vector<LastFace> last_faces_;  // sorted by pair
};

}  // namespace tumble
