/// \file
/// \brief The listing COLLIDE as it is printed (thesis A.2).
#include "tumble/impulse_damped/as_printed/collide_as_printed.hpp"

#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <array>

namespace tumble {
namespace {

// How easily a body is changed by the impulse. Erratum C4: as any other body. Mended, a stable one
// can neither be moved vertically nor tilted.
MovingBody as_impulse_sees_it(const PrintedObject& o, const DampedErrata& repaired) {
  MovingBody body = o.moving;
  if (!o.geometrically_stable || !repaired.has("C4")) return body;
  body.inverse_mass.y() = 0.0;
  const double about_y = body.inverse_inertia_w(1, 1);
  body.inverse_inertia_w.setZero();
  body.inverse_inertia_w(1, 1) = about_y;
  return body;
}

// Applies the impulse at the point that was found, and reports it.
void apply_newtonian_impulse(PrintedObject& first, PrintedObject& second, const Contact& collision,
                             double restitution, const DampedErrata& repaired,
                             PrintedCollision& report) {
  const MovingBody a = as_impulse_sees_it(first, repaired);
  const MovingBody b = as_impulse_sees_it(second, repaired);
  const Vec3& n = collision.normal_w;
  const Vec3& point_w = report.point_w;
  const double speed = n.dot(relative_velocity(a, b, point_w));
  report.approached = speed < 0.0;
  if (repaired.has("C7") && speed >= 0.0) return;
  const double inverse_mass = n.dot(inverse_mass_at(a, b, point_w) * n);
  if (!(inverse_mass > 0.0)) return;  // neither can be moved: there is no such pair as printed

  report.impulse = -(1.0 + restitution) * speed / inverse_mass;
  MovingBody a_after = a;
  MovingBody b_after = b;
  apply_impulse(a_after, b_after, point_w, report.impulse * n);
  first.change(a_after.velocity_w - a.velocity_w,
               a_after.angular_velocity_w - a.angular_velocity_w);
  second.change(b_after.velocity_w - b.velocity_w,
                b_after.angular_velocity_w - b.angular_velocity_w);
}

// The statements of a geometrically stable body, on the component that a printed index means.
void zero_components(PrintedObject& o, int index_base) {
  const auto exists = [&](int printed) {
    return printed >= index_base && printed < index_base + 3;
  };
  // [COLLIDE:12-14]
  // Its vertical momentum is set to 0, and so is its angular momentum
  // about the two horizontal axes.
  if (exists(1)) o.set_linear_momentum(1 - index_base, 0.0);
  if (exists(0)) o.set_angular_momentum(0 - index_base, 0.0);
  if (exists(2)) o.set_angular_momentum(2 - index_base, 0.0);
  // [COLLIDE:12-14]
}

}  // namespace

Vec3 find_contact_point(const Contact& collision) {
  double sum = 0.0;
  Vec3 weighted = Vec3::Zero();
  Vec3 plain = Vec3::Zero();
  for (int k = 0; k < collision.count; ++k) {
    const ContactPoint& point = collision.points[static_cast<std::size_t>(k)];
    const double depth = std::max(-point.distance, 0.0);
    sum += depth;
    weighted += depth * point.position_w;
    plain += point.position_w;
  }
  return sum > 0.0 ? Vec3(weighted / sum) : Vec3(plain / collision.count);
}

PrintedCollision collide_as_printed(PrintedObject& first, PrintedObject& second,
                                    const Contact& collision, double restitution,
                                    PrintedGravity gravity, const PrintedCollide& how) {
  const DampedErrata& repaired = how.repaired;
  const std::array<PrintedObject*, 2> objects{&first, &second};
  PrintedCollision report;
  // [COLLIDE:1-4]
  // If asked for, gravity is to be added, else nothing.
  Vec3 delta_velocity;
  if (gravity == PrintedGravity::velocity_plus_gravity)
    delta_velocity = how.gravity_w;
  else
    delta_velocity = Vec3::Zero();
  // [COLLIDE:1-4]
  // Erratum C1: an acceleration is no velocity.
  if (repaired.has("C1")) delta_velocity *= how.dt;
  // Erratum C2: immovable bodies as well.
  const auto falls = [&](const PrintedObject& o) { return o.movable || !repaired.has("C2"); };

  // [COLLIDE:5-6]
  // Add it to both bodies.
  for (PrintedObject* object : objects) {
    if (!falls(*object)) continue;
    object->set_velocity(object->moving.velocity_w + delta_velocity);
    // [COLLIDE:5-6]
  }

  // For the account only: energies half a step of gravity ahead, with the shift of now taken out.
  const bool ahead = gravity == PrintedGravity::velocity_plus_gravity;
  const Vec3 middle_w = ahead ? Vec3(0.5 * how.dt * how.gravity_w) : Vec3::Zero();
  const auto energy = [&](const Vec3& shift_w) {
    const Vec3 boost_w = repaired.has("C6") ? Vec3(middle_w - shift_w) : middle_w;
    return first.kinetic_energy(boost_w) + second.kinetic_energy(boost_w);
  };
  const double before = energy(delta_velocity);

  // [COLLIDE:7-8]
  // Find the contact point, and apply Newton's impulse there.
  report.point_w = find_contact_point(collision);
  apply_newtonian_impulse(first, second, collision, restitution, repaired, report);
  // [COLLIDE:7-8]
  const double pushed = energy(delta_velocity);

  // [COLLIDE:9]
  // For both bodies
  for (PrintedObject* object : objects) {
    // [COLLIDE:9]
    // Erratum C3 mended: lines 11 to 14 come first, while gravity is in the velocity.
    if (repaired.has("C3") && object->geometrically_stable)
      zero_components(*object, how.index_base);
    // [COLLIDE:10]
    // take the gravity back;
    if (falls(*object)) object->set_velocity(object->moving.velocity_w - delta_velocity);
    // [COLLIDE:10]
    // [COLLIDE:11]
    // a body that is geometrically stable loses what would tilt or lift it.
    if (object->geometrically_stable && !repaired.has("C3"))
      zero_components(*object, how.index_base);
    // [COLLIDE:11]
  }
  // [COLLIDE:15]
  // That is all.
  report.energy = pushed - before;
  report.damping = energy(Vec3::Zero()) - pushed;
  return report;
  // [COLLIDE:15]
}

}  // namespace tumble
