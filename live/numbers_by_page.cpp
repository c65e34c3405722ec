/// \file
/// \brief Numbers as text and text as numbers, by the page.
///
/// It takes the place of src/tumble/base/number_text.cpp in the module: the standard library of em++ does
/// not have std::to_chars() for floating point, and what C has instead is a thirtieth of all that a reader has to load.
#include "tumble/base/number_text.hpp"

#include <array>
#include <cmath>

/// \cond
// page/module.js has both.
extern "C" {
// The number that `size` characters begin with; their count goes to `*taken`, 0 if they begin with none.
__attribute__((import_module("page"), import_name("number"))) double page_number(const char* text,
                                                                                 int size,
                                                                                 int* taken);
// Writes a number; digits: significant ones, 0 for as few as read back. Returns the count of characters.
__attribute__((import_module("page"), import_name("text"))) int page_text(double value, int digits,
                                                                          char* out);
}

/// \endcond

namespace tumble {

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> take_number(std::string_view& text) {
  int taken = 0;
  const double value = page_number(text.data(), static_cast<int>(text.size()), &taken);
  if (taken == 0 || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(taken));
  return value;
}

std::string rounded_text(double value, int digits) {
  std::array<char, 32> buffer{};
  const int size = page_text(value, digits, buffer.data());
  return {buffer.data(), static_cast<std::size_t>(size)};
}

std::string shortest_text(double value) { return rounded_text(value, 0); }

}  // namespace tumble
