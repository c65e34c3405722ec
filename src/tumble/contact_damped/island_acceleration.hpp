/// \file
/// \brief Anderson acceleration of the sweeps over an island (thesis 6.3.1).
#pragma once

#include "tumble/contact_damped/island.hpp"
#include "tumble/math/anderson.hpp"

#include <vector>

namespace tumble {

/// Anderson acceleration of sweeps: pairs of one down and one up are the iteration, the impulses its unknowns.
///
/// Sweeps take many steps to stop the slowest motion of an island, the swaying of a tower; in the changes of a few pairs that
/// motion shows. The extrapolated impulses may leave the cones of friction and pull a little: the next sweeps put that right.
class IslandAcceleration {
 public:
  /// Begins with the impulses of an island as they are.
  void start(const Island& island);
  /// Compares velocities with those from which the pair of sweeps began.
  /// \return [m/s] the largest change of a body's fastest point
  [[nodiscard]] double largest_change(const Island& island) const;
  /// Sets impulses and velocities to where the next pair is to begin. Changes of velocities are weighed by the energy that they
  /// have: \f$f = (\sqrt m\,\Delta v, \sqrt{I_b}\,\Delta\omega_b)\f$ for each body.
  void extrapolate(const Island& island);

 private:
  void keep_velocities(const Island& island);

  AndersonAcceleration acceleration_;
  std::vector<MovingBody> before_;  // by the island's bodies: velocities at the start of the pair
  VecX change_;                     // f
  VecX impulses_;                   // PatchImpulses of its patches
};

}  // namespace tumble
