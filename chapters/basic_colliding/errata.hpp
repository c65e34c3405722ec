/// \file
/// \brief The parts of measure_event_search_errata(): each adds its tables and numbers.
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// S5: only the end of a step is tested, and bodies pass through one another.
/// \param result  gets tables "pass_literal" and "pass_mended" and two numbers
void add_pass_erratum(Result& result);

/// S6 and S7: nothing says that a search gets any further than the one before.
/// \param cap     impacts in a step at which the literal reading is stopped
/// \param result  gets tables "flights_..." and "side_...", literal and mended, and their numbers
void add_progress_errata(int cap, Result& result);

/// S8: a step of Euler's method cut in two is not the step.
/// \param result  gets table "fall" and the numbers
void add_flow_erratum(Result& result);

/// S9: impacts at one time are resolved in the order in which a heap happens to hold them.
/// \param result  gets table "landing" and the numbers
/// \throws std::runtime_error if the landing has no four contact points
void add_tie_erratum(Result& result);

}  // namespace tumble::chapters
