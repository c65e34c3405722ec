/// \file
/// \brief The time of the next collision among bodies that fly and bodies that rest (thesis 3.3.1).
#pragma once

#include "tumble/analytic_lcp/forced_flight.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/contact.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// A search: pairs, interval and precision.
struct ImpactSearchTask {
  std::span<const IndexPair> candidates;  ///< pairs that may meet, sorted
  std::span<const Contact> near;  ///< all points within the margin at the start, sorted by id
  double end = 0.0;               ///< [s] until when, from the start of the flight
  double resolution = tolerance::event_resolution;  ///< [s] how closely
  double dt = 1.0 / 60.0;                           ///< [s] the time step, for touch_scale()
  RotationRule rule = RotationRule::splitting;      ///< how bodies turn
};

/// The result of a search.
struct FirstImpact {
  bool found = false;            ///< whether there is one
  double time = 0.0;             ///< [s] found: by now a pair has met, one resolution ago none had
  std::int64_t evaluations = 0;  ///< times at which pairs were looked at
  std::int64_t pair_tests = 0;   ///< of two bodies
};

/// Finds the first collision of a flight, also of bodies that rest on each other already.
///
/// A pair *has met* at a time if it was apart at the start and overlaps by then; or, if it was
/// within the margin at the start, if one of its points is below 0 there and approaches faster
/// than the resting speed. So the corner of a rocking block is a collision when it comes down although
/// the block has not left the ground, and a box at rest is none, wherever rounding has put it.
///
/// As in the thesis the end of the interval is looked at, and if pairs have met by then the time is
/// found by halving. All of them are looked at each time, so a third body that collides earlier is not
/// missed, and there is nothing to begin again for it. Pairs that meet and part within the interval are looked
/// at in the middle of their passage too, by their straight ways without turning. Pairs that touch at the start, as after
/// a corner has hit, and go or turn far are looked at up to 64 times on the way. Only a passage that turning makes is
/// missed.
/// \par Cost and determinism
/// One look at all pairs if nothing has met at the end, and one for each passage; else one more for each
/// halving, at pairs that may still be the first and their bodies only. No allocation once warm.
class ImpactSearch {
 public:
  /// Searches.
  /// \param world   the bodies; states are overwritten, and are those at the start of the flight in
  ///                the end
  FirstImpact find(const ForcedFlight& flight, const ImpactSearchTask& task, World& world);

 private:
  void involve_all(const World& world);
  void list_passages(const ForcedFlight& flight, double end, const World& world);
  void list_passage(const ForcedFlight& flight, const IndexPair& pair, double end,
                    const World& world);
  void list_looks(const IndexPair& pair, double end, const World& world);
  [[nodiscard]] bool passes(std::span<const IndexPair> met) const;
  bool look(const ForcedFlight& flight, const ImpactSearchTask& task, double time, World& world,
            FirstImpact& result);
  void keep_those_that_met();
  bool narrow(const ForcedFlight& flight, const ImpactSearchTask& task, World& world,
              FirstImpact& result);

  std::vector<IndexPair> near_;  // that may be the first: within the margin at the start
  std::vector<IndexPair> far_;   // the others
  std::vector<IndexPair> near_met_;
  std::vector<IndexPair> far_met_;
  std::vector<IndexPair> through_;  // within the margin at the start, going or turning far
  std::vector<int> involved_;       // bodies of these pairs
  std::vector<Vec3> way_w_;         // [m] of each body until the end
  std::vector<double> turned_;      // [m] way of a body's corners by turning, at most
  std::vector<double> passages_;    // [s]
  std::vector<MovingBody> moving_;
  ContactList overlaps_;
};

}  // namespace tumble
