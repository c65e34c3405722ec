/// \file
/// \brief A scene at its first instant: rules, and the whole complementarity problem.
#include "geometric_stability/support_instant.hpp"

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tumble::chapters {
namespace {

constexpr double kRising = 0.0;  // [-] everything is at rest

}  // namespace

int upper_body(const Contact& contact) {
  return contact.normal_w.y() > 0.0 ? contact.second : contact.first;
}

int lower_body(const Contact& contact) {
  return contact.normal_w.y() > 0.0 ? contact.first : contact.second;
}

SupportInstant::SupportInstant(World world) : world_(std::move(world)) {
  std::vector<MovingBody> bodies;
  load_moving_bodies(world_, bodies);
  gather_near(world_, bodies, contacts_);
}

void SupportInstant::take_support(int body) {
  std::erase_if(contacts_, [&](const Contact& contact) { return upper_body(contact) == body; });
}

RuleAnswer SupportInstant::ask(StableRule rule, int body) const {
  GeometricStability stability({tolerance::exact_vertical, tolerance::exact_corner});
  RuleAnswer answer;
  stability.run(world_, contacts_, rule, kRising, answer.all);
  answer.stable = answer.all[at(body)] != 0;
  answer.told = told(world_, contacts_, stability.verdict(world_, body));
  return answer;
}

bool SupportInstant::load_proof(int body) const {
  std::vector<char> stable;
  LoadProof().run(world_, contacts_, stable);
  return stable[at(body)] != 0;
}

double SupportInstant::acceleration(int body, double load, const Vec3& at_w) const {
  std::vector<MovingBody> bodies;
  load_moving_bodies(world_, bodies);
  std::vector<Acceleration> accelerations;
  free_accelerations(world_, bodies, accelerations);
  std::vector<Wrench> wrenches(bodies.size());
  const Vec3 push_w(0.0, -load, 0.0);
  wrenches[at(body)] = {push_w, (at_w - bodies[at(body)].position_w).cross(push_w)};
  accelerate(bodies, wrenches, accelerations);

  ContactProblem problem;
  problem.assemble(world_, bodies, accelerations, contacts_,
                   std::numeric_limits<double>::infinity());
  LcpResult result;
  make_lcp_solver("augmented_lagrangian")->solve(problem.lcp(), result);
  if (result.status != LcpStatus::solved || result.residual > tolerance::force_residual)
    throw std::runtime_error("the contact forces were not found");
  wrenches.assign(bodies.size(), Wrench());
  problem.add_wrenches(result.f, wrenches);
  accelerate(bodies, wrenches, accelerations);

  double most = 0.0;
  for (const Vec3& corner_w :
       corners_of(box_of(world_.bodies()[at(body)], world_.states()[at(body)])))
    most =
        std::max(most, acceleration_at(bodies[at(body)], accelerations[at(body)], corner_w).norm());
  return most;
}

double SupportInstant::worst_acceleration(int body, double load) const {
  const BodyState& state = world_.states()[at(body)];
  double worst = 0.0;
  for (const Vec3& corner_w : corners_of(box_of(world_.bodies()[at(body)], state)))
    if (corner_w.y() > state.position_w.y())
      worst = std::max(worst, acceleration(body, load, corner_w));
  return worst;
}

}  // namespace tumble::chapters
