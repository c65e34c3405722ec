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

}  // namespace tumble::tolerance
