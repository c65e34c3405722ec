/// \file
/// \brief Refusal of a caller's mistake.
#include "tumble/base/error.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"

#include <cmath>
#include <stdexcept>

namespace tumble::require {
namespace {

[[noreturn]] void refuse(std::string_view name, const std::string& value, std::string_view wanted) {
  throw std::invalid_argument("tumble: " + std::string(name) + " = " + value + ": expected " +
                              std::string(wanted));
}

std::string text(const Vec3& v) {
  std::string out =
      "(";  // appended to, since "(" + string warns falsely in g++ 12 (its bug 105651)
  return out.append(shortest_text(v.x()))
      .append(", ")
      .append(shortest_text(v.y()))
      .append(", ")
      .append(shortest_text(v.z()))
      .append(")");
}

}  // namespace

void finite(double value, std::string_view name) {
  if (!std::isfinite(value)) refuse(name, shortest_text(value), "a finite number");
}

void finite(const Vec3& value, std::string_view name) {
  if (!value.allFinite()) refuse(name, text(value), "three finite numbers");
}

void finite(const Mat3& value, std::string_view name) {
  if (value.allFinite()) return;
  refuse(name, text(Vec3(value.row(0))) + text(Vec3(value.row(1))) + text(Vec3(value.row(2))),
         "nine finite numbers");
}

void positive(double value, std::string_view name) {
  if (!(std::isfinite(value) && value > 0.0))
    refuse(name, shortest_text(value), "a finite number above 0");
}

void not_negative(double value, std::string_view name) {
  if (!(std::isfinite(value) && value >= 0.0))
    refuse(name, shortest_text(value), "a finite number, 0 or above");
}

void within(double value, double low, double high, std::string_view name) {
  if (!(value >= low && value <= high))
    refuse(name, shortest_text(value),
           "a number from " + shortest_text(low) + " to " + shortest_text(high));
}

void unit(const Vec3& value, std::string_view name) {
  finite(value, name);
  if (std::abs(value.norm() - 1.0) > tolerance::unit_length)
    refuse(name, text(value), "a vector of length 1: normalise it first");
}

void unit(const Quat& value, std::string_view name) {
  const bool good =
      value.coeffs().allFinite() && std::abs(value.norm() - 1.0) <= tolerance::unit_length;
  if (good) return;
  refuse(name, "(w " + shortest_text(value.w()) + ", x y z " + text(Vec3(value.vec())) + ")",
         "a quaternion of length 1: normalise it first");
}

void that(bool condition, std::string_view message) {
  if (!condition) throw std::invalid_argument("tumble: " + std::string(message));
}

}  // namespace tumble::require
