/// \file
/// \brief Refusal of a caller's mistake.
#include "tumble/base/error.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"

#include <cmath>
#include <stdexcept>

namespace tumble {

std::string vector_text(const Vec3& value) {
  std::string out(1, '[');
  out.append(shortest_text(value.x())).append(", ").append(shortest_text(value.y()));
  return out.append(", ").append(shortest_text(value.z())).append(1, ']');
}

void refuse(std::string_view message) {
  throw std::invalid_argument("tumble: " + std::string(message));
}

void refuse_value(std::string_view name, std::string_view value, std::string_view wanted) {
  std::string message(name);
  refuse(message.append(" = ").append(value).append(": expected ").append(wanted));
}

namespace require {

void finite(double value, std::string_view name) {
  if (!std::isfinite(value)) refuse_value(name, shortest_text(value), "a finite number");
}

void finite(const Vec3& value, std::string_view name) {
  if (!value.allFinite()) refuse_value(name, vector_text(value), "three finite numbers");
}

void finite(const Mat3& value, std::string_view name) {
  if (value.allFinite()) return;
  refuse_value(name,
               vector_text(Vec3(value.row(0))) + vector_text(Vec3(value.row(1))) +
                   vector_text(Vec3(value.row(2))),
               "nine finite numbers");
}

void positive(double value, std::string_view name) {
  if (!(std::isfinite(value) && value > 0.0))
    refuse_value(name, shortest_text(value), "a finite number above 0");
}

void not_negative(double value, std::string_view name) {
  if (!(std::isfinite(value) && value >= 0.0))
    refuse_value(name, shortest_text(value), "a finite number, 0 or above");
}

void within(double value, double low, double high, std::string_view name) {
  if (!(value >= low && value <= high))
    refuse_value(name, shortest_text(value),
                 "a number from " + shortest_text(low) + " to " + shortest_text(high));
}

void unit(const Vec3& value, std::string_view name) {
  finite(value, name);
  if (std::abs(value.norm() - 1.0) > tolerance::unit_length)
    refuse_value(name, vector_text(value), "a vector of length 1: normalise it first");
}

void unit(const Quat& value, std::string_view name) {
  const bool good =
      value.coeffs().allFinite() && std::abs(value.norm() - 1.0) <= tolerance::unit_length;
  if (good) return;
  refuse_value(name,
               "(w " + shortest_text(value.w()) + ", x y z " + vector_text(Vec3(value.vec())) + ")",
               "a quaternion of length 1: normalise it first");
}

void that(bool condition, std::string_view message) {
  if (!condition) refuse(message);
}

}  // namespace require
}  // namespace tumble
