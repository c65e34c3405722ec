/// \file
/// \brief How a caller's mistake is refused.
#include "tumble/base/error.hpp"

#include "tumble/base/tolerance.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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
  return out.append(require::text(v.x()))
      .append(", ")
      .append(require::text(v.y()))
      .append(", ")
      .append(require::text(v.z()))
      .append(")");
}

}  // namespace

std::string text(double value) {
  std::array<char, 32> buffer{};
  // 17 digits always read back; fewer often do. std::to_chars would say this in one call, but
  // the standard library of em++ 3.1.6 does not have it for floating point.
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    if (std::strtod(buffer.data(), nullptr) == value) break;
  }
  return buffer.data();
}

void finite(double value, std::string_view name) {
  if (!std::isfinite(value)) refuse(name, text(value), "a finite number");
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
  if (!(std::isfinite(value) && value > 0.0)) refuse(name, text(value), "a finite number above 0");
}

void not_negative(double value, std::string_view name) {
  if (!(std::isfinite(value) && value >= 0.0))
    refuse(name, text(value), "a finite number, 0 or above");
}

void within(double value, double low, double high, std::string_view name) {
  if (!(value >= low && value <= high))
    refuse(name, text(value), "a number from " + text(low) + " to " + text(high));
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
  refuse(name, "(w " + text(value.w()) + ", x y z " + text(Vec3(value.vec())) + ")",
         "a quaternion of length 1: normalise it first");
}

void that(bool condition, std::string_view message) {
  if (!condition) throw std::invalid_argument("tumble: " + std::string(message));
}

}  // namespace tumble::require
