/// \file
/// \brief Numbers as text and text as numbers, in every locale the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tumble {

/// Reads a text that is a number and nothing else.
///
/// A decimal number as C and TOML write it: `-0.5`, `+3`, `1e-3`. A program's locale changes nothing: with
/// std::strtod, a program that had called setlocale() would read 0 from `0.5` where decimals have a comma.
/// \param text for example "1e-3"
/// \return the nearest double; nothing if it is no number, has anything around it, or is too large or too
///         small for a double
std::optional<double> parse_number(std::string_view text);

/// Takes the number off the beginning of a text, as parse_number() reads it.
/// \param text for example "5ms", which becomes "ms"; unchanged if it does not begin with a number
std::optional<double> take_number(std::string_view& text);

/// The shortest text that reads back to the same bits, for example `0.1`, `1e+06`, `nan`, `-inf`.
std::string shortest_text(double value);

/// A text with so many significant digits as printf's `%.{digits}g` has.
/// \param digits  1 to 17; with 17 every number reads back to the same bits
/// \return for example `0.333`, `nan`, `-inf`
std::string rounded_text(double value, int digits);

/// A text with so many decimals as printf's `%.{decimals}f` has, but without the sign of a zero.
/// \param decimals  0 to 17
/// \return for example `0.50`, `nan`, `-inf`
std::string fixed_text(double value, int decimals);

}  // namespace tumble
