/// \file
/// \brief The whole complementarity problem of a pile at rest, under any loads (thesis 5.4, 3.3.1).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/contact/islands.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A bound of the acceleration of all points of a body: of its centre, and of its rim as it turns.
// Returns [m/s²] at least 0
double fastest_of(const BodyProperties& body, const Acceleration& acceleration);

// A force straight down at a point of a body.
// point_w: [m] where the force acts, world frame
// force: [N] downwards
Wrench weight_at(const BodyState& state, const Vec3& point_w, double force);

// Accelerations of bodies at rest, by the complementarity problem with all contacts and no friction.
//
// No body is left out and no rule is asked, so that rules can be judged by it. Island by island; loads
// come in as accelerations without contacts.
class PileForces {
 public:
  explicit PileForces(std::string_view solver = "augmented_lagrangian");

  // Solves the problem.
  bool solve(const World& world, std::span<const Contact> contacts,
             std::span<const Wrench> loads = {});

  // Accelerations under weights, loads and contact forces.
  [[nodiscard]] std::span<const Acceleration> accelerations() const { return accelerations_; }

  // The largest residual of an island's answer.
  // Returns [-] see lcp_residual()
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
