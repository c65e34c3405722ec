/// \file
/// \brief The whole complementarity problem of a pile.
#include "geometric_stability/pile_forces.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"

namespace tumble::chapters {

double fastest_of(const BodyProperties& body, const Acceleration& acceleration) {
  return acceleration.linear_w.norm() + 0.5 * body.size.norm() * acceleration.angular_w.norm();
}

Wrench weight_at(const BodyState& state, const Vec3& point_w, double force) {
  const Vec3 force_w(0.0, -force, 0.0);
  return {force_w, (point_w - state.position_w).cross(force_w)};
}

PileForces::PileForces(std::string_view solver) : solver_(make_lcp_solver(solver)) {}

bool PileForces::solve(const World& world, std::span<const Contact> contacts,
                       std::span<const Wrench> loads) {
  load_moving_bodies(world, bodies_);
  free_accelerations(world, bodies_, accelerations_);
  if (!loads.empty()) accelerate(bodies_, loads, accelerations_);
  islands_.build(world.bodies(), contacts);
  wrenches_.assign(bodies_.size(), Wrench{});
  residual_ = 0.0;
  for (int i = 0; i < islands_.count(); ++i) {
    island_.clear();
    for (const int c : islands_.contacts(i))
      island_.push_back(contacts[static_cast<std::size_t>(c)]);
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

}  // namespace tumble::chapters
