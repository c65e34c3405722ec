/// \file
/// \brief What goes wrong in the listings DAMPENOBJECTS, FIXCONTACTCONSTRAINTS and
///        SETGEOMETRICALLYSTABLE, with numbers (thesis 4.4, 5.3, 5.4, A.2).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures of the errata DM1 to DM17 with X1 to X6, and G2 to G8.
/// \param list  gets "errata_damping" and "errata_stability"
void add_damping_errata_figures(std::vector<Figure>& list);

/// The errata of DAMPENOBJECTS and FIXCONTACTCONSTRAINTS, one at a time, as printed and mended.
///
/// Misprints are taken out of a listing in which all others are mended; what the author meant, and what
/// has a consequence that the reader should know, is compared with a cure of a few lines here.
/// \param settings  k1, eps10, cap, duration
/// \return tables "pivot", "fall", "energy", "path", "wall", "apex", "tilt", "gap" and "stack"; for each
///         erratum a number that shows the failure and the same number mended
Result measure_damping_errata(const Parameters& settings);

/// The errata of SETGEOMETRICALLYSTABLE, one at a time, as printed and mended.
/// \param settings  none
/// \return table "" (the boxes of each scene with what they are called); for each erratum how many
///         bodies are called stable, as printed and mended
Result measure_stability_errata(const Parameters& settings);

/// DM1 to DM5, DM8, DM13, DM15, DM16: what a step does to one body's momenta.
/// \param k1      [-] what a step in contact leaves of momentum
/// \param result  gets the numbers
void add_momentum_errata(double k1, Result& result);

/// DM6, DM7, DM10, DM11, DM12, DM14, DM17: motion over many steps.
/// \param k1      [-] what a step in contact leaves of momentum
/// \param eps10   [m] a move in a step that is undone
/// \param result  gets tables "pivot", "fall", "path", "wall", "apex", "tilt" and the numbers
void add_motion_errata(double k1, double eps10, Result& result);

/// DM9: components of angular momentum that are set to 0 add energy.
/// \param result  gets table "energy" and the numbers
void add_energy_erratum(Result& result);

/// X1 to X5, DM17: what pushes do to bodies.
/// \param cap     pushes after which a loop that does not end is left
/// \param result  gets table "gap" and the numbers
void add_repair_errata(int cap, Result& result);

/// X6: pushes go on while a stack rests and nothing is damped; with damping they may not.
/// \param duration  [s] of the run
/// \param result    gets table "stack" and the numbers
/// \throws std::runtime_error if a step of the run does not end as it should
void add_stack_erratum(double duration, Result& result);

}  // namespace tumble::chapters
