/// \file
/// \brief The independent judge of figure 6.3: two hinged boxes with two angles, by GSL.
#include "exterior_rotation/nested_pendulum.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace tumble::chapters {
namespace {

// Levers in the frames of the boxes, from the edge about which each turns.
struct Hinged {
  Vec2 lower_b = Vec2(-0.75, 0.5);  // [m] to the lower centre
  Vec2 edge_b = Vec2(-0.75, 1.0);   // [m] to the upper box's edge
  Vec2 upper_b = Vec2(0.5, 0.5);    // [m] from there to the upper centre
  double lower_mass = 1.0;          // [kg]
  double upper_mass = 1.0;
  double lower_inertia = 1.0;  // [kg m²] about the centre
  double upper_inertia = 1.0;
  double gravity = 0.0;  // [m/s²]
};

Vec2 turned(double angle, const Vec2& v) {
  return Vec2(std::cos(angle) * v.x() - std::sin(angle) * v.y(),
              std::sin(angle) * v.x() + std::cos(angle) * v.y());
}

// The change of a vector that turns by a radian.
Vec2 across(const Vec2& v) { return Vec2(-v.y(), v.x()); }

// y = (a, b, their rates).
int derivative(double, const double y[], double rate[], void* data) {
  const Hinged& h = *static_cast<const Hinged*>(data);
  const Vec2 lower = turned(y[0], h.lower_b);
  const Vec2 edge = turned(y[0], h.edge_b);
  const Vec2 upper = turned(y[1], h.upper_b);
  const double a =
      h.lower_inertia + h.lower_mass * lower.squaredNorm() + h.upper_mass * edge.squaredNorm();
  const double c = h.upper_inertia + h.upper_mass * upper.squaredNorm();
  const double d = h.upper_mass * edge.dot(upper);
  const double d_a =
      h.upper_mass * across(edge).dot(upper);  // its change with a; with b, less that
  const double pull_a =
      -h.gravity * (h.lower_mass * across(lower).y() + h.upper_mass * across(edge).y());
  const double pull_b = -h.gravity * h.upper_mass * across(upper).y();
  const double right_a = pull_a + d_a * y[3] * y[3];
  const double right_b = pull_b - d_a * y[2] * y[2];
  const double determinant = a * c - d * d;
  rate[0] = y[2];
  rate[1] = y[3];
  rate[2] = (c * right_a - d * right_b) / determinant;
  rate[3] = (a * right_b - d * right_a) / determinant;
  return GSL_SUCCESS;
}

double angle_of(const World& world, const char* name) {
  const auto k = static_cast<std::size_t>(world.index_of(world.find(name).value()));
  const Quat& q = world.states()[k].orientation_wb;
  return 2.0 * std::atan2(q.z(), q.w());
}

}  // namespace

NestedAngles nested_angles(const World& world) {
  return {angle_of(world, "lower"), angle_of(world, "upper")};
}

NestedAngles nested_pendulum(const World& start, double time) {
  const auto at = [&](const char* name) {
    return static_cast<std::size_t>(start.index_of(start.find(name).value()));
  };
  const BodyProperties& lower = start.bodies()[at("lower")];
  const BodyProperties& upper = start.bodies()[at("upper")];
  Hinged hinged{.lower_mass = lower.mass,
                .upper_mass = upper.mass,
                .lower_inertia = lower.inertia_b.z(),
                .upper_inertia = upper.inertia_b.z(),
                .gravity = start.gravity_w.norm()};
  const NestedAngles from = nested_angles(start);
  double y[4] = {from.lower, from.upper, angular_velocity(lower, start.states()[at("lower")]).z(),
                 angular_velocity(upper, start.states()[at("upper")]).z()};
  gsl_odeiv2_system system{derivative, nullptr, 4, &hinged};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 0.0),
      gsl_odeiv2_driver_free);
  double t = 0.0;
  if (time > 0.0 && gsl_odeiv2_driver_apply(driver.get(), &t, time, y) != GSL_SUCCESS)
    throw std::runtime_error("GSL could not integrate the two boxes of figure 6.3");
  return {y[0], y[1]};
}

}  // namespace tumble::chapters
