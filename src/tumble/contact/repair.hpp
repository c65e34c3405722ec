/// \file
/// \brief Bodies that overlap are moved apart, from the ground up (thesis 4.4).
#pragma once

#include "tumble/contact/graph.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// How far and how long to move bodies apart.
struct RepairOptions {
  /// [-] overlap that is left, as a share of the shortest edge of the two bodies; a gap would end
  /// the contact, and without any slop rounding would look like overlap
  double slop = tolerance::repair_slop;
  /// passes over all pairs, at least 1. A stack takes one; a row of four boxes pressed sideways
  /// against a wall takes 46, if not left to the next steps, since boxes of one level share
  int most_sweeps = 20;
};

/// Whether a repair has reached its aim.
enum class RepairStatus : std::uint8_t {
  clear,    ///< no pair overlaps by more than its slop (and tolerance::repair_closeness of it)
  unsolved  ///< the sweeps are used up: too many, or there is no room, as between two near walls
};

/// What a repair did.
struct RepairReport {
  RepairStatus status = RepairStatus::clear;  ///< whether it reached its aim
  double deepest_before = 0.0;                ///< [m] deepest overlap found at the start, from 0
  double deepest_after = 0.0;                 ///< [m] deepest overlap left at the end, from 0
  int sweeps = 0;                             ///< passes in which bodies were moved, from 0
  int moves = 0;                              ///< pairs moved apart, each time counted
  std::int64_t pair_tests = 0;                ///< separation tests of two bodies
  double energy = 0.0;                        ///< [J] potential energy added, for booking
};

/// Adds pair tests, energy and the deepest overlap to the report of a step.
void book(const RepairReport& repaired, StepReport& report);

/// Bounds in which bodies that overlap are found, and those that may once they are moved apart.
/// \param margin  [m] pairs up to this far apart are found as well, at least 0
/// \param out     is overwritten, one for each body index; its capacity is kept
void repair_bounds(const World& world, double margin, std::vector<Bounds>& out);

/// Ends overlaps by moving bodies, with positions as the only thing that changes.
///
/// The method of the thesis's listing FIXCONTACTCONSTRAINTS, which goes up from the ground and moves
/// the upper body of each contact out of the lower one. Where the listing can fail we differ:
/// - the distance to move is the depth along a fresh normal, in place of small pushes repeated
///   until the test for overlap fails, which need not happen;
/// - a small overlap is left, not a gap, so that a contact stays a contact;
/// - immovable and sleeping bodies never move: under a shelf the box goes down;
/// - "from the ground up" is by level of ContactGraph, not by height. Of two bodies the one of the
///   higher level moves; in one level both do, the lighter one farther;
/// - as a push may cause another overlap, pairs are looked at again and sweeps repeated, up to a cap.
///
/// A body that finds itself pushed to and fro takes each time half the step, and so comes to rest in
/// the middle of a place that is too narrow for it; the status reports it.
///
/// Momenta and orientations stay as they are, so kinetic energy does too. Potential energy does not:
/// things mostly go up. The report has it.
/// \par Cost and determinism
/// A test for each pair if nothing overlaps; in a sweep, one for each pair whose bodies have moved.
/// No allocation once the storage is warm. The result does not depend on the order of the pairs.
/// \see Guendelman, Bridson, Fedkiw, "Nonconvex rigid bodies with stacking", 2003, for the levels.
/// \algorithm{FIXCONTACTCONSTRAINTS: section 4.4 and appendix A.2}
/// \deviation{Bodies are moved by their measured overlap in place of small pushes; a small overlap is left in place of a gap.}
/// \verified{A stack of five pressed into itself is put right in one sweep}
class OverlapRepair {
 public:
  /// Makes the storage.
  /// \throws std::invalid_argument for a slop that is not finite and above 0, or no sweep
  explicit OverlapRepair(const RepairOptions& options = {});

  /// Moves bodies apart.
  /// \param world  the bodies; changes positions only
  /// \param pairs  pairs to be looked at, by index, in any order: all that overlap, and all that
  ///               may once bodies move by the depth of the overlaps, so find them with bounds
  ///               that are widened by as much
  /// \throws std::invalid_argument for an index out of range or a pair of a body with itself
  RepairReport run(World& world, std::span<const IndexPair> pairs);

 private:
  /// A pair that can be moved apart, and its last known state.
  struct Candidate {
    IndexPair pair;
    int upper_level = 0;            // of the two bodies
    int lower_level = 0;            // ditto
    double slop = 0.0;              // [m]
    double distance = 0.0;          // [m] below 0: overlap
    Vec3 normal_w = Vec3::UnitY();  // [-] from the first body to the second
    int first_moves = -1;           // moves_ of the first body when this was measured
    int second_moves = -1;          // ditto, of the second body
    [[nodiscard]] bool too_deep() const;
  };

  void prepare(const World& world, std::span<const IndexPair> pairs);
  void measure(Candidate& candidate, const World& world, RepairReport& report);
  double measure_all(const World& world, RepairReport& report);
  void sort_from_the_ground_up(const World& world);
  void move_apart(const Candidate& candidate);
  void move(int body, const Vec3& push_w, bool alone);
  void store(World& world, RepairReport& report) const;

  RepairOptions options_;
  std::vector<Candidate> candidates_;
  std::vector<SupportEdge> edges_;
  ContactGraph graph_;
  std::vector<Box> boxes_;      // by index, at the positions reached; not used for the ground
  std::vector<double> ease_;    // [1/kg] by index: inverse mass, 0 for those that must not move
  std::vector<int> moves_;      // by index: how often the body was moved
  std::vector<double> stride_;  // [-] by index: 1, halved each time that it is pushed to and fro
  std::vector<Vec3> push_w_;    // [m] by index: the last push out of a body that stays
};

}  // namespace tumble
