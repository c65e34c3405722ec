/// \file
/// \brief Runge and Kutta's methods for bodies in joints, with the forces found anew at each stage
///        (footnote of thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The coefficients of an explicit method.
struct ButcherTable {
  static constexpr int kMostStages = 7;  ///< of Dormand and Prince

  int stages = 1;  ///< how often forces are found in a step
  int order = 1;   ///< of the answer
  std::array<std::array<double, kMostStages>, kMostStages> a{};  ///< [-] of stages, row by row
  std::array<double, kMostStages> b{};                           ///< [-] of the answer
  std::array<double, kMostStages> error{};  ///< [-] of its difference from one of lower order
};

/// The midpoint rule: forces at the start and half a step later. Order 2.
/// \return two stages
const ButcherTable& midpoint_table();

/// The classical method. Order 4.
/// \return four stages
/// \see Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
const ButcherTable& classical_table();

/// Order 5, with an estimate of its error by one of order 4.
/// \return seven stages
/// \see Dormand, Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6, 1980.
const ButcherTable& dormand_prince_table();

/// Steps of a group of bodies in joints.
///
/// The unknowns of a body are its centre x, the rotation vector r from its orientation at the start of
/// the step, and both momenta:
/// \f[ \dot x = P/m, \quad \dot r = \operatorname{rate}(r, \omega), \quad \dot P = m g + F, \quad
///     \dot L = \tau , \f]
/// with rotation_vector_rate() and joint forces of JointForces at the pose and velocity of the stage. A
/// rotation vector makes stages linear, so an orientation never has to be brought back to length 1.
/// \par Cost
/// One solve of the joints in each stage.
/// \see Munthe-Kaas, "Runge-Kutta methods on Lie groups", BIT 38, 1998.
/// \algorithm{Runge and Kutta with contact forces at each stage: section 6.2, footnote}
/// \verified{Orders of the glued column are 1, 1, 1, 2 and 4}
class RungeKutta {
 public:
  /// One step of all movable bodies.
  /// \param table   the method
  /// \param dt      [s] above 0, shorter than a turn of every body
  /// \param joints  what is held during the step
  /// \param forces  finds the forces
  /// \param world   states in and out; time is not counted
  /// \return [-] the estimate of the error, the largest over bodies of position over shortest edge, of
  ///         angle, and of the momenta's velocities over \f$\sqrt{gL}\f$ (L/dt without gravity) and that
  ///         over L; 0 for a table without an estimate. Infinite if a body would turn by a full turn
  ///         or more, or go where numbers end: the states are then as before
  double step(const ButcherTable& table, double dt, std::span<const Joint> joints,
              JointForces& forces, World& world);

 private:
  // The rates of a body's unknowns, or the unknowns' changes.
  struct Rate {
    Vec3 x_w = Vec3::Zero();
    Vec3 r_w = Vec3::Zero();
    Vec3 p_w = Vec3::Zero();
    Vec3 l_w = Vec3::Zero();
  };
  void change(const std::array<double, ButcherTable::kMostStages>& weights, int stages, double dt,
              std::vector<Rate>& out) const;

  std::vector<BodyState> start_;
  std::array<std::vector<Rate>, ButcherTable::kMostStages> slopes_;
  std::vector<Rate> change_;
  std::vector<MovingBody> moving_;
  std::vector<Wrench> wrenches_;
};

}  // namespace tumble
