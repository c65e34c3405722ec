/// \file
/// \brief The limits on where a body may be, and how fast.
#include "tumble/dynamics/motion_limits.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/tolerances.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble {
namespace {

[[noreturn]] void refuse_motion(std::string_view name, const Vec3& value,
                                const std::string& wanted) {
  std::string text(name);
  text.append(" = [").append(shortest_text(value.x())).append(", ");
  text.append(shortest_text(value.y())).append(", ").append(shortest_text(value.z()));
  throw std::invalid_argument("tumble: " + text.append("]: expected ").append(wanted));
}

std::string speed_limit() {
  return "at most " + shortest_text(tolerance::largest_speed) + " m/s, the speed of light";
}

}  // namespace

void require_motion_limits(const BodyProperties& body, const Vec3& position_w,
                           const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  require::finite(position_w, "position_w");
  require::finite(velocity_w, "velocity_w");
  require::finite(angular_velocity_w, "angular_velocity_w");
  const double edge = body.size.minCoeff();
  if (position_w.cwiseAbs().maxCoeff() > tolerance::farthest * edge)
    refuse_motion("position_w", position_w,
                  "coordinates up to " + shortest_text(tolerance::farthest) +
                      " times the shortest edge, which is " + shortest_text(edge) +
                      " m: move the scene to the origin, or make the edge longer");
  // Coordinates first: the squares of larger ones would not be numbers.
  if (velocity_w.cwiseAbs().maxCoeff() > tolerance::largest_speed ||
      velocity_w.norm() > tolerance::largest_speed)
    refuse_motion("velocity_w", velocity_w, speed_limit() + ": make it slower");
  const double fastest = tolerance::largest_speed / (0.5 * body.size.norm());
  if (angular_velocity_w.cwiseAbs().maxCoeff() > fastest || angular_velocity_w.norm() > fastest)
    refuse_motion("angular_velocity_w", angular_velocity_w,
                  "at most " + shortest_text(fastest) + " rad/s, at which a corner moves at " +
                      shortest_text(tolerance::largest_speed) +
                      " m/s, the speed of light: make the box spin slower, or smaller");
}

void require_motion_limits(const BodyProperties& body, const BodyState& state) {
  if (body.movable())
    require_motion_limits(body, state.position_w, velocity(body, state),
                          angular_velocity(body, state));
  else
    require_motion_limits(body, state.position_w, Vec3::Zero(), Vec3::Zero());
}

void require_friction(double friction) {
  require::not_negative(friction, "friction");
  if (friction <= tolerance::largest_friction) return;
  require::that(false, "friction = " + shortest_text(friction) + ": expected at most " +
                           shortest_text(tolerance::largest_friction) +
                           ", which no slope makes slide: give that for a rough surface");
}

void require_gravity(const Vec3& gravity_w) {
  require::finite(gravity_w, "gravity");
  if (gravity_w.cwiseAbs().maxCoeff() > tolerance::largest_speed ||
      gravity_w.norm() > tolerance::largest_speed)
    refuse_motion("gravity", gravity_w,
                  "at most " + shortest_text(tolerance::largest_speed) +
                      " m/s², which leads to the speed of light in a second: make it weaker");
}

void require_step_limits(double dt, double time) {
  require::positive(dt, "dt");
  require::within(dt, tolerance::shortest_step, tolerance::longest_step, "dt");
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  if (dt * tolerance::step_share >= rounding * time) return;
  require::that(false, "dt = " + shortest_text(dt) + ": after " + shortest_text(time) +
                           " s expected more than " +
                           shortest_text(rounding * time / tolerance::step_share) +
                           " s, since the time is not resolved further");
}

}  // namespace tumble
