/// \file
/// \brief The impulses of one contact patch, exact where it sticks (thesis 6.3.1).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"

namespace tumble {

/// Finds the impulses of one patch while those of all others stay, and applies the change. A Gauss-Seidel
/// sweep calls it for one patch after the other.
///
/// The conditions: no point ends slower than its target or pulls, only points at their targets push,
/// and friction stops the patch or is at its bound and against the motion:
/// \f[ 0 \le p_i \perp v_i - w_i \ge 0, \qquad
///     |F_t|^2 + \frac{(T - n\cdot(c\times F_t))^2}{r^2} \le \mu^2 N^2, \qquad
///     r = \frac{1}{N} \textstyle\sum_i p_i\,|s_i - c|, \f]
/// with N the sum of the p_i and c their centre, the centre of pressure. Force and moment share one bound:
/// were each free to reach its own, a box that spins would hold its place as if it did not.
///
/// **Sticking.** If one motion meets all targets, the impulse that brings it about is one product,
/// \f$\lambda + K^{-1}(w - u)\f$. It is the exact answer if no point has to pull for it and it is within the
/// bound of friction. **Otherwise** friction at the centre of pressure and pressure (of all points at once if
/// none pulls, else of each) are solved in turn, a few times.
///
/// **Skipped** is a patch that meets the conditions already, unless all of its points touch and it sticks.
/// Where several pressures carry the same load, or friction about the normal may be distributed among the
/// points in several ways, IslandSolver finds other impulses than these formulas, which would undo them.
/// \param patch       impulses in and out
/// \param first       its first body; changed
/// \param second      its second body; changed
/// \param iterations  how often friction and pressure are solved in turn if the patch does not stick; 0: it is left then
/// \param residual    [m/s] velocity error of a patch that is skipped; points that push may slide ten times as
///                    fast; 0: none is skipped
/// \return [m/s] the largest change of a velocity, or error_at_points() of a patch that was left
/// \see Box2D and its relatives solve points; solving patches is due to Baraff's remark on contact regions;
/// the common bound of force and moment is the ellipsoid of Howe and Cutkosky (1996).
double solve_patch(ContactPatch& patch, MovingBody& first, MovingBody& second, int iterations,
                   double residual = 0.0);

/// Restitution: sets the separation velocity of points that have an impulse and approached fast as their target,
/// Newton's \f$v_n \ge -e\,v_n^-\f$, and 0 for others with an impulse. Solving the patch again then
/// gives the remaining impulse, including friction.
/// \param slowest  [m/s] slower approaches do not bounce
/// \param patch    targets in and out
void require_separation(double slowest, ContactPatch& patch);

/// The overlap correction of a patch: displacements are found like velocities from impulses ("pseudo-impulses").
struct OverlapCorrection {
  SixBySix inverse_mass{};  ///< motion of a unit pseudo-impulse
  std::array<double, ContactPatch::kMostPoints>
      pushes{};  ///< [m kg] of its points so far, at least 0
};

/// Corrects a share of the overlap of a patch by displacing its bodies, whose "velocities" are their displacements.
/// \param share       [-] of the overlap, 0 to 1
/// \param correction  pushes in and out
/// \param first       displacement of the first body; changed
/// \param second      displacement of the second body; changed
/// \return [m] the largest change of a displacement
double correct_overlap(const ContactPatch& patch, double share, OverlapCorrection& correction,
                       MovingBody& first, MovingBody& second);

}  // namespace tumble
