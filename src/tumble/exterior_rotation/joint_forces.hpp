/// \file
/// \brief The forces in joints: one linear system for a group of bodies that stick (thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/exterior_rotation/joint.hpp"
#include "tumble/math/dense.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Finds what holds joints together: forces that keep the relative acceleration 0, or impulses that
/// end a relative velocity.
///
/// Each joint has rows of a matrix J that tell the relative velocity of its two sides: three for the
/// held point, two more for an edge (turning across it), or three more for an area. With W the inverse
/// masses and inertias, the accelerations are \f$a = W(f + J^{\mathsf T}\lambda)\f$, and the multipliers
/// follow from
/// \f[ J W J^{\mathsf T}\,\lambda = -(J\,W f + \dot J v), \f]
/// where \f$\dot J v\f$ has the terms \f$\omega\times(\omega\times r)\f$ of points on arcs. These are rows
/// that are equalities in the complementarity problem of the contact forces: nothing asks whether a
/// joint pulls. The matrix is singular where joints are redundant (a ring of boxes): joints between bodies
/// that others make one, and rows that depend on those before them, get no force, and the accelerations
/// do not care.
/// \par Cost
/// O(n³) for n rows, 18 of the glue in a column of four boxes and five of the edge under it.
/// \algorithm{Forces in joints that stick: section 6.2}
/// \verified{Pivot forces of the glued column are those of the closed form}
class JointForces {
 public:
  /// Forces that keep all joints from accelerating apart.
  /// \param world   masses, inertias, gravity
  /// \param bodies  how they move now, one for each body index
  /// \param joints  what is held
  /// \param rates   gets what acts on each body, gravity and joints, one for each index
  void hold(const World& world, std::span<const MovingBody> bodies, std::span<const Joint> joints,
            std::vector<Wrench>& rates);

  /// Impulses that end all relative motion in the joints.
  ///
  /// \f$v \leftarrow v - W J^{\mathsf T}(J W J^{\mathsf T})^{-1} J v\f$: the nearest velocities that the joints
  /// allow, in the measure of kinetic energy.
  /// \param bodies  velocities in and out, one for each body index
  /// \param joints  what is held
  /// \param states  of the bodies, for where joints are
  void project(std::span<MovingBody> bodies, std::span<const Joint> joints,
               std::span<const BodyState> states);

  /// What a joint exerted in the last call, on its second body.
  /// \param joint its place
  /// \return [N], [N m] about held_point(), or [N s], [N m s]; 0 for nothing held
  [[nodiscard]] const Wrench& on_second(int joint) const {
    return pushes_[static_cast<std::size_t>(joint)];
  }
  /// How many systems were solved since the object was made.
  /// \return from 0
  [[nodiscard]] int solves() const { return solves_; }

 private:
  // A row: along · (u_second - u_first) + turn_second · ω_second - turn_first · ω_first.
  struct Row {
    int joint = 0;
    int first = 0;
    int second = 0;
    JointPoint point;  // that is held
    Vec3 along_w = Vec3::Zero();
    Vec3 about_w = Vec3::Zero();  // of a row that holds an angle
    Vec3 turn_first_w = Vec3::Zero();
    Vec3 turn_second_w = Vec3::Zero();
  };
  void assemble(std::span<const MovingBody> bodies, std::span<const Joint> joints,
                std::span<const BodyState> states);
  void solve(std::span<const MovingBody> bodies);

  std::vector<Row> rows_;
  MatX A_;
  std::vector<double> b_;       // in: what has to be ended; out: multipliers
  std::vector<double> answer_;  // of the rows that are independent
  SubsetCholesky factor_;
  std::vector<Wrench> pushes_;
  int solves_ = 0;
};

}  // namespace tumble
