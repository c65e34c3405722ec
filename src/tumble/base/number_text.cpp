/// \file
/// \brief Numbers as text and text as numbers, by functions that know no locale.
#include "tumble/base/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace tumble {
namespace {

// The longest is the largest double with 17 decimals: a sign, 309 digits, a point, decimals.
using Buffer = std::array<char, 336>;

// std::to_chars, but for the sign of what is no number: that depends on the machine.
template <class... Form>
std::string text_of(double value, Form... form) {
  if (std::isnan(value)) return "nan";
  Buffer buffer;
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, form...);
  return {buffer.data(), written.ptr};
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> take_number(std::string_view& text) {
  // from_chars takes a minus but no plus.
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return value;
}

std::string shortest_text(double value) { return text_of(value); }

std::string rounded_text(double value, int digits) {
  return text_of(value, std::chars_format::general, digits);
}

std::string fixed_text(double value, int decimals) {
  std::string text = text_of(value, std::chars_format::fixed, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

}  // namespace tumble
