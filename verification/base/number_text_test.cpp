/// \file
/// \brief Numbers as text, and text as numbers.
#include "tumble/base/number_text.hpp"

#include "support/test.hpp"

#include <clocale>
#include <cstdio>

namespace {

// Puts a locale in which 0.5 is "0,5" in force for as long as it lives, where the machine has one.
class CommaLocale {
 public:
  CommaLocale() {
    for (const char* name :
         {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8", "nl_NL.UTF-8", "sv_SE.UTF-8"})
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale() { std::setlocale(LC_NUMERIC, "C"); }

  [[nodiscard]] static bool in_force() {
    return std::string(std::localeconv()->decimal_point) == ",";
  }
};

}  // namespace

TEST_CASE("A printed number is the shortest that reads back to the same bits",
          "[unit][number_text]") {
  CHECK(shortest_text(0.1) == "0.1");
  CHECK(shortest_text(-0.0) == "-0");
  CHECK(shortest_text(1000.0) == "1000");
  CHECK(shortest_text(1.0 / 3.0) == "0.3333333333333333");
  CHECK(shortest_text(0.1 + 0.2) == "0.30000000000000004");
  CHECK(shortest_text(kInfinity) == "inf");
  CHECK(shortest_text(-kInfinity) == "-inf");
  for (const double x : {5e-324, 1.7976931348623157e308, 2.2250738585072014e-308, 1e23, -0.1})
    CHECK(parse_number(shortest_text(x)) == x);
}

TEST_CASE("A number has the digits and decimals asked for, as printf writes them",
          "[unit][number_text]") {
  for (const double x : {0.0, -0.0, 0.1, 1.0 / 3.0, 2.5, 1e6, 123456.0, 1e-5, 1e23, 5e-324, -7.0}) {
    char expected[400];
    std::snprintf(expected, sizeof expected, "%.4g", x);
    CHECK(rounded_text(x, 4) == expected);
    std::snprintf(expected, sizeof expected, "%.17g", x);
    CHECK(rounded_text(x, 17) == expected);
    std::snprintf(expected, sizeof expected, "%.2f", x + 0.0);  // without the sign of -0.0
    CHECK(fixed_text(x, 2) == expected);
  }
  const double largest = std::numeric_limits<double>::max();
  CHECK(fixed_text(-largest, 17).size() == 1 + 309 + 1 + 17);
}

TEST_CASE("What is no number is written alike on every machine", "[unit][number_text]") {
  for (const double sign : {1.0, -1.0}) {
    CHECK(shortest_text(std::copysign(kNan, sign)) == "nan");
    CHECK(rounded_text(std::copysign(kNan, sign), 3) == "nan");
    CHECK(fixed_text(std::copysign(kNan, sign), 3) == "nan");
  }
  CHECK(fixed_text(-kInfinity, 1) == "-inf");
}

TEST_CASE("A text is read as a number only if it is one from end to end", "[unit][number_text]") {
  CHECK(parse_number("0.1") == 0.1);
  CHECK(parse_number("+3") == 3.0);
  CHECK(parse_number("-1e-3") == -0.001);
  CHECK(parse_number("1E+2") == 100.0);
  CHECK(parse_number(".5") == 0.5);
  CHECK(parse_number("5.") == 5.0);
  for (const char* text : {"", "+", "-", ".", "e5", "1 ", " 1", "1,5", "0x10", "1e", "+-1", "--1",
                           "++1", "five", "nan", "inf", "-infinity", "1e999", "1mm"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("A number is taken off the beginning of a text", "[unit][number_text]") {
  std::string_view text = "+2.5e1mm";
  CHECK(take_number(text) == 25.0);
  CHECK(text == "mm");
  CHECK_FALSE(take_number(text));
  CHECK(text == "mm");
  text = "1em";  // an e without digits is no part of the number
  CHECK(take_number(text) == 1.0);
  CHECK(text == "em");
}

TEST_CASE("A program's locale changes no number", "[unit][number_text]") {
  const CommaLocale locale;
  if (!CommaLocale::in_force()) WARN("skipped: no locale with a decimal comma is installed");
  CHECK(shortest_text(0.5) == "0.5");
  CHECK(rounded_text(0.5, 17) == "0.5");
  CHECK(fixed_text(0.5, 2) == "0.50");
  CHECK(fixed_text(-1e-17, 2) == "0.00");
  CHECK(parse_number("0.5") == 0.5);
}
