/// \file
/// \brief Refusal of a caller's mistake: with the value, and with the expected one.
#pragma once

#include "tumble/base/types.hpp"

#include <string>
#include <string_view>

namespace tumble {

/// Refuses what a caller asks for.
///
/// Three kinds of failure are kept apart. A caller's mistake throws `std::invalid_argument`,
/// always, from the functions below. A mathematical outcome (no solution, not converged, cap
/// reached) is a status in the result. Our own beliefs are `assert`s of debug builds.
/// \param message  the value and what would be right, for example "rows = -1: give at least 1"
/// \throws std::invalid_argument with the message
[[noreturn]] void refuse(std::string_view message);

/// Three numbers as messages show them, for example `[1, 0, -2.5]`.
std::string vector_text(const Vec3& value);

/// Refuses a value, as "name = value: expected wanted".
/// \throws std::invalid_argument with this message
[[noreturn]] void refuse_value(std::string_view name, std::string_view value,
                               std::string_view wanted);

}  // namespace tumble

/// Checks of arguments, see refuse().
///
/// Each takes the name that a value has in the caller's argument list, for the message.
namespace tumble::require {

/// Refuses a value that is not finite.
void finite(double value, std::string_view name);

/// Refuses a vector with a component that is not finite.
void finite(const Vec3& value, std::string_view name);

/// Refuses a matrix with an entry that is not finite.
void finite(const Mat3& value, std::string_view name);

/// Refuses a value that is not finite and greater than zero.
void positive(double value, std::string_view name);

/// Refuses a value that is not finite and at least zero.
void not_negative(double value, std::string_view name);

/// Refuses a value outside [low, high].
void within(double value, double low, double high, std::string_view name);

/// Refuses a vector whose length is not 1 to within `tolerance::unit_length`.
void unit(const Vec3& value, std::string_view name);

/// Refuses a quaternion whose length is not 1 to within `tolerance::unit_length`.
void unit(const Quat& value, std::string_view name);

/// Refuses whatever does not fulfil a condition.
/// \param message    as refuse() takes it
void that(bool condition, std::string_view message);

}  // namespace tumble::require
