/// \file
/// \brief Slow collisions stick, so that bouncing comes to an end (thesis 4.3).
#pragma once

#include "tumble/contact/tolerances.hpp"

#include <cstdint>

namespace tumble {

/// Criterion by which a collision counts as slow.
enum class StickyRule : std::uint8_t {
  off,       ///< never: a bouncing body makes infinitely many collisions in finite time
  speed,     ///< the bodies approach slower than a share of sqrt(g L): independent of the step
  step_size  ///< the bodies would part slower than gravity's g dt of one step
};

/// When a collision sticks.
struct StickyOptions {
  StickyRule rule = StickyRule::speed;  ///< by which it counts as slow
  /// [-] speed: approaches slower than this share of sqrt(g L) stick
  double threshold = tolerance::sticky_speed;
  /// [-] the same where there is no gravity, as a share of L / dt
  double threshold_weightless = tolerance::sticky_speed_weightless;
};

/// What a collision happens among.
struct StickyScale {
  double gravity = 9.81;  ///< [m/s²] its magnitude, at least 0
  double size = 1.0;      ///< [m] L, the shortest edge of the smaller of the two boxes, above 0
  double dt = 1.0 / 60;   ///< [s] the time step, above 0
};

/// The restitution of a collision once slow ones stick.
///
/// A body that comes to rest by bouncing with restitution e makes infinitely many collisions in the
/// finite time \f$\sqrt{2h/g}\,(1+e)/(1-e)\f$, and each costs a step of its own. A collision below
/// a speed where it is still seen, but small, is therefore made perfectly *inelastic*: the bodies
/// stick, and a resting contact is left. (The thesis says that such a collision is treated
/// as elastic, in 4.3 and again in 5.2. That is a misprint: an elastic one never ends, and
/// the same sentence has the bodies stick.)
///
/// The threshold has no unit, so that small and large boxes come to rest alike: the speed scale
/// \f$\sqrt{g L}\f$ is that of a fall through half the box's own size. Where there is no gravity,
/// nothing brings the bodies together again; the scale is then L / dt, one size in a step.
/// \param approach_speed  [m/s] n·(v_second - v_first) before the collision; below 0 they approach
/// \return [-] 0 if the collision sticks, else the restitution as given
/// \throws std::invalid_argument naming the value that is not finite or out of range
/// \algorithm{Sticky collisions: section 4.3}
/// \verified{A ball sticks at its 5th or 32nd collision when rebounds below g dt stick}
[[nodiscard]] double sticky_restitution(double restitution, double approach_speed,
                                        const StickyScale& scale, const StickyOptions& options);

}  // namespace tumble
