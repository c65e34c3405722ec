/// \file
/// \brief Exponential, logarithm and power.
//
// The power needs its logarithm to 65 bits: an error there is multiplied by up to 745 on its way
// through the exponential. So one logarithm is computed as a pair of doubles, one exponential
// takes such a pair, and the three functions are these two and their composition.
#include "tumble/math/double_double.hpp"
#include "tumble/math/elementary.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace tumble::elementary {
namespace {

using double_double::nan;
using double_double::Pair;
using double_double::series;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ln 2 cut into 40 bits, whose product with any exponent of two is exact, and 53 more.
constexpr double ln2_high = 0x1.62e42fefa2p-1;
constexpr double ln2_low = 0x1.9ef35793c7673p-41;

// e^x overflows above the one (ln of the largest double is 709.78) and rounds to 0 below the other
// (ln of half the smallest is -745.13).
constexpr double overflow_limit = 709.79;
constexpr double underflow_limit = -745.14;

// m 2^k for m near 1. Away from the ends 2^k is made from its bits, faster than std::ldexp.
double times_power_of_two(double m, int k) {
  if (k < -1021 || k > 1022) return std::ldexp(m, k);
  const std::uint64_t bits = static_cast<std::uint64_t>(k + 1023) << 52U;
  double power = 0.0;
  std::memcpy(&power, &bits, sizeof power);
  return m * power;
}

// e^(x.high + x.low) = 2^k e^r with |r| <= ln(2)/2 and
// e^r = 1 + r + r² (1/2! + r/3! + ...). The first term left out, r^14/14!, is below 2^-57; the
// rounding error of 1 + r is put back, which keeps the whole within 0.6 units in the last place.
double exp_of(const Pair& x) {
  constexpr double c[] = {1.0 / 2.0,       1.0 / 6.0,        1.0 / 24.0,        1.0 / 120.0,
                          1.0 / 720.0,     1.0 / 5040.0,     1.0 / 40320.0,     1.0 / 362880.0,
                          1.0 / 3628800.0, 1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0};
  if (x.high > overflow_limit) return infinity;
  if (x.high < underflow_limit) return 0.0;

  constexpr double inverse_ln2 = 1.4426950408889634;
  const int exponent = static_cast<int>(x.high * inverse_ln2 + std::copysign(0.5, x.high));
  const double k = exponent;
  const Pair first = double_double::sum(x.high - k * ln2_high, -k * ln2_low);
  const Pair r = double_double::sum(first.high, first.low + x.low);

  const Pair start = double_double::ordered_sum(1.0, r.high);
  const double tail = r.low * start.high + r.high * r.high * series(c, r.high);
  return times_power_of_two(start.high + (start.low + tail), exponent);
}

// ln x for finite x > 0, to about 2^-65 of its size.
//
// x = 2^k m with √½ <= m < √2, and with s = (m - 1)/(m + 1), |s| <= 0.1716,
// ln m = 2 (s + s³/3 + s⁵/5 + ...). The first two terms are pairs; of the others plain doubles
// lose 2^-53 of less than 2^-12 of the sum. The first term left out is below 2^-70 of the sum.
Pair log_of(double x) {
  constexpr double c[] = {2.0 / 5.0,  2.0 / 7.0,  2.0 / 9.0,  2.0 / 11.0, 2.0 / 13.0, 2.0 / 15.0,
                          2.0 / 17.0, 2.0 / 19.0, 2.0 / 21.0, 2.0 / 23.0, 2.0 / 25.0};
  constexpr Pair two_thirds{0x1.5555555555555p-1, 0x1.5555555555555p-55};
  constexpr double root_half = 0.70710678118654752;

  int k = 0;
  double m = std::frexp(x, &k);
  if (m < root_half) {
    m *= 2.0;
    --k;
  }
  const Pair s = double_double::quotient({m - 1.0, 0.0}, double_double::sum(m, 1.0));
  const Pair square = double_double::product(s, s);
  const Pair cube = double_double::product(square, s);
  const double z = square.high;
  const Pair third = double_double::product(cube, two_thirds);
  const Pair tail =
      double_double::ordered_sum(third.high, third.low + cube.high * z * series(c, z));
  const Pair of_m = double_double::sum(double_double::scaled(s, 2.0), tail);
  return double_double::sum(Pair{k * ln2_high, k * ln2_low}, of_m);
}

// What C prescribes for 0, infinity and negative numbers to a power. The exponent is not 0 and
// nothing is NaN.
double special_power(double base, double exponent, bool odd) {
  const double size = std::abs(base);
  if (std::isinf(exponent)) {
    if (size == 1.0) return 1.0;
    return (size > 1.0) == (exponent > 0.0) ? infinity : 0.0;
  }
  // The base is 0 or infinite; it keeps its sign under an odd exponent.
  const double result = (size == 0.0) == (exponent > 0.0) ? 0.0 : infinity;
  return odd ? std::copysign(result, base) : result;
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return x;
  return exp_of({x, 0.0});
}

double log(double x) {
  if (std::isnan(x) || x == infinity) return x;
  if (x == 0.0) return -infinity;
  if (x < 0.0) return nan;
  const Pair result = log_of(x);
  return result.high + result.low;
}

double pow(double base, double exponent) {
  if (exponent == 0.0 || base == 1.0) return 1.0;
  if (std::isnan(base) || std::isnan(exponent)) return nan;

  const bool whole = std::floor(exponent) == exponent;
  const bool odd = whole && std::fmod(exponent, 2.0) != 0.0;
  if (base == 0.0 || std::isinf(base) || std::isinf(exponent))
    return special_power(base, exponent, odd);
  if (base < 0.0 && !whole) return nan;
  const double sign = base < 0.0 && odd ? -1.0 : 1.0;

  // size^y = e^(y ln size). A product beyond the limits is infinite or 0 whatever its low part;
  // letting it go on would overflow when it is split.
  const Pair ln = log_of(std::abs(base));
  const double rough = exponent * ln.high;
  if (rough > overflow_limit) return sign * infinity;
  if (rough < underflow_limit) return sign * 0.0;
  return sign * exp_of(double_double::product({exponent, 0.0}, ln));
}

}  // namespace tumble::elementary
