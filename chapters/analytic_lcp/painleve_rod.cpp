/// \file
/// \brief Painlevé's rod: a stick that slides on its lower end (thesis 2.6.3).
#include "analytic_lcp/painleve_rod.hpp"

#include "tumble/contact/effective_mass.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

double push_response(const PainleveRod& rod) {
  const double cosine = elementary::cos(rod.angle);
  return 1.0 + 3.0 * cosine * cosine - rod.friction * 3.0 * elementary::sin(rod.angle) * cosine;
}

double free_acceleration(const PainleveRod& rod) {
  return rod.spin * rod.spin * elementary::sin(rod.angle) - kGravity;
}

std::vector<double> possible_forces(const PainleveRod& rod) {
  const double p = push_response(rod);
  const double b = free_acceleration(rod);
  std::vector<double> forces;
  if (b >= 0.0) forces.push_back(0.0);                     // the end lifts off
  if (p != 0.0 && -b / p > 0.0) forces.push_back(-b / p);  // it stays
  return forces;
}

double critical_friction(double angle) {
  const double tangent = elementary::sin(angle) / elementary::cos(angle);
  return (4.0 + tangent * tangent) / (3.0 * tangent);
}

void add_gravity(Instant& instant) {
  load_moving_bodies(instant.world, instant.bodies);
  instant.free.assign(instant.bodies.size(), Acceleration{});
  for (std::size_t k = 0; k < instant.bodies.size(); ++k)
    if (instant.world.bodies()[k].movable()) instant.free[k].linear_w = instant.world.gravity_w;
}

Instant rod_on_end(const PainleveRod& rod) {
  Instant instant;
  instant.world.add_ground(rod.friction);
  const Vec3 to_end(-elementary::cos(rod.angle), -elementary::sin(rod.angle), 0.0);
  const Vec3 spin_w(0.0, 0.0, rod.spin);
  const BodyProperties body = box_properties(Vec3(2.0, 1e-5, 1e-5), 1.0, rod.friction);
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, rod.angle));
  const Vec3 velocity_w = -Vec3::UnitX() - spin_w.cross(to_end);
  instant.world.add(body, make_state(body, -to_end, turned, velocity_w, spin_w));
  Contact contact;
  contact.second = 1;
  contact.friction = rod.friction;
  contact.count = 1;
  instant.contacts.push_back(contact);
  add_gravity(instant);
  return instant;
}

RodStep step_rod(const PainleveRod& rod, double step, int directions) {
  Instant instant = rod_on_end(rod);
  VelocityStepOptions options;
  options.directions = directions;
  const VelocityStepResult result = VelocityStep().solve(
      instant.world, instant.free, instant.contacts, step, options, instant.bodies);
  const ContactPoint& point = instant.contacts[0].points[0];
  const Vec3 motion_w = relative_velocity(instant.bodies[0], instant.bodies[1], Vec3::Zero());
  return {result.solved, point.normal_impulse, point.friction_impulse_w.x(),
          motion_w.x(),  motion_w.y(),         instant.bodies[1].angular_velocity_w.z()};
}

}  // namespace tumble::chapters
