/// \file
/// \brief Catch2, version 2 (Debian 12) or 3.
#pragma once

// An exception in an assertion ends its test case, so assertions compile to less.
#define CATCH_CONFIG_FAST_COMPILE
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

// A number to compare with that allows for what its margin says and nothing else.
//
// Catch2's own Approx accepts 1.2e-5 of the value on top of every margin. Write
// `CHECK(x == near(1.0).margin(1e-12))`.
inline Approx near(double value) { return Approx(value).epsilon(0.0); }
