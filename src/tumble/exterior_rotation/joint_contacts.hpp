/// \file
/// \brief Contacts of bodies in joints (thesis 2.6.5): impacts, and forces that last for a step.
///
/// Uses the chapter on methods of chapter 2.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/exterior_rotation/runge_kutta.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/math/projected_descent.hpp"
#include "tumble/previous_work/rubbing_points.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Contact points of bodies that are held in joints: an impulse moves all that hangs together.
class HeldPoints final : public RubbingPoints {
 public:
  /// Whose joints hold.
  /// \param forces  made ready by JointForces::take(); has to live until the last use
  void hold(JointForces& forces) { forces_ = &forces; }

 private:
  void yield(std::span<Vec3> linear_w, std::span<Vec3> angular_w) override;

  JointForces* forces_ = nullptr;
  std::vector<Vec6> parts_;
};

/// A step of bodies in joints that meet others.
///
/// Contacts are auxiliary constraints, as in Baraff's paper: joints are held exactly by a solve in linear time, and contact points see bodies
/// through it. ProjectedDescent looks for impulses of all points at once, with friction; each of its steps takes such a solve.
/// That happens twice in a step of time:
/// 1. **Impacts.** Points that would meet in this step bounce by Newton's law at once, up to a step early; where bounces contradict each
///    other and would add energy, nothing bounces in this step.
/// 2. **Forces.** From the accelerations with the joints held alone follow velocities at the end. What points then lack is made up by forces
///    that last for the step, and RungeKutta moves the bodies with them.
///
/// Without contact that is RungeKutta's step with its order. With contact it is of order 1. Overlap is pushed out
/// slowly. Bodies that a joint joins pass through each other.
/// \par Cost
/// A solve of the joints for each step of the iteration, of which there are up to `kBudget` for each of the two.
/// \algorithm{Contacts of bodies in joints: section 2.6.5}
/// \deviation{Baraff solves for contact forces by pivoting\, with a column of a matrix from each contact; here the matrix is never formed.}
/// \verified{A chain that lies on the ground presses on it with its weight}
class JointContacts {
 public:
  static constexpr int kBudget = 60;  ///< steps of the iteration at most; warm starts carry it on

  /// A step.
  /// \param world   states in and out; its time does not change
  /// \param report  impulses, iterations, contacts and energy are added
  double step(const ButcherTable& table, double dt, std::span<const Joint> joints,
              JointForces& forces, World& world, StepReport& report);
  /// The contacts of the last step, with the impulses of its forces, sorted by id.
  [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }
  /// The contacts of the last step, with the impulses of its impacts; empty if nothing met.
  [[nodiscard]] std::span<const Contact> impacts() const { return impacts_; }

 private:
  void find(const World& world, double dt, StepReport& report);
  void bounce(double dt, std::span<const Joint> joints, JointForces& forces, World& world,
              StepReport& report);
  void press(double dt, std::span<const Joint> joints, JointForces& forces, const World& world,
             StepReport& report);
  void solve(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
             JointForces& forces, StepReport& report);

  BoundingTree near_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  ContactList contacts_, previous_, impacts_;
  HeldPoints points_;
  ProjectedDescent<RubbingPoints> iteration_;
  RungeKutta runge_kutta_;
  double last_dt_ = 0.0;       // [s] of the step before, or 0
  std::vector<double> least_;  // [m/s] of each point
  std::vector<MovingBody> before_, moving_;
  std::vector<Wrench> rates_, pushes_;
};

}  // namespace tumble
