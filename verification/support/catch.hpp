/// \file
/// \brief Catch2, version 2 (Debian 12) or 3, and the parts of the standard library that most tests use.
#pragma once

// An exception in an assertion ends its test case, so assertions compile to less.
#define CATCH_CONFIG_FAST_COMPILE
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using Catch::Matchers::Contains;

// Numbers to try where others are expected.
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How often each promise was broken in a test of many cases; CHECK(wrong == Failures{}) shows them all.
using Failures = std::map<std::string, int>;

// A number to compare with that allows for what its margin says and nothing else: `CHECK(x == near(1.0, 1e-12))`.
//
// Catch2's own Approx accepts 1.2e-5 of the value on top of every margin.
inline Approx near(double value, double margin = 0.0) {
  return Approx(value).epsilon(0.0).margin(margin);
}

// The message with which an action refuses what it was given; empty if it does not refuse.
template <class Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}
