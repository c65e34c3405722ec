/// \file
/// \brief The whole complementarity problem of a pile at rest, under any loads (thesis 5.4, 3.3.1).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/contact/islands.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A bound of the acceleration of all points of a body: of its centre, and of its rim as it turns.
// Returns [m/s²] at least 0
inline double fastest_of(const BodyProperties& body, const Acceleration& acceleration) {
  return acceleration.linear_w.norm() + 0.5 * body.size.norm() * acceleration.angular_w.norm();
}

// A force straight down at a point of a body.
// point_w: [m] where the force acts, world frame
// force: [N] downwards
inline Wrench weight_at(const BodyState& state, const Vec3& point_w, double force) {
  const Vec3 force_w(0.0, -force, 0.0);
  return {force_w, (point_w - state.position_w).cross(force_w)};
}

// Accelerations of bodies at rest, by the complementarity problem with all contacts and no friction.
//
// No body is left out and no rule is asked, so that rules can be judged by it. Island by island; loads
// come in as accelerations without contacts.
class PileForces {
 public:
  explicit PileForces(std::string_view solver = "augmented_lagrangian")
      : solver_(make_lcp_solver(solver)) {}

  // Solves the problem.
  bool solve(const World& world, std::span<const Contact> contacts,
             std::span<const Wrench> loads = {}) {
    load_moving_bodies(world, bodies_);
    free_accelerations(world, bodies_, accelerations_);
    if (!loads.empty()) accelerate(bodies_, loads, accelerations_);
    islands_.build(world.bodies(), contacts);
    wrenches_.assign(bodies_.size(), Wrench{});
    residual_ = 0.0;
    for (int i = 0; i < islands_.count(); ++i) {
      island_.clear();
      for (const int c : islands_.contacts(i)) island_.push_back(contacts[idx(c)]);
      problem_.assemble(world, bodies_, accelerations_, island_,
                        std::numeric_limits<double>::infinity());
      solver_->solve(problem_.lcp(), result_);
      if (result_.status != LcpStatus::solved || !(result_.residual <= tolerance::force_residual))
        return false;
      residual_ = std::max(residual_, result_.residual);
      problem_.add_wrenches(result_.f, wrenches_);
    }
    accelerate(bodies_, wrenches_, accelerations_);
    return true;
  }

  // Accelerations under weights, loads and contact forces.
  [[nodiscard]] std::span<const Acceleration> accelerations() const { return accelerations_; }

  // The largest residual of an island's answer [-], see lcp_residual().
  [[nodiscard]] double residual() const { return residual_; }

 private:
  std::unique_ptr<LcpSolver> solver_;
  std::vector<MovingBody> bodies_;
  std::vector<Acceleration> accelerations_;
  std::vector<Wrench> wrenches_;
  Islands islands_;
  ContactList island_;
  ContactProblem problem_;
  LcpResult result_;
  double residual_ = 0.0;
};

}  // namespace tumble::chapters
