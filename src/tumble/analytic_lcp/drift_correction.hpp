/// \file
/// \brief Overlap that the steps of a run pile up is ended without adding energy (thesis 4.4).
#pragma once

#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/technique.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Moves bodies out of each other; a body that is lifted loses as much kinetic energy as it gains height.
///
/// OverlapRepair moves bodies whose overlap exceeds the slop. A body that goes up gains
/// potential energy, and loses as much kinetic energy here, by scaling both of its momenta, as far as
/// it has any. The rest of the gain is booked: a body at rest has no kinetic energy to lose.
/// \par Cost
/// That of OverlapRepair. No allocation once warm.
class DriftCorrection {
 public:
  /// Ends overlap.
  /// \param world   positions, and momenta of bodies that were lifted
  /// \param pairs   as OverlapRepair::run() takes them
  /// \param report  tests, the deepest overlap found, and the energy added in all
  void run(World& world, std::span<const IndexPair> pairs, StepReport& report);

 private:
  OverlapRepair repair_;
  std::vector<Vec3> before_w_;  // [m] positions
};

}  // namespace tumble
