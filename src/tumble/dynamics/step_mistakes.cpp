/// \file
/// \brief Exceptions of a step.
#include "tumble/dynamics/step_mistakes.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"

#include <string>

namespace tumble {

void refuse_step(std::string_view message) { throw StepRefused("tumble: " + std::string(message)); }

void require_resolved(double dt, double resolution) {
  require::positive(dt, "dt");
  if (dt + resolution <= dt)
    refuse_step("resolution = " + shortest_text(resolution) +
                ": expected more than rounding of a flight of " + shortest_text(dt) + " s");
}

}  // namespace tumble
