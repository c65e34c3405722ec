/// \file
/// \brief Slow collisions stick, so that bouncing comes to an end (thesis 4.3).
#include "tumble/contact/sticky.hpp"

#include "tumble/base/error.hpp"

#include <cmath>

namespace tumble {

double sticky_restitution(double restitution, double approach_speed, const StickyScale& scale,
                          const StickyOptions& options) {
  require::within(restitution, 0.0, 1.0, "restitution");
  require::finite(approach_speed, "approach_speed");
  require::not_negative(scale.gravity, "scale.gravity");
  require::positive(scale.size, "scale.size");
  require::positive(scale.dt, "scale.dt");
  require::not_negative(options.threshold, "options.threshold");
  require::not_negative(options.threshold_weightless, "options.threshold_weightless");

  bool sticks = false;
  switch (options.rule) {
    case StickyRule::off: break;
    case StickyRule::speed: {
      // V = sqrt(g L) is what a fall through L / 2 gives; without gravity V = L / dt.
      const double slow = scale.gravity > 0.0
                              ? options.threshold * std::sqrt(scale.gravity * scale.size)
                              : options.threshold_weightless * (scale.size / scale.dt);
      sticks = -approach_speed < slow;
      break;
    }
    case StickyRule::step_size:
      // Gravity ends the hop before the next step does: e |v| < g dt. Without gravity never.
      sticks = -approach_speed * restitution < scale.gravity * scale.dt;
      break;
  }
  return sticks ? 0.0 : restitution;
}

}  // namespace tumble
