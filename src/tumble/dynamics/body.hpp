/// \file
/// \brief A rigid body: what never changes about it, and its state (thesis 3.1).
#pragma once

#include "tumble/base/types.hpp"
#include "tumble/geometry/box.hpp"

#include <string_view>

namespace tumble {

/// What a body is.
enum class Shape : std::uint8_t {
  box,    ///< an oriented box
  ground  ///< the fixed half-space y <= 0
};

/// The constant part of a body.
///
/// An immovable body has zero inverse mass and zero inverse inertia; its mass is infinite. Every
/// formula uses the inverses, so that immovable bodies need no special case.
struct BodyProperties {
  Shape shape = Shape::box;                      ///< box or ground
  Vec3 size = Vec3::Ones();                      ///< [m] full edge lengths; not used by the ground
  double mass = 1.0;                             ///< [kg] infinite for an immovable body
  double inverse_mass = 1.0;                     ///< [1/kg] 0 for an immovable body
  Vec3 inertia_b = Vec3::Constant(1.0 / 6.0);    ///< [kg m²] principal moments, body frame
  Vec3 inverse_inertia_b = Vec3::Constant(6.0);  ///< [1/(kg m²)] 0 for an immovable body
  double friction = 0.5;                         ///< [-] Coulomb's coefficient, at least 0
  double restitution = 0.0;                      ///< [-] 0 (sticks) to 1 (bounces back)

  /// Whether forces move it; false for an immovable body.
  [[nodiscard]] bool movable() const { return inverse_mass > 0.0; }

  /// Compares all numbers.
  bool operator==(const BodyProperties&) const = default;
};

/// The state of a body: all that changes. The thesis integrates momenta, and so do we.
struct BodyState {
  Vec3 position_w = Vec3::Zero();          ///< [m] centre of mass, world frame
  Quat orientation_wb = Quat::Identity();  ///< [-] body to world, length 1
  Vec3 linear_momentum_w = Vec3::Zero();   ///< [kg m/s] world frame
  Vec3 angular_momentum_w = Vec3::Zero();  ///< [kg m²/s] about the centre of mass, world frame
};

/// Whether all numbers of two states agree; never for a NaN.
[[nodiscard]] inline bool operator==(const BodyState& a, const BodyState& b) {
  return a.position_w == b.position_w && a.orientation_wb.coeffs() == b.orientation_wb.coeffs() &&
         a.linear_momentum_w == b.linear_momentum_w && a.angular_momentum_w == b.angular_momentum_w;
}

/// Whether a state is made of numbers; false if anything in it is infinite or NaN.
[[nodiscard]] inline bool is_finite(const BodyState& state) {
  return state.position_w.allFinite() && state.orientation_wb.coeffs().allFinite() &&
         state.linear_momentum_w.allFinite() && state.angular_momentum_w.allFinite();
}

/// A box of uniform density.
///
/// Principal moments \f$I = \tfrac{m}{12}(h^2+d^2,\; w^2+d^2,\; w^2+h^2)\f$ for size (w, h, d).
/// \param size         [m] full edge lengths, each from tolerance::smallest_edge to largest_value
/// \param mass         [kg] from tolerance::smallest_mass to largest_mass, and so the moments in kg m²
/// \param friction     [-] 0 to tolerance::largest_friction
/// \throws std::invalid_argument naming the value that is out of range
BodyProperties box_properties(const Vec3& size, double mass, double friction = 0.5,
                              double restitution = 0.0);

/// An immovable box.
/// \param size         [m] full edge lengths, each from tolerance::smallest_edge to largest_value
/// \param friction     [-] 0 to tolerance::largest_friction
/// \throws std::invalid_argument naming the value that is out of range
BodyProperties fixed_box_properties(const Vec3& size, double friction = 0.5,
                                    double restitution = 0.0);

/// The immovable half-space y <= 0.
/// \param friction     [-] 0 to tolerance::largest_friction
/// \throws std::invalid_argument naming the value that is out of range
BodyProperties ground_properties(double friction = 0.5, double restitution = 0.0);

/// A state from the velocities that people think in.
/// \param velocity_w          [m/s] of the centre of mass, world frame
/// \return the state: P = m v, L = R I R' ω; momenta of an immovable body are 0
/// \throws std::invalid_argument for a value that is not finite, a quaternion that is not of
///         length 1, or an immovable body with a velocity
BodyState make_state(const BodyProperties& body, const Vec3& position_w,
                     const Quat& orientation_wb = Quat::Identity(),
                     const Vec3& velocity_w = Vec3::Zero(),
                     const Vec3& angular_velocity_w = Vec3::Zero());

/// Refuses a place or a motion that a double does not resolve, or that no body has.
///
/// Coordinates are at most tolerance::farthest times the shortest edge, and no point of a body is faster than
/// tolerance::largest_speed.
/// \param body  a box
/// \throws std::invalid_argument naming the value, the limit and the remedy
/// \verified{Values out of the range of a scene are refused with body, value and remedy}
void require_motion_limits(const BodyProperties& body, const Vec3& position_w,
                           const Vec3& velocity_w, const Vec3& angular_velocity_w);

/// Refuses properties that contradict each other: any code can fill in the struct, and the rest of the library relies on them.
/// \throws std::invalid_argument naming the value and the expected one
void require_valid(const BodyProperties& body);

/// Refuses a state that is not finite, has no orientation, moves an immovable body, or is out of require_motion_limits().
/// \param name  of the body, for messages about limits
/// \throws std::invalid_argument naming the value and the expected one
void require_valid(const BodyProperties& body, const BodyState& state, std::string_view name);

/// Refuses a coefficient of friction or restitution that is none.
/// \param friction     [-] from 0 to tolerance::largest_friction
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_surface(double friction, double restitution);

/// Velocity of the centre of mass, \f$v = P/m\f$ [m/s], world frame; 0 for an immovable body.
Vec3 velocity(const BodyProperties& body, const BodyState& state);

/// Angular velocity, \f$\omega = R\,I_b^{-1} R^{\mathsf T} L\f$.
///
/// It changes while a body tumbles freely although L does not: never store it over a step.
/// \return [rad/s] world frame; 0 for an immovable body
Vec3 angular_velocity(const BodyProperties& body, const BodyState& state);

/// Angular momentum of an angular velocity, \f$L = R\,I_b R^{\mathsf T} \omega\f$.
/// \param axes_w              [-] its axes in the world as columns
/// \return [kg m²/s] world frame
Vec3 angular_momentum(const BodyProperties& body, const Mat3& axes_w,
                      const Vec3& angular_velocity_w);

/// The same of a body whose axes are not known yet.
/// \return [kg m²/s] world frame
Vec3 angular_momentum(const BodyProperties& body, const Quat& orientation_wb,
                      const Vec3& angular_velocity_w);

/// Inverse inertia in the world frame, \f$R\,I_b^{-1} R^{\mathsf T}\f$.
/// \return [1/(kg m²)] symmetric; 0 for an immovable body
Mat3 inverse_inertia_w(const BodyProperties& body, const Quat& orientation_wb);

/// The shortest edge of two bodies, of which the ground has none [m]; infinite for two grounds.
double shortest_edge(const BodyProperties& a, const BodyProperties& b);

/// The body as geometry sees it.
inline Box box_of(const BodyProperties& body, const BodyState& state) {
  return Box{state.position_w, state.orientation_wb.toRotationMatrix(), 0.5 * body.size};
}

/// Axis-aligned bounds of a body, for broad phases.
/// \param margin  [m] how far to widen, at least 0
/// \return of the ground: all of the half-space, reaching to infinity
Bounds bounds_of(const BodyProperties& body, const BodyState& state, double margin = 0.0);

/// Kinetic energy, \f$\tfrac12 P\cdot v + \tfrac12 L\cdot\omega\f$ [J]; 0 for an immovable body.
double kinetic_energy(const BodyProperties& body, const BodyState& state);

}  // namespace tumble
