/// \file
/// \brief The synchronised timewarp as its two listings are printed (thesis A.1).
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <string>

namespace tumble {

TimewarpAsPrinted::TimewarpAsPrinted(const TimewarpAsPrintedOptions& options)
    : options_(options), queries_(options) {
  require::that(options.cap >= 1, "cap = " + std::to_string(options.cap) + ": expected 1 or more");
}

std::string_view TimewarpAsPrinted::name() const {
  return options_.listing == TimewarpListing::simple ? "timewarp_simple" : "timewarp_safer";
}

StepReport TimewarpAsPrinted::step(World& world, double dt) {
  queries_.begin(world, dt, observer());
  passes_ = 0;
  if (options_.listing == TimewarpListing::simple)
    simple(world, dt);
  else
    safer(world, dt);
  return queries_.report;
}

// Whether the main loop has reached its cap; if not, counts another pass.
bool TimewarpAsPrinted::given_up() {
  if (passes_ >= options_.cap) {
    queries_.report.status = std::max(queries_.report.status, StepStatus::event_cap);
    return true;
  }
  ++passes_;
  return false;
}

// Saves the states that the last lines of the listing overwrite.
void TimewarpAsPrinted::main_loop_ended() {
  valid_times_ = queries_.valid_times;
  test_states_ = queries_.test;
}

}  // namespace tumble
