/// \file
/// \brief Every technique of the library, run for comparison, and how its work is counted.
#pragma once

#include "tumble/record/run.hpp"

#include "driver/figure.hpp"
#include "driver/played_scene.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace tumble::chapters {

/// All techniques of the library, so that none can be forgotten.
///
/// Each has its standard options, but for chance, which is off: it would blur errors.
/// \return in the order of `tumble techniques`
std::vector<PlayedTechnique> compared_techniques();

/// The work of a technique, without the clock: everything that its reports count.
///
/// Sweeps, pivots, impulses, tests of pairs, bodies advanced and evaluations of searches, each as one.
/// \param report  of one step, or of several added up
/// \param pivot   [-] how many others a pivot counts for
/// \return [-] their sum
double work_of(const StepReport& report, double pivot = 1.0);

/// Runs a scene under a technique.
/// \param scene     the scene
/// \param played    the technique
/// \param dt        [s] the step
/// \param duration  [s] simulated time
/// \param after     called after each step, if given
/// \return what the run came to
/// \throws std::invalid_argument if the technique refuses the scene
RunResult run_compared(const Scene& scene, const PlayedTechnique& played, double dt,
                       double duration,
                       const std::function<void(const World&, const Metrics&)>& after = {});

/// A cell that holds no number.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The name of a number of a technique.
/// \param technique  as the library calls it
/// \param what       is measured
/// \return "technique: what"
std::string number_name(const std::string& technique, const std::string& what);

/// Adds a number unless there is none.
/// \param list   of a figure; in and out
/// \param name   of the number
/// \param unit   of the number
/// \param value  NaN adds nothing
void add_number(std::vector<Quantity>& list, std::string name, std::string unit, double value);

}  // namespace tumble::chapters
