/// \file
/// \brief A rigid body: making one, and the velocities behind its momenta (thesis 3.1).
#include "tumble/dynamics/body.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble {
namespace {

// What makes any shape immovable: infinite mass, and inverses that are exactly zero.
BodyProperties immovable(Shape shape, const Vec3& size, double friction, double restitution) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  require_surface(friction, restitution);
  BodyProperties body;
  body.shape = shape;
  body.size = size;
  body.mass = infinity;
  body.inverse_mass = 0.0;
  body.inertia_b = Vec3::Constant(infinity);
  body.inverse_inertia_b = Vec3::Zero();
  body.friction = friction;
  body.restitution = restitution;
  return body;
}

void require_size(const Vec3& size) {
  require::positive(size.x(), "size.x");
  require::positive(size.y(), "size.y");
  require::positive(size.z(), "size.z");
  require::within(size.minCoeff(), tolerance::smallest_edge, tolerance::largest_value,
                  "shortest edge of size");
  require::within(size.maxCoeff(), tolerance::smallest_edge, tolerance::largest_value,
                  "longest edge of size");
}

// A moment of inertia follows from what was given, so the message names that too.
void require_moment(double moment, std::string_view which, const BodyProperties& body) {
  if (moment >= tolerance::smallest_mass && moment <= tolerance::largest_mass) return;
  std::string name(which);
  name.append(" moment of inertia, of a box of ").append(shortest_text(body.mass));
  name.append(" kg with edges from ").append(shortest_text(body.size.minCoeff()));
  name.append(" to ").append(shortest_text(body.size.maxCoeff())).append(" m,");
  require::within(moment, tolerance::smallest_mass, tolerance::largest_mass, name);
}

std::string speed_limit() {
  return "at most " + shortest_text(tolerance::largest_speed) + " m/s, the speed of light";
}

}  // namespace

void require_surface(double friction, double restitution) {
  require::not_negative(friction, "friction");
  if (friction > tolerance::largest_friction)
    refuse_value("friction", shortest_text(friction),
                 "at most " + shortest_text(tolerance::largest_friction) +
                     ", which no slope makes slide: give that for a rough surface");
  require::within(restitution, 0.0, 1.0, "restitution");
}

void require_motion_limits(const BodyProperties& body, const Vec3& position_w,
                           const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  require::finite(position_w, "position_w");
  require::finite(velocity_w, "velocity_w");
  require::finite(angular_velocity_w, "angular_velocity_w");
  const double edge = body.size.minCoeff();
  if (position_w.cwiseAbs().maxCoeff() > tolerance::farthest * edge)
    refuse_value("position_w", vector_text(position_w),
                 "coordinates up to " + shortest_text(tolerance::farthest) +
                     " times the shortest edge, which is " + shortest_text(edge) +
                     " m: move the scene to the origin, or make the edge longer");
  // Coordinates first: the squares of larger ones would not be numbers.
  if (velocity_w.cwiseAbs().maxCoeff() > tolerance::largest_speed ||
      velocity_w.norm() > tolerance::largest_speed)
    refuse_value("velocity_w", vector_text(velocity_w), speed_limit() + ": make it slower");
  const double fastest = tolerance::largest_speed / (0.5 * body.size.norm());
  if (angular_velocity_w.cwiseAbs().maxCoeff() > fastest || angular_velocity_w.norm() > fastest)
    refuse_value("angular_velocity_w", vector_text(angular_velocity_w),
                 "at most " + shortest_text(fastest) + " rad/s, at which a corner moves at " +
                     shortest_text(tolerance::largest_speed) +
                     " m/s, the speed of light: make the box spin slower, or smaller");
}

void require_valid(const BodyProperties& body) {
  require::that(body.shape == Shape::box, "body.shape is ground: expected add_ground()");
  require_surface(body.friction, body.restitution);
  for (int k = 0; k < 3; ++k) require::positive(body.size[k], "body.size");
  require::not_negative(body.inverse_mass, "body.inverse_mass");
  if (!body.movable()) {
    require::that(body.inverse_inertia_b.isZero(0.0),
                  "an immovable body has an inverse inertia: expected 0");
    return;
  }
  const auto reciprocal = [](double value, double inverse) {
    return std::abs(value * inverse - 1.0) <= tolerance::reciprocal;
  };
  require::within(body.mass, tolerance::smallest_mass, tolerance::largest_mass, "body.mass");
  // Texts are made only when they are needed: a large world is made in a part of the time.
  if (!reciprocal(body.mass, body.inverse_mass))
    refuse("body.inverse_mass = " + shortest_text(body.inverse_mass) +
           ": expected 1 / mass = " + shortest_text(1.0 / body.mass));
  for (int k = 0; k < 3; ++k) {
    require::within(body.inertia_b[k], tolerance::smallest_mass, tolerance::largest_mass,
                    "body.inertia_b");
    if (!reciprocal(body.inertia_b[k], body.inverse_inertia_b[k]))
      refuse("body.inverse_inertia_b has " + shortest_text(body.inverse_inertia_b[k]) +
             ": expected 1 / inertia_b = " + shortest_text(1.0 / body.inertia_b[k]));
  }
}

void require_valid(const BodyProperties& body, const BodyState& state, std::string_view name) {
  require::finite(state.position_w, "state.position_w");
  require::unit(state.orientation_wb, "state.orientation_wb");
  require::finite(state.linear_momentum_w, "state.linear_momentum_w");
  require::finite(state.angular_momentum_w, "state.angular_momentum_w");
  require::that(body.movable() ||
                    (state.linear_momentum_w.isZero(0.0) && state.angular_momentum_w.isZero(0.0)),
                "an immovable body was given momentum: expected none");
  try {
    if (body.movable())
      require_motion_limits(body, state.position_w, velocity(body, state),
                            angular_velocity(body, state));
    else
      require_motion_limits(body, state.position_w, Vec3::Zero(), Vec3::Zero());
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    refuse("body \"" + std::string(name) + "\": " + text.substr(text.find(' ') + 1));
  }
}

BodyProperties box_properties(const Vec3& size, double mass, double friction, double restitution) {
  require_surface(friction, restitution);
  require_size(size);
  require::positive(mass, "mass");
  require::within(mass, tolerance::smallest_mass, tolerance::largest_mass, "mass");
  BodyProperties body{.size = size, .mass = mass, .inverse_mass = 1.0 / mass};
  const Vec3 square = size.cwiseProduct(size);
  body.inertia_b =
      mass / 12.0 * Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  body.inverse_inertia_b = body.inertia_b.cwiseInverse();
  body.friction = friction;
  body.restitution = restitution;
  require_moment(body.inertia_b.minCoeff(), "smallest", body);
  require_moment(body.inertia_b.maxCoeff(), "largest", body);
  return body;
}

BodyProperties fixed_box_properties(const Vec3& size, double friction, double restitution) {
  require_size(size);
  return immovable(Shape::box, size, friction, restitution);
}

BodyProperties ground_properties(double friction, double restitution) {
  return immovable(Shape::ground, Vec3::Zero(), friction, restitution);
}

BodyState make_state(const BodyProperties& body, const Vec3& position_w, const Quat& orientation_wb,
                     const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  require::finite(position_w, "position_w");
  require::finite(velocity_w, "velocity_w");
  require::finite(angular_velocity_w, "angular_velocity_w");
  require::unit(orientation_wb, "orientation_wb");
  BodyState state{.position_w = position_w, .orientation_wb = orientation_wb};
  if (!body.movable()) {
    require::that(velocity_w.isZero(0.0) && angular_velocity_w.isZero(0.0),
                  "an immovable body was given a velocity: expected none");
    return state;
  }
  state.linear_momentum_w = body.mass * velocity_w;
  state.angular_momentum_w = angular_momentum(body, orientation_wb, angular_velocity_w);
  return state;
}

Vec3 velocity(const BodyProperties& body, const BodyState& state) {
  return body.inverse_mass * state.linear_momentum_w;
}

// From right to left: two rotations of a vector, no product of matrices.
Vec3 angular_momentum(const BodyProperties& body, const Mat3& axes_w,
                      const Vec3& angular_velocity_w) {
  const Vec3 angular_velocity_b = axes_w.transpose() * angular_velocity_w;
  return axes_w * body.inertia_b.cwiseProduct(angular_velocity_b);
}

Vec3 angular_momentum(const BodyProperties& body, const Quat& orientation_wb,
                      const Vec3& angular_velocity_w) {
  return angular_momentum(body, orientation_wb.toRotationMatrix(), angular_velocity_w);
}

Vec3 angular_velocity(const BodyProperties& body, const BodyState& state) {
  const Mat3 rotation_wb = state.orientation_wb.toRotationMatrix();
  const Vec3 angular_momentum_b = rotation_wb.transpose() * state.angular_momentum_w;
  return rotation_wb * body.inverse_inertia_b.cwiseProduct(angular_momentum_b);
}

Mat3 inverse_inertia_w(const BodyProperties& body, const Quat& orientation_wb) {
  // Summed axis by axis, Σ_k r_k r_k' / I_k, each term symmetric to the last bit: so is the sum.
  const Mat3 rotation_wb = orientation_wb.toRotationMatrix();
  Mat3 sum = Mat3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Mat3 outer = rotation_wb.col(k) * rotation_wb.col(k).transpose();
    sum += body.inverse_inertia_b[k] * outer;
  }
  return sum;
}

Bounds bounds_of(const BodyProperties& body, const BodyState& state, double margin) {
  if (body.shape == Shape::box) return bounds_of(box_of(body, state), margin);
  constexpr double far = std::numeric_limits<double>::infinity();
  return Bounds{Vec3(-far, -far, -far), Vec3(far, margin, far)};
}

double kinetic_energy(const BodyProperties& body, const BodyState& state) {
  // L·ω in the body frame is a sum of squares: it cannot round to below 0.
  const Vec3 angular_momentum_b =
      state.orientation_wb.toRotationMatrix().transpose() * state.angular_momentum_w;
  const double spin =
      body.inverse_inertia_b.dot(angular_momentum_b.cwiseProduct(angular_momentum_b));
  return 0.5 * (body.inverse_mass * state.linear_momentum_w.squaredNorm() + spin);
}

double shortest_edge(const BodyProperties& a, const BodyProperties& b) {
  double edge = std::numeric_limits<double>::infinity();
  for (const BodyProperties* body : {&a, &b})
    if (body->shape == Shape::box) edge = std::min(edge, body->size.minCoeff());
  return edge;
}

}  // namespace tumble
