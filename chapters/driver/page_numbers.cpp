/// \file
/// \brief Whether the numbers in a chapter's text are still those that were computed.
#include "driver/page_numbers.hpp"

#include "driver/csv.hpp"

#include <cmath>
#include <regex>

namespace tumble::chapters {
namespace {

// Half a unit of the last digit that is written, and a little for the way to decimals.
double rounding_of(const std::string& digits) {
  const std::size_t exponent = digits.find('e');
  const std::string mantissa = digits.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  const double power =
      exponent == std::string::npos ? 0.0 : read_number(digits.substr(exponent + 1));
  return 0.5000001 * std::pow(10.0, power - static_cast<double>(decimals));
}

// Markdown takes a whole number with a full stop or a bracket after it, first in its line, for an item of a list.
bool looks_like_a_list(const std::smatch& match) {
  const std::string before = match.prefix();
  const std::string after = match.suffix();
  const std::string written = match[1];
  return !match[2].matched && written.find_first_not_of("0123456789") == std::string::npos &&
         (before.empty() || before.back() == '\n') && after.size() > 1 &&
         (after[0] == '.' || after[0] == ')') && after[1] == ' ';
}

}  // namespace

std::vector<std::string> stale_numbers(const std::string& page, const std::string& name,
                                       const std::vector<DrawnFigure>& figures) {
  static const std::regex form(R"(([^\s|(]+)( per cent| %)?\s?<!--\s*(\w+):\s*([^>]*?)\s*-->)");
  std::vector<std::string> messages;
  for (std::sregex_iterator it(page.begin(), page.end(), form), end; it != end; ++it) {
    const std::smatch& match = *it;
    const std::string written = match[1];
    const std::string where = name + ": " + written + match[2].str() + " (" + match[3].str() +
                              ", " + match[4].str() + "): ";
    const double value = read_number(written);
    if (std::isnan(value)) {
      messages.push_back(where + "a comment about a number follows a number");
      continue;
    }
    if (looks_like_a_list(match))
      messages.push_back(where +
                         "begins a line and would be shown as a list: put a word before it");
    const CheckedNumber* number = number_of(figure_of(figures, match[3]), match[4]);
    if (number == nullptr) {
      messages.push_back(where + "no figure has this number");
      continue;
    }
    if (!number->compared) continue;
    const double scale = match[2].matched ? 100.0 : 1.0;
    if (!(std::abs(scale * number->value - value) <= rounding_of(written)))  // true for NaN
      messages.push_back(where + "computed is " + short_text(scale * number->value));
  }
  return messages;
}

}  // namespace tumble::chapters
