/// \file
/// \brief The pass that ends overlap by moving bodies: the energy that it adds, and how much it is
///        left to do (thesis 4.4).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Energy of a stack whose boxes overlap, within a second after the pass and without it.
///
/// The cubes lie at rest, each pressed into what is below it by a random depth. Once the listing's
/// pass has pushed them up, once OverlapRepair has moved them, once nothing has. Then damped
/// integration goes on for a second without any further pass. The kinetic energy that appears
/// because of the pass is the largest difference to the run without one within that second. Beside
/// it, with shock propagation by impulses, which the pass takes the place of, and no damping.
/// \param settings  boxes, restitution, depth, seeds
/// \return table "": energies of the first stack over time; table "depth": kinetic over potential
///         energy against the depth; the ratio at the depth asked for
Result measure_push_energy(const Parameters& settings);

/// How much overlap the pass removes in runs of damped integration.
///
/// In each step three numbers are summed over all pairs: the overlap that there would be if no
/// impulse had acted in it, the overlap that the pass finds, and the overlap that it leaves. A pair
/// counts with its deepest point.
/// \param settings  per_edge, restitution, duration, seeds
/// \return table "": the sums by tenths of a second for the heap; what the pass removes over
///         what there would be, for a heap and for a stack; that taking the pass out of the step to
///         look before it changes nothing
Result measure_overlap_left(const Parameters& settings);

}  // namespace tumble::chapters
