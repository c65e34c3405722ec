/// \file
/// \brief Joint forces: one linear system for a group of bodies that stick together (thesis 6.2).
///
/// Uses the chapter on methods of chapter 2.
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/exterior_rotation/joint.hpp"
#include "tumble/math/dense.hpp"
#include "tumble/previous_work/joint_tree.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Solver for joint forces: forces that keep the relative acceleration 0, or impulses that end a
/// relative velocity.
///
/// Each joint has rows of a matrix J for the relative velocity of its two sides: three for the
/// held point, two more for an edge (rotation across it), or three more for an area. With W the inverse
/// masses and inertias, the accelerations are \f$a = W(f + J^{\mathsf T}\lambda)\f$, and the multipliers
/// follow from
/// \f[ J W J^{\mathsf T}\,\lambda = -(J\,W f + \dot J v), \f]
/// where \f$\dot J v\f$ contains the centripetal terms \f$\omega\times(\omega\times r)\f$. The rows are
/// equality constraints of the complementarity problem of the contact forces: the sign of a joint force is
/// free. Joints without loops are solved by JointTree. Loops are auxiliary constraints: each of their rows takes a solve, and
/// what they give way to each other is a dense matrix. It is singular where joints are redundant (a ring of boxes): joints between bodies that
/// others already unite, and rows that depend on earlier ones, get no force; the accelerations are
/// the same.
/// \par Cost
/// O(n) for n joints without loops, and O(n k + k³) with k rows of joints that close loops.
/// \algorithm{Forces in joints that stick: section 6.2}
/// \verified{Pivot forces of the glued column are those of the closed form}
class JointForces {
 public:
  /// Computes forces that keep all joints closed.
  /// \param world   masses, inertias, gravity
  /// \param bodies  their present motion, one for each body index
  /// \param rates   receives force and torque of gravity, joints and pushes, one for each index
  /// \param pushes  other forces, and torques about the centres, one for each index; empty: none
  void hold(const World& world, std::span<const MovingBody> bodies, std::span<const Joint> joints,
            std::vector<Wrench>& rates, std::span<const Wrench> pushes = {});

  /// Computes and applies impulses that end all relative motion in the joints.
  ///
  /// \f$v \leftarrow v - W J^{\mathsf T}(J W J^{\mathsf T})^{-1} J v\f$: the nearest velocities that the joints
  /// permit, in the norm of kinetic energy.
  /// \param bodies  velocities in and out, one for each body index
  void project(std::span<MovingBody> bodies, std::span<const Joint> joints,
               std::span<const BodyState> states);

  /// Moves bodies together again that errors of steps have moved apart in joints of the scene: one step of Newton's
  /// method, which moves them least in the norm of project().
  /// \param joints  all joints; others than the scene's get no gap by that
  /// \param world   poses in and out; momenta stay
  void close(std::span<const Joint> joints, World& world);

  /// Makes ready for respond().
  void take(std::span<const MovingBody> bodies, std::span<const Joint> joints,
            std::span<const BodyState> states);
  /// What impulses change of the velocities of bodies in joints: \f$(W - W J^{\mathsf T}(J W J^{\mathsf T})^{-1} J W)\,p\f$.
  /// \param parts  [N s], [N m s] of each body; then [m/s], [rad/s]. 0 for immovable bodies
  void respond(std::span<Vec6> parts);

  /// The wrench of a joint on its second body in the last call.
  /// \return [N], [N m] about held_point(), or [N s], [N m s]; 0 if nothing is held
  [[nodiscard]] const Wrench& on_second(int joint) const {
    return pushes_[static_cast<std::size_t>(joint)];
  }
  /// Number of systems solved since construction.
  [[nodiscard]] int solves() const { return solves_; }

 private:
  // A row: along · (u_second - u_first) + turn_second · ω_second - turn_first · ω_first.
  struct Row {
    int joint = 0;
    int first = 0;
    int second = 0;
    JointPoint point;  // the held point
    Vec3 along_w = Vec3::Zero();
    Vec3 about_w = Vec3::Zero();  // axis of a row that holds an angle
    Vec3 turn_first_w = Vec3::Zero();
    Vec3 turn_second_w = Vec3::Zero();
  };
  void assemble(std::span<const MovingBody> bodies, std::span<const Joint> joints,
                std::span<const BodyState> states);
  void collect(std::span<const MovingBody> bodies);
  void factor(std::span<const MovingBody> bodies);
  void solve(std::span<const MovingBody> bodies);
  void factor_loops(std::span<const MovingBody> bodies);
  void find_loop_forces();
  void solve_tree();
  void apply(const Row& row, double factor);
  [[nodiscard]] double seen_by(const Row& row) const;

  std::vector<Row> rows_;   // joint by joint
  std::vector<char> ties_;  // by joint: it unites two bodies for good
  std::vector<double> b_;   // by row; in: relative motion to be ended; out: multipliers
  std::vector<int> sets_;   // storage of BodySets

  JointTree tree_;
  std::vector<JointRows> blocks_;  // by joint with rows; those that tie first
  std::vector<std::size_t> at_;    // by block: its first row
  std::vector<int> loop_rows_;     // rows of joints that close loops
  std::vector<Vec6> body_part_, joint_part_;
  std::vector<MovingBody> closing_;
  std::vector<char> immovable_;  // by body
  double scale_ = 1.0;           // [kg] of A_
  MatX A_;                       // of the rows of loops
  std::vector<double> answer_;   // of the independent ones
  SubsetCholesky factor_;
  std::vector<Wrench> pushes_;
  int solves_ = 0;
};

}  // namespace tumble
