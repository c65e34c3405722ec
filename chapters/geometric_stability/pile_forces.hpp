/// \file
/// \brief The whole complementarity problem of a pile at rest, under any loads (thesis 5.4, 3.3.1).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/contact/islands.hpp"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// How fast a body gets, wherever on it: of its centre, and of its rim as it turns.
/// \param body          its size
/// \param acceleration  of it
/// \return [m/s²] at least 0
double fastest_of(const BodyProperties& body, const Acceleration& acceleration);

/// A force straight down at a point of a body.
/// \param state    where the body is
/// \param point_w  [m] where the force acts, world frame
/// \param force    [N] downwards
/// \return what it does at the centre of mass
Wrench weight_at(const BodyState& state, const Vec3& point_w, double force);

/// How bodies at rest begin to move, by the complementarity problem with all contacts and no friction.
///
/// Nobody is left out and no rule is asked: this is what rules are judged by. Island by island; loads
/// come in as what bodies would do without contacts.
class PileForces {
 public:
  /// \param solver  of the problems, by name
  explicit PileForces(std::string_view solver = "augmented_lagrangian");

  /// Solves the problem.
  /// \param world     bodies at rest
  /// \param contacts  what touches
  /// \param loads     beside the weights, one for each body index; may be empty
  /// \return whether each island has an answer with a residual below tolerance::force_residual
  bool solve(const World& world, std::span<const Contact> contacts,
             std::span<const Wrench> loads = {});

  /// How bodies accelerate under weights, loads and contact forces.
  /// \return one for each body index
  [[nodiscard]] std::span<const Acceleration> accelerations() const { return accelerations_; }

  /// The largest residual of an island's answer.
  /// \return [-] see lcp_residual()
  [[nodiscard]] double residual() const { return residual_; }

  /// The largest problem.
  /// \return its rows
  [[nodiscard]] int most_rows() const { return most_rows_; }

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
  int most_rows_ = 0;
};

}  // namespace tumble::chapters
