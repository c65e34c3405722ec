/// \file
/// \brief Exceptions of a step.
#include "tumble/dynamics/step_mistakes.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/tolerances.hpp"

#include <limits>
#include <string>

namespace tumble {

void refuse_step(std::string_view message) { throw StepRefused("tumble: " + std::string(message)); }

void require_step_limits(double dt, double time) {
  require::positive(dt, "dt");
  require::within(dt, tolerance::shortest_step, tolerance::longest_step, "dt");
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  if (dt * tolerance::step_share < rounding * time)
    refuse("dt = " + shortest_text(dt) + ": after " + shortest_text(time) +
           " s expected more than " + shortest_text(rounding * time / tolerance::step_share) +
           " s, since the time is not resolved further");
}

void require_resolved(double dt, double resolution) {
  require::positive(dt, "dt");
  if (dt + resolution <= dt)
    refuse_step("resolution = " + shortest_text(resolution) +
                ": expected more than rounding of a flight of " + shortest_text(dt) + " s");
}

}  // namespace tumble
