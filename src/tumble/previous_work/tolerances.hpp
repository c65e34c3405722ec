/// \file
/// \brief The small numbers of `previous_work`.
#pragma once

namespace tumble::tolerance {

// --- previous_work ------------------------------------------------------------------------

/// [-] How far a box on its own springs sinks in if the step allows it, as a share of its shortest edge. Reason: a
/// centimetre of a metre is hardly seen, and needs springs that eight substeps at 60 Hz can follow. (2.5.1)
inline constexpr double penalty_sag = 0.01;

/// [-] Stiffness of a contact point at most, as h² k over the mass that its bodies have there, each body divided among
/// its points. Reason: with the two limits below, stiffness + 2 (damping + friction) is 3.92, and above 4 a box at
/// rest gains energy. (2.5.1)
inline constexpr double penalty_stiffness = 0.12;

/// [-] Damping of a contact point at most, as h c over that mass. Reason: see penalty_stiffness; a box on four corners
/// of the stiffest springs is then just critically damped, which takes 1.386. (2.5.1)
inline constexpr double penalty_damping = 1.4;

/// [-] Share of its slip that a point ends in a substep, below Coulomb's limit. Reason: see penalty_stiffness; one half
/// creeps down slopes twice as fast as the most that is possible. (2.5.1)
inline constexpr double penalty_friction = 0.5;

/// [-] Stiffness of the explicit scheme, as a share of the stiffest for which no box gains energy. Reason: half of
/// it loses some in each swing. (2.5.1)
inline constexpr double penalty_explicit = 0.5;

/// [-] Residual at which Faure's iteration is done. Reason: the same as of Gauss-Seidel sweeps, with which it is
/// compared. (2.6.4)
inline constexpr double faure_residual = 1e-9;

/// [-] Step of Faure's iteration at which it ends before its budget, over the step from no impulses at all. Reason: a
/// millionth of what gravity adds in a step moves no box by a thousandth of its edge in an hour. (2.6.4)
inline constexpr double faure_small = 1e-6;

/// [-] Energy that bounces may add in a step, as a share of the sum of pushes times approaches; above it nothing bounces in that
/// step. Reason: the iteration ends at a millionth, and an elastic bounce must not count as a gain. (2.6.4)
inline constexpr double faure_gain = 1e-3;

/// [-] How far apart points are taken up, as a share of the shortest edge. Reason: farther away a contact area says little
/// about where two boxes will meet. (2.6.4)
inline constexpr double faure_reach = 0.5;

}  // namespace tumble::tolerance
