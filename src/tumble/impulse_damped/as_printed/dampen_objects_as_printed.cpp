/// \file
/// \brief The listing DAMPENOBJECTS as it is printed (thesis A.2).
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

// The body's own axis, or its opposite, that points upwards most.
Vec3 upward_axis(const Quat& orientation_wb) {
  const Mat3 rotation_wb = orientation_wb.toRotationMatrix();
  Eigen::Index column = 0;
  rotation_wb.row(1).cwiseAbs().maxCoeff(&column);
  const Vec3 axis_w = rotation_wb.col(column);
  return axis_w.y() < 0.0 ? Vec3(-axis_w) : axis_w;
}

// Whether a face is across gravity. The listing hands over nothing: then it must be so exactly.
bool check_y_axis_alignment_as_printed(const BodyState& o, double tolerance,
                                       const DampedErrata& repaired) {
  const double cosine = upward_axis(o.orientation_wb).y();
  return repaired.has("DM16") ? cosine >= elementary::cos(tolerance) : cosine == 1.0;
}

// Turns a body about its centre, so that the face that is nearly across gravity comes closer to it.
void tilt_towards_y_axis(BodyState& o, double most) {
  const Vec3 axis_w = upward_axis(o.orientation_wb);
  const Vec3 about_w = axis_w.cross(Vec3::UnitY());
  const double sine = about_w.norm();
  if (!(sine > 0.0)) return;
  const double angle = std::min(elementary::atan2(sine, axis_w.y()), most);
  o.orientation_wb = normalised(rotation_from_vector(angle / sine * about_w) * o.orientation_wb);
}

// How far two orientations differ, as the listing subtracts them, or as an angle.
double rotation_length(const Quat& now, const Quat& before, const DampedErrata& repaired) {
  if (repaired.has("DM13")) return angle_between(now, before);
  return (now.coeffs() - before.coeffs()).norm();
}

// Erratum DM4: small is what is less, also if it is very negative.
bool is_small(double x, double threshold, const DampedErrata& repaired) {
  return (repaired.has("DM4") ? std::abs(x) : x) < threshold;
}

// The loop over the components of a body's momenta.
void dampen_components(BodyState& o, const PrintedNumbers& numbers, const DampedErrata& repaired) {
  const auto& [eps, k] = numbers;
  Vec3& momentum = o.linear_momentum_w;
  Vec3& spin = o.angular_momentum_w;
  const auto small = [&](double x, double threshold) { return is_small(x, threshold, repaired); };
  // Erratum DM1: line 14 names the threshold of line 12, not a smaller one.
  const double eps_of_line_14 = repaired.has("DM1") ? eps.still : eps.slow;
  // Erratum DM2: from 1 to 3, where components are called 0, 1, 2.
  const int first = repaired.has("DM2") ? 0 : 1;

  // [DAMPENOBJECTS:11]
  // Component by component:
  for (int i = first; i < first + 3; ++i) {
    // [DAMPENOBJECTS:11]
    if (i == 3) continue;  // there is none
    // [DAMPENOBJECTS:12-15]
    // Scale a small momentum, and end it if it is still as small.
    if (small(momentum[i], eps.slow)) momentum[i] = momentum[i] * k.slow;
    if (small(momentum[i], eps_of_line_14)) momentum[i] = 0.0;
    // [DAMPENOBJECTS:12-15]
    // [DAMPENOBJECTS:16-19]
    // Scale a small spin, and end it if it is smaller still.
    if (small(spin[i], eps.slow_spin)) spin[i] = spin[i] * k.slow_spin;
    if (small(spin[i], eps.still_spin)) spin[i] = 0.0;
    // [DAMPENOBJECTS:16-19]
    if (repaired.has("DM3")) continue;
    // [DAMPENOBJECTS:20-21]
    // End a small spin about the vertical, if it is not negative.
    if (small(spin[1], eps.rising) && spin[1] >= 0.0) spin[1] = 0.0;
    // [DAMPENOBJECTS:20-21]
  }
  // Erratum DM3 repaired: once, and momentum upwards.
  if (repaired.has("DM3") && small(momentum[1], eps.rising) && momentum[1] >= 0.0)
    momentum[1] = 0.0;
}

// What is done to one object.
void dampen_object(BodyState& o, bool touched, const PrintedNumbers& numbers,
                   const DampedErrata& repaired) {
  const auto& [eps, k] = numbers;
  Vec3& momentum = o.linear_momentum_w;
  Vec3& spin = o.angular_momentum_w;
  // [DAMPENOBJECTS:2-5]
  // If it has touched something: see whether one of its faces is
  // across gravity, and scale both momenta.
  if (touched) {
    const bool y_axis_aligned = check_y_axis_alignment_as_printed(o, eps.aligned, repaired);
    momentum = momentum * k.momentum;
    spin = spin * k.spin;
    // [DAMPENOBJECTS:2-5]
    // [DAMPENOBJECTS:6-10]
    // A face across gravity: end a small vertical momentum, and
    // then scale the spin; turn the face a little closer to level.
    if (y_axis_aligned) {
      if (is_small(momentum[1], eps.settled, repaired)) {
        momentum[1] = 0.0;
        spin = spin * k.settled_spin;
      }
      tilt_towards_y_axis(o, eps.tilt);
    }
    // [DAMPENOBJECTS:6-10]
    dampen_components(o, numbers, repaired);
  }
}

// Moves all bodies. Erratum D5: with the momentum that a further g Δt would give.
int integrate_object_positions(World& world, double dt, RotationRule rotation,
                               const DampedErrata& repaired) {
  int moved = 0;
  for (std::size_t index = 0; index < world.states().size(); ++index) {
    const BodyProperties& body = world.bodies()[index];
    BodyState& o = world.states()[index];
    if (!body.movable()) continue;
    advance_pose(body, o, dt, rotation);
    if (!repaired.has("D5")) o.position_w += dt * dt * world.gravity_w;
    ++moved;
  }
  return moved;
}

}  // namespace

DampenReport dampen_objects_as_printed(World& world, std::span<const std::uint8_t> touched,
                                       const PrintedNumbers& numbers, double dt,
                                       RotationRule rotation, const DampedErrata& repaired) {
  require::positive(dt, "dt");
  require::that(touched.size() == world.states().size(),
                "touched: " + std::to_string(touched.size()) + " flags for " +
                    std::to_string(world.count()) + " bodies");
  const DampedThresholds& eps = numbers.eps;
  DampenReport report;
  // [DAMPENOBJECTS:1]
  // For each object
  for (std::size_t index = 0; index < touched.size(); ++index) {
    // [DAMPENOBJECTS:1]
    const BodyProperties& body = world.bodies()[index];
    BodyState& o = world.states()[index];
    if (!body.movable()) continue;  // it has no momenta
    const double before = kinetic_energy(body, o);
    dampen_object(o, touched[index] != 0, numbers, repaired);
    report.damping += kinetic_energy(body, o) - before;
    if (touched[index] != 0) ++report.damped;
  }

  const std::vector<BodyState> old(world.states().begin(), world.states().end());
  // [DAMPENOBJECTS:22]
  // Move all objects, with gravity in their velocity.
  report.moved = integrate_object_positions(world, dt, rotation, repaired);
  // [DAMPENOBJECTS:22]

  // [DAMPENOBJECTS:23]
  // For each object
  for (std::size_t index = 0; index < touched.size(); ++index) {
    // [DAMPENOBJECTS:23]
    const BodyProperties& body = world.bodies()[index];
    BodyState& o = world.states()[index];
    if (!body.movable()) continue;
    const double before = energy_of(body, o, world.gravity_w).potential;
    // [DAMPENOBJECTS:24-25]
    // how far it has come, and how far it has turned.
    const double delta_position = (o.position_w - old[index].position_w).norm();
    const double delta_rotation =
        rotation_length(o.orientation_wb, old[index].orientation_wb, repaired);
    // [DAMPENOBJECTS:24-25]
    // [DAMPENOBJECTS:26-28]
    // If both are small, put it back to where it was.
    if (is_small(delta_position, eps.frozen, repaired) &&
        is_small(delta_rotation, eps.frozen_angle, repaired)) {
      o.position_w = old[index].position_w;
      o.orientation_wb = old[index].orientation_wb;
      ++report.frozen;
    }
    // [DAMPENOBJECTS:26-28]
    report.repair += energy_of(body, o, world.gravity_w).potential - before;
  }
  // [DAMPENOBJECTS:29]
  return report;
  // [DAMPENOBJECTS:29]
}

}  // namespace tumble
