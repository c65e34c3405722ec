/// \file
/// \brief Worlds at an instant, for tests of contact forces.
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/math/complementarity.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"
#include "support/touching.hpp"

namespace tumble::test {

inline constexpr double kG = 9.81;       // [m/s²]
inline constexpr double kMargin = 1e-9;  // [m] of contacts between bodies that touch exactly
// [m/s] Every point gets a row.
inline constexpr double kAll = kInfinity;

// Adds a movable box.
inline BodyId add_box(World& world, const Vec3& size, double mass, const Vec3& position_w,
                      const Quat& orientation_wb = Quat::Identity(),
                      const Vec3& velocity_w = Vec3::Zero(), const Vec3& omega_w = Vec3::Zero()) {
  return world.add(box_properties(size, mass), position_w, orientation_wb, velocity_w, omega_w);
}

// Adds an immovable box.
inline BodyId add_fixed(World& world, const Vec3& size, const Vec3& position_w,
                        const Quat& orientation_wb = Quat::Identity()) {
  return world.add(fixed_box_properties(size), position_w, orientation_wb);
}

// A world at an instant: from its contacts to the accelerations under the forces of a solver.
struct Instant {
  // Gathers the contacts.
  explicit Instant(const World& w) : world(w), external(w.bodies().size()) {
    load_moving_bodies(world, bodies);
    gather_contacts(world, bodies, all_pairs(world), kMargin, {}, contacts);
  }

  // Sets up the problem.
  void assemble() {
    free_accelerations(world, bodies, accelerations);
    accelerate(bodies, external, accelerations);
    problem.assemble(world, bodies, accelerations, contacts, kAll);
  }

  // Sets up the problem, solves it and lets the forces act.
  void solve() {
    assemble();
    ComplementaritySolver().solve(problem.lcp().A, problem.lcp().b, answer);
    REQUIRE(answer.status == ComplementarityStatus::solved);
    wrenches.assign(bodies.size(), Wrench());
    problem.add_wrenches(answer.f, wrenches);
    accelerate(bodies, wrenches, accelerations);
  }

  // The point of a row. [m] world frame
  [[nodiscard]] const Vec3& place(std::size_t row) const {
    const ContactRow& r = problem.rows()[row];
    return contacts[idx(r.contact)].points[idx(r.point)].position_w;
  }

  // All forces of the contacts between two bodies. [N] their sum
  [[nodiscard]] double force_between(int first, int second) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < answer.f.size(); ++i) {
      const Contact& contact = contacts[idx(problem.rows()[i].contact)];
      if (contact.first == first && contact.second == second) sum += answer.f[i];
    }
    return sum;
  }

  // The largest acceleration of any body. [m/s² or rad/s²]
  [[nodiscard]] double unrest() const {
    double most = 0.0;
    for (const Acceleration& a : accelerations)
      most = std::max({most, a.linear_w.norm(), a.angular_w.norm()});
    return most;
  }

  World world;                              // the bodies
  std::vector<MovingBody> bodies;           // how they move
  std::vector<Wrench> external;             // what acts beside gravity and contacts
  ContactList contacts;                     // where they touch
  std::vector<Acceleration> accelerations;  // without, and after solve() with contact forces
  ContactProblem problem;                   // the problem
  ComplementarityResult answer;             // its solution
  std::vector<Wrench> wrenches;             // of the contact forces
};

}  // namespace tumble::test
