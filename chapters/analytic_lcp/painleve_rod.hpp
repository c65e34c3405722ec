/// \file
/// \brief Painlevé's rod: a stick that slides on its lower end (thesis 2.6.3).
#pragma once

#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/contact/effective_mass.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A thin rod of 1 kg and a half length of 1 m. Its lower end is on the ground and slides to the left,
// away from the side to which the rod leans.
struct PainleveRod {
  double angle = 1.0;     // [rad] above the ground, to the right
  double friction = 0.0;  // [-] Coulomb's coefficient, at least 0
  double spin = 0.0;      // [rad/s] angular velocity
};

// [1/kg] The acceleration of the lower end away from the ground per force N there, while friction mu N
// pushes it to the right: p = (1 + 3 cos² - 3 mu sin cos) / m. Below 0 a harder push moves the end down.
inline double push_response(const PainleveRod& rod) {
  const double cosine = elementary::cos(rod.angle);
  return 1.0 + 3.0 * cosine * cosine - rod.friction * 3.0 * elementary::sin(rod.angle) * cosine;
}

// [m/s²] The same without a force there: b = l omega² sin - g.
inline double free_acceleration(const PainleveRod& rod) {
  return rod.spin * rod.spin * elementary::sin(rod.angle) - kGravity;
}

// [N] All forces that obey N >= 0, p N + b >= 0 and N (p N + b) = 0, ascending.
inline std::vector<double> possible_forces(const PainleveRod& rod) {
  const double p = push_response(rod);
  const double b = free_acceleration(rod);
  std::vector<double> forces;
  if (b >= 0.0) forces.push_back(0.0);                     // the end lifts off
  if (p != 0.0 && -b / p > 0.0) forces.push_back(-b / p);  // it stays
  return forces;
}

// The friction beyond which there may be none or two: (4 + tan²) / (3 tan), where p = 0.
inline double critical_friction(double angle) {
  const double tangent = elementary::sin(angle) / elementary::cos(angle);
  return (4.0 + tangent * tangent) / (3.0 * tangent);
}

// A world at the start of a step.
struct Instant {
  World world;
  ContactList contacts;
  std::vector<MovingBody> bodies;
  std::vector<Acceleration> free;  // gravity
};

// Loads the bodies and gravity of a world with contacts.
inline void add_gravity(Instant& instant) {
  load_moving_bodies(instant.world, instant.bodies);
  instant.free.assign(instant.bodies.size(), Acceleration{});
  for (std::size_t k = 0; k < instant.bodies.size(); ++k)
    if (instant.world.bodies()[k].movable()) instant.free[k].linear_w = instant.world.gravity_w;
}

// The ground and the rod, 0.01 mm thick, whose end slides with 1 m/s to the left.
inline Instant rod_on_end(const PainleveRod& rod) {
  Instant instant;
  instant.world.add_ground(rod.friction);
  const Vec3 to_end(-elementary::cos(rod.angle), -elementary::sin(rod.angle), 0.0);
  const Vec3 spin_w(0.0, 0.0, rod.spin);
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, rod.angle));
  const Vec3 velocity_w = -Vec3::UnitX() - spin_w.cross(to_end);
  instant.world.add(box_properties(Vec3(2.0, 1e-5, 1e-5), 1.0, rod.friction), -to_end, turned,
                    velocity_w, spin_w);
  instant.contacts.push_back(Contact{.second = 1, .friction = rod.friction, .count = 1});
  add_gravity(instant);
  return instant;
}

// The state of the lower end after a time step.
struct RodStep {
  bool solved = false;
  double normal_impulse = 0.0;    // [N s] away from the ground
  double friction_impulse = 0.0;  // [N s] to the right
  double slip = 0.0;              // [m/s] to the right, after the step
  double lift = 0.0;              // [m/s] away from the ground, after the step
  double spin = 0.0;              // [rad/s] after the step
};

// A step of Stewart and Trinkle with a pyramid of 4 or 8 directions.
inline RodStep step_rod(const PainleveRod& rod, double step, int directions) {
  Instant instant = rod_on_end(rod);
  const VelocityStepResult result =
      VelocityStep().solve(instant.world, instant.free, instant.contacts, step,
                           {.directions = directions}, instant.bodies);
  const ContactPoint& point = instant.contacts[0].points[0];
  const Vec3 motion_w = relative_velocity(instant.bodies[0], instant.bodies[1], Vec3::Zero());
  return {result.solved, point.normal_impulse, point.friction_impulse_w.x(),
          motion_w.x(),  motion_w.y(),         instant.bodies[1].angular_velocity_w.z()};
}

}  // namespace tumble::chapters
