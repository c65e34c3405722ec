/// \file
/// \brief Impulses of one contact area, exact where it sticks (thesis 6.3.1).
#pragma once

#include "tumble/contact_damped/contact_patch.hpp"

namespace tumble {

/// Finds the impulses of one area while those of all others stay, and applies the change.
///
/// What is asked for: no point ends slower than its target (apart) or pulls, the two go together,
/// and friction stops the area or is at its bound and against the motion:
/// \f[ 0 \le p_i \perp v_i - w_i \ge 0, \qquad
///     |F_t|^2 + \frac{(T - n\cdot(c\times F_t))^2}{r^2} \le \mu^2 N^2, \qquad
///     r = \frac{1}{N} \textstyle\sum_i p_i\,|s_i - c|, \f]
/// with N the sum of the p_i and c their centre, the centre of pressure. Force and moment share one bound:
/// were each free to reach its own, a box that spins would hold its place as if it did not.
///
/// **Sticking.** If one motion meets all targets, the impulse that brings it about is one product,
/// \f$\lambda + K^{-1}(w - u)\f$. It is the answer, and exact, if the pressure that it asks for
/// pulls nowhere and friction bears the rest. **Otherwise** friction at the centre of pressure and
/// pressure (of all points at once if none pulls, else of each) are solved in turn, a few times over.
/// \param block   the area; impulses in and out
/// \param first   the first body; changed
/// \param second  the second body; changed
///
/// **Left alone** is an area that is right as it is, unless all of it touches and sticks. Where several
/// pressures carry the same, and where friction that turns may be shared out among points, IslandSolver
/// finds others than these formulas, and theirs would undo them.
/// \param rounds  how many times the parts are solved in turn, if it does not stick, at least 1
/// \param rest    [m/s] wrong velocity at a point that is left alone in an area that rests; it may creep ten
///                times as fast; 0: none
/// \return [m/s] the largest velocity that was corrected
/// \see Box2D and its heirs solve points; solving areas is due to Baraff's remark on contact regions;
/// the common bound of force and moment is the ellipsoid of Howe and Cutkosky (1996).
double solve_patch(ContactPatch& block, MovingBody& first, MovingBody& second, int rounds,
                   double rest = 0.0);

/// Asks the points of an area that were pushed and had approached fast to part: Newton's restitution,
/// \f$v_n \ge -e\,v_n^-\f$; others that were pushed keep from approaching. Solving the area again then
/// gives the rest of the impulse, friction with it.
/// \param slowest  [m/s] approaches slower than this do not bounce
/// \param block    the area; targets in and out
void require_separation(double slowest, ContactPatch& block);

/// Ends a share of the overlap of an area's points by moving its bodies apart, as an impulse would in a
/// unit of time: "velocities" are the moves of this step.
/// \param block   the area, after begin_lift(); `lift` of its points in and out
/// \param slop    [m] overlap that is left
/// \param share   [-] of the rest that is to go, 0 to 1
/// \param first   moves of the first body; changed
/// \param second  moves of the second body; changed
/// \return [m] the largest move that was corrected
double lift_patch(ContactPatch& block, double slop, double share, MovingBody& first,
                  MovingBody& second);

}  // namespace tumble
