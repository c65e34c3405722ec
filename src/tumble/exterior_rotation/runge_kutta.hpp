/// \file
/// \brief Runge-Kutta methods for bodies in joints, with joint forces computed at each stage
///        (footnote of thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The coefficients of an explicit Runge-Kutta method.
struct ButcherTable {
  static constexpr int kMostStages = 7;  ///< those of Dormand and Prince

  int stages = 1;  ///< evaluations of forces in a step
  int order = 1;   ///< of the result
  std::array<std::array<double, kMostStages>, kMostStages> a{};  ///< [-] of stages, row by row
  std::array<double, kMostStages> b{};                           ///< [-] of the result
  std::array<double, kMostStages> error{};  ///< [-] difference from a result of lower order
};

/// The midpoint rule: forces at the start and half a step later. Order 2.
/// \return two stages
const ButcherTable& midpoint_table();

/// The classical method. Order 4.
/// \return four stages
/// \see Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", 1901.
const ButcherTable& classical_table();

/// Order 5, with an error estimate from order 4.
/// \return seven stages
/// \see Dormand, Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6, 1980.
const ButcherTable& dormand_prince_table();

/// Integrator for a group of bodies in joints.
///
/// The unknowns of a body are its centre x, the rotation vector r from its orientation at the start of
/// the step, and both momenta:
/// \f[ \dot x = P/m, \quad \dot r = \operatorname{rate}(r, \omega), \quad \dot P = m g + F, \quad
///     \dot L = \tau , \f]
/// with rotation_vector_rate() and joint forces of JointForces at the pose and velocity of the stage. With
/// rotation vectors the stages are linear, so no orientation has to be normalised.
/// \par Cost
/// One solve of the joints in each stage.
/// \see Munthe-Kaas, "Runge-Kutta methods on Lie groups", BIT 38, 1998.
/// \algorithm{Runge and Kutta with contact forces at each stage: section 6.2, footnote}
/// \verified{Orders of the glued column are 1, 1, 1, 2 and 4}
class RungeKutta {
 public:
  /// One step of all movable bodies.
  /// \param dt      [s] above 0, shorter than a turn of every body
  /// \param world   states in and out; its time does not change
  /// \param pushes  forces, and torques about the centres, that last for all of the step, by index; empty: none
  /// \return [-] error estimate, the largest over bodies of position over shortest edge, of angle, and of
  ///         the momenta's velocities over \f$\sqrt{gL}\f$ (L/dt without gravity) and that over L; 0 for a
  ///         table without an estimate. Infinite if a body would make a full turn or more, or its state
  ///         become infinite: the states are then unchanged
  double step(const ButcherTable& table, double dt, std::span<const Joint> joints,
              JointForces& forces, World& world, std::span<const Wrench> pushes = {});

 private:
  // The rates of a body's unknowns, or their changes.
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
