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

/// [-] Restitution that a contact may miss without a note. Reason: the step misses that of the springs' law by as much. (2.5.1)
inline constexpr double penalty_bounce = 0.01;

/// [-] Residual at which Faure's iteration is done. Reason: the same as of Gauss-Seidel sweeps, with which it is
/// compared. (2.6.4)
inline constexpr double faure_residual = 1e-9;

/// [-] Step of Faure's iteration at which it ends before its budget, over the step from no impulses at all. Reason: a
/// millionth of what gravity adds in a step moves no box by a thousandth of its edge in an hour. (2.6.4)
inline constexpr double faure_small = 1e-6;

/// [-] Energy that bounces may add in a step, as a share of the sum of pushes times approaches; above it nothing bounces in that
/// step. Reason: the iteration ends at a millionth, and an elastic bounce must not count as a gain. (2.6.4, 2.7.2)
inline constexpr double faure_gain = 1e-3;

/// [-] How far apart points are taken up, as a share of the shortest edge. Reason: farther away a contact area says little
/// about where two boxes will meet. (2.6.4)
inline constexpr double faure_reach = 0.5;

/// [-] How far apart points are taken up by relaxation, as a share of the shortest edge. Reason: passes move points by
/// less than this, and farther ones would not be used. (2.3)
inline constexpr double relaxation_reach = 0.05;

/// [-] Determinant of the deformation of a box of rods, over that of a sound one, at which it counts as flat. Reason: rods hold all but a
/// few per cent of it; below a thousandth no rotation is near. (2.3)
inline constexpr double flat_box = 1e-3;

/// [-] Change of a rotation matrix at which its refinement ends. Reason: the next change is the square of
/// it, below rounding. (2.3)
inline constexpr double fitted_box = 1e-9;

/// [-] Pivot of a joint's block, over its diagonal, at which its rows depend on one another. Reason: a hundred
/// roundings; arms ten million times as long as a body leave as little. (2.6.5)
inline constexpr double dependent_joint = 1e-14;

/// [-] Step of the iteration of settling at which a quadratic program is solved, over the one from no forces. Reason: bodies that
/// rest then move by a ten millionth of the reach. (2.7.1)
inline constexpr double settling_step = 1e-9;

/// [-] How far a corner moves in a round, over the shortest edge, at which poses are found. Reason: a ten thousandth of
/// an edge is not seen, and the next round would move the square of it. (2.7.2)
inline constexpr double optimised_still = 1e-4;

/// [-] Step of the iteration at which a program is solved, over the one from no forces. Reason: with ten times as much heaps do
/// not come to an end within the rounds at steps of a quarter of a second. (2.7.2)
inline constexpr double optimised_step = 1e-5;

/// [-] How fast a point that pushes may leave, over the fastest point, for the answer of an iteration with friction to count. Reason: one that
/// has ended at its budget leaves a thousandth; where friction and pushes drive each other up, a third. (2.7.2)
inline constexpr double optimised_lift = 0.1;

/// [-] Energy of its spin that a body may gain in a step since it is turned aside. Reason: what a run may gain before it is
/// reported; bodies that roll and tumble over edges gain and lose less. (2.7.2)
inline constexpr double optimised_spin_up = 0.01;

/// [-] The same for a body that flies. Reason: turns by a radian let its energy oscillate by up to 0.06. (2.7.2)
inline constexpr double optimised_flight = 0.1;

/// [-] Gap up to which points touch, over the shortest edge. Reason: ten times what the poses may miss. (2.7.2)
inline constexpr double optimised_touch = 1e-3;

/// [-] Slip that has stopped, over the velocity at the start of an impact. Reason: a straight line that ends at no slip leaves
/// some roundings. (2.5.2)
inline constexpr double impact_still = 1e-12;

/// [-] Slip below which its direction is kept, over the slip at the start of an impact. Reason: it hardly turns any more,
/// and the impulse until it stops is as small. (2.5.2)
inline constexpr double impact_slow = 1e-6;

/// [-] Turning of slip that counts as none, over the change of the velocity. Reason: in a plane of symmetry only rounding
/// turns it. (2.5.2)
inline constexpr double impact_straight = 1e-13;

/// [-] Share of itself by which slip may change, or angle [rad] by which it may turn, in a step of the integration. Reason: with a
/// thirty-second part of it an impulse has six right digits and mostly eight. (2.5.2)
inline constexpr double impact_turn = 0.03125;

/// [-] How closely the end of a phase is found, over the length of the step. Reason: some roundings. (2.5.2)
inline constexpr double impact_root = 1e-15;

/// [-] Slowest rebound of bodies in contact, as a share of sqrt(g L), L the shortest movable edge. Reason: a box of 1 m then hops
/// by a twentieth of a millimetre, 156 times a second; a tenth of it takes ten times as many. (2.5.2)
inline constexpr double microcollision = 0.01;

/// [-] Velocities of two points that are the same, over their size. Reason: far above rounding; a spin that is slower
/// stops no later than in a thousand million hops. (2.5.2)
inline constexpr double same_velocity = 1e-9;

}  // namespace tumble::tolerance
