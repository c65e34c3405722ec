/// \file
/// \brief Every technique of the library, run for comparison, and how its work is counted.
#pragma once

#include "tumble/record/run.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// All techniques of the library, so that none can be forgotten.
//
// Each has its standard options, but for chance, which is off: it would blur errors.
std::vector<PlayedTechnique> compared_techniques();

// The work of a technique, without the clock: everything that its reports count.
//
// Sweeps, pivots, impulses, tests of pairs, bodies advanced and evaluations of searches, each as one.
// pivot: [-] how many others a pivot counts for
// Returns [-] their sum
double work_of(const StepReport& report, double pivot = 1.0);

// Runs a scene under a technique.
// dt: [s] the step
// duration: [s] simulated time
RunResult run_compared(const Scene& scene, const PlayedTechnique& played, double dt,
                       double duration,
                       const std::function<void(const World&, const Metrics&)>& after = {});

// A cell that holds no number.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// The name of a number of a technique.
std::string number_name(const std::string& technique, const std::string& what);

// Adds a number unless there is none.
void add_number(std::vector<Quantity>& list, std::string name, std::string unit, double value);

}  // namespace tumble::chapters
