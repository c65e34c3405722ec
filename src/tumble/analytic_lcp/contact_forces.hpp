/// \file
/// \brief The forces between bodies that rest on each other, at one instant (thesis 2.6, 3.3.1).
///
/// Uses the chapter on geometric stability.
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/analytic_lcp/friction_lemke.hpp"
#include "tumble/analytic_lcp/friction_pyramid.hpp"
#include "tumble/analytic_lcp/held_bodies.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/islands.hpp"

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// The solvers that can be chosen: all but enumeration, which takes eight contacts at most.
std::vector<Word<std::string>> contact_solver_words();

/// How contact forces are found.
struct ContactForceOptions {
  std::string solver = "augmented_lagrangian";  ///< of problems without friction, by name
  bool friction = true;                         ///< Coulomb's, or none
  int directions = 8;                           ///< of the pyramid of friction: 4 or 8
  StableRule stable_boxes = StableRule::off;    ///< bodies left out; without friction only
};

/// What the forces are to bring about, and for how long they will act.
struct ForceAim {
  double dt = 1.0 / 60.0;  ///< [s] the time step
  /// [s] in which speeds that should be 0 are to become it
  double relaxation = 1.0 / 60.0;
  double duration = 1.0 / 60.0;  ///< [s] how long the forces will act
  /// Whether the contacts bring the pushes of the start of this flight along. A point that stuck
  /// then does so in the middle too, whatever the speed that the error of half a step gave it
  bool midway = false;
};

/// What was found.
struct ForceReport {
  LcpStatus status = LcpStatus::solved;  ///< anything else: see unsolved()
  int without_solution = 0;              ///< islands that took a VelocityStep
  /// Whether an island with friction was above FrictionLemkeSolver::kMostUnknowns: the forces are of no use
  bool too_large = false;
  int pivots = 0;                    ///< of all solvers
  int unknowns = 0;                  ///< points whose normal force was looked for
  int stable = 0;                    ///< movable bodies that were left out
  std::int64_t multiplications = 0;  ///< of the solvers
  /// [s] from now until the first sliding point comes to rest; infinity: none does
  double slip_ends = std::numeric_limits<double>::infinity();
};

/// Finds contact forces, island by island.
///
/// **Without friction** a row of ContactProblem for every point, and one solution that is exact. Speeds
/// that should be 0 and are not quite, since the last flight was not exact, are led there: with the
/// normal speed v, the gap d and the time T of relaxation, row i asks for
/// \f$a_i \ge -(v_i + v_c)/T\f$, where v_c, in proportion to d > 0, lets a gap close.
///
/// **With friction** that solution is looked at first. Where no point that is pushed slides, and
/// none would begin to, it is one with friction too: what stands needs no friction. Else the
/// problem of FrictionPyramid is solved: points that slide have friction against their sliding,
/// the others may stick. A point that is about to slide faster than it does has it against the way it would
/// go without friction: for one point that is the law that is implicit in time. The direction of the start
/// would throw a slow slider from side to side.
///
/// **Stable boxes** can be left out of problems without friction (HeldBodies): contacts among them
/// then have no force. With friction that is refused, since a box that is dragged along drags a stable
/// one.
///
/// **Where no forces are found for friction** the island takes a VelocityStep over the whole
/// duration, and its impulses are spread over that time. Mostly there are none (Painlevé's paradox:
/// Lemke's method ends on a ray); seldom rounding has kept the method from them.
///
/// Every answer is checked: one whose residual exceeds tolerance::force_residual counts for nothing.
class ContactForces {
 public:
  /// Makes the solvers.
  /// \throws std::invalid_argument for a solver or a number of directions that there is not, or for
  ///         stable boxes with friction
  explicit ContactForces(const ContactForceOptions& options);

  /// Finds the forces.
  /// \param contacts  points that rest, with approach speeds of now. Impulses in: those of an earlier
  ///                  instant, where to start from; out: force times aim.duration; 0 between bodies
  ///                  that are left out
  /// \return what was found; not solved: forces of no use
  /// \throws std::invalid_argument for contacts that ContactProblem refuses
  ForceReport solve(const World& world, std::span<const MovingBody> bodies,
                    std::span<Contact> contacts, const ForceAim& aim);

  /// What the forces do to the bodies: one for each body index.
  [[nodiscard]] std::span<const Wrench> wrenches() const { return wrenches_; }

  /// How bodies accelerate under gravity and these forces: one for each body index.
  [[nodiscard]] std::span<const Acceleration> accelerations() const { return total_; }

  /// The bodies that are left out as stable, as of the last solve().
  [[nodiscard]] const HeldBodies& held() const { return held_; }

  /// The problem of the last solve(), if it was not solved.
  [[nodiscard]] const LcpProblem& unsolved() const { return unsolved_; }

 private:
  // A point of an island with what friction asks about it.
  struct Point {
    Vec3 velocity_w = Vec3::Zero();  // [m/s] second body against first
    Vec3 push_w = Vec3::Zero();      // [N] on the second body
    bool slides = false;
  };
  // What all parts of one call need.
  struct Task {
    const World* world = nullptr;
    std::span<const MovingBody> bodies;
    ForceAim aim;
  };

  void load(const Task& task, std::span<const Contact> contacts, std::span<const int> which);
  bool solve_normals(ForceReport& report);
  [[nodiscard]] bool needs_friction(const Task& task) const;
  bool solve_friction(const Task& task, ForceReport& report);
  bool take_velocity_step(const Task& task, ForceReport& report);
  void apply_pushes(const Task& task, std::span<const int> members);
  [[nodiscard]] Vec3 slip_direction_w(const Task& task, int row) const;
  [[nodiscard]] Vec3 drift_w(const Task& task, int row, std::span<const Acceleration> of) const;
  void find_end_of_slip(const Task& task, ForceReport& report) const;
  void store(const Task& task, std::span<Contact> contacts, std::span<const int> which);

  ContactForceOptions options_;
  std::unique_ptr<LcpSolver> solver_;
  FrictionLemkeSolver friction_solver_;
  HeldBodies held_;

  // Of one call, by body index.
  std::vector<Acceleration> free_;   // without contact forces
  std::vector<Acceleration> total_;  // with them
  std::vector<Wrench> wrenches_;
  Islands islands_;
  LcpProblem unsolved_;

  // Of one island.
  ContactList island_;
  ContactProblem problem_;
  std::vector<Point> points_;  // one for each row of the problem
  std::vector<double> terms_;
  std::vector<int> start_;
  LcpResult result_;
  FrictionPyramid pyramid_;
  std::vector<FrictionPoint> friction_points_;
  std::vector<Vec3> pushes_;
  VelocityStep velocity_step_;
  std::vector<MovingBody> trial_;
};

}  // namespace tumble
