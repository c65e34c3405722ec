/// \file
/// \brief Sine, cosine and their inverses.
//
// All coefficients are those of the Taylor series, written as the fractions they are: a few terms
// more than a fitted polynomial would need, and nothing to take on trust. Arguments are first
// brought to where the series are short.
#include "tumble/math/elementary.hpp"

#include "tumble/math/double_double.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::elementary {
namespace {

using double_double::nan;
using double_double::Pair;
using double_double::series;

// π/2 and π as pairs: the nearest double, and the nearest double to what it misses.
constexpr Pair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Pair pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// An angle as quarter turns and a rest of at most an eighth turn (π/4).
struct Reduced {
  Pair rest;
  int quarters = 0;  // modulo 4
};

// Cody and Waite's reduction. π/2 is the sum of three pieces of 33 bits and a fourth of 53 (cut
// from π computed to 400 bits), so that `count` times each of the first three is exact for
// counts up to 2^20 and subtracting them loses nothing. The doubles nearest to multiples of π/2
// below that limit are off by more than 1e-17; what the fourth piece lacks is below 1e-41.
Reduced reduced(double x) {
  constexpr double exact_limit = 0x1p20 * 1.5707963267948966;
  constexpr double quarters_per_radian = 0.63661977236758134;  // 2/π
  if (std::abs(x) <= 0.5 * half_pi.high) return {{x, 0.0}, 0};

  // Far out, the double next to 2π stands for 2π, and fmod is exact: the result belongs to an
  // angle that differs from x by the relative error of that double, 4e-17, less than x's own.
  if (std::abs(x) > exact_limit) x = std::fmod(x, 2.0 * pi.high);

  const int turns = static_cast<int>(x * quarters_per_radian + std::copysign(0.5, x));
  const double count = turns;
  const double first = x - count * 0x1.921fb544p+0;  // exact: the two are close
  const Pair second = double_double::sum(first, -count * 0x1.0b4611a6p-34);
  const Pair third = double_double::sum(second.high, -count * 0x1.3198a2ep-69);
  const double last = (second.low + third.low) - count * 0x1.b839a252049c1p-104;
  return {double_double::ordered_sum(third.high, last), turns & 3};
}

// (sin r - r)/r³ with z = r², for |r| <= π/4. The first term left out is below 2^-63.
double sine_tail(double z) {
  constexpr double c[] = {-1.0 / 6.0,          1.0 / 120.0,         -1.0 / 5040.0,
                          1.0 / 362880.0,      -1.0 / 39916800.0,   1.0 / 6227020800.0,
                          -1.0 / 1307674368e3, 1.0 / 355687428096e3};
  return series(c, z);
}

// (cos r - 1 + r²/2)/r⁴ with z = r², for |r| <= π/4. The first term left out is below 2^-58.
double cosine_tail(double z) {
  constexpr double c[] = {1.0 / 24.0,         -1.0 / 720.0,      1.0 / 40320.0,
                          -1.0 / 3628800.0,   1.0 / 479001600.0, -1.0 / 87178291200.0,
                          1.0 / 20922789888e3};
  return series(c, z);
}

// sin(r + l) = sin r + l cos r, where l is so small that 1 - r²/2 does for the cosine.
double sine_of(const Pair& r) {
  const double z = r.high * r.high;
  return r.high + (r.low * (1.0 - 0.5 * z) + r.high * (z * sine_tail(z)));
}

// cos(r + l) = cos r - l sin r, with r for the sine. The rounding error of 1 - r²/2 is put back.
double cosine_of(const Pair& r) {
  const double z = r.high * r.high;
  const Pair start = double_double::ordered_sum(1.0, -0.5 * z);
  return start.high + (start.low + (z * z * cosine_tail(z) - r.high * r.low));
}

// (atan u - u)/u³ with z = u², for |u| <= 0.2361. The first term left out is below 2^-58.
double arc_tail(double z) {
  constexpr double c[] = {-1.0 / 3.0,  1.0 / 5.0,  -1.0 / 7.0,  1.0 / 9.0,
                          -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0, 1.0 / 17.0,
                          -1.0 / 19.0, 1.0 / 21.0, -1.0 / 23.0, 1.0 / 25.0};
  return series(c, z);
}

// The angle of the point (x, y) for y >= 0, 0 to π. Not both are 0; sizes below 2^990.
double angle_of(const Pair& y, const Pair& x) {
  // Mirrored into the eighth turn 0 <= steep <= flat.
  const bool left = std::signbit(x.high);
  const Pair x_size = double_double::scaled(x, left ? -1.0 : 1.0);
  const bool upper = y.high > x_size.high;
  const Pair& flat = upper ? y : x_size;
  const Pair& steep = upper ? x_size : y;

  // Turned back by the nearest of the angles atan(0), atan(1/2), atan(1), at most atan(0.2361)
  // remains: the series then needs 12 terms. The limits are the tangents of the mean angles.
  constexpr Pair angles[] = {{0.0, 0.0},
                             {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                             {0.5 * half_pi.high, 0.5 * half_pi.low}};
  const double ratio = steep.high / flat.high;
  const int nearest = ratio < 0.2361 ? 0 : ratio < 0.7208 ? 1 : 2;
  const double slope = 0.5 * nearest;
  const Pair u =
      double_double::quotient(double_double::sum(steep, double_double::scaled(flat, -slope)),
                              double_double::sum(flat, double_double::scaled(steep, slope)));

  // angle = nearest + atan u, and then the mirrors undone, with rounding errors kept throughout.
  const double z = u.high * u.high;
  Pair angle = double_double::sum(angles[nearest], {u.high, u.low + u.high * (z * arc_tail(z))});
  if (upper) angle = double_double::sum(half_pi, double_double::scaled(angle, -1.0));
  if (left) angle = double_double::sum(pi, double_double::scaled(angle, -1.0));
  return angle.high + angle.low;
}

// √(1 - x²) for |x| <= 1: one Newton step after the rounded root doubles its digits.
Pair other_side(double x) {
  const Pair square = double_double::product(x, x);
  const Pair rest = double_double::sum(1.0, -square.high);
  const Pair w = double_double::ordered_sum(rest.high, rest.low - square.low);
  if (w.high == 0.0) return {0.0, 0.0};
  const double root = std::sqrt(w.high);
  const Pair back = double_double::product(root, root);
  return {root, ((w.high - back.high) - back.low + w.low) / (2.0 * root)};
}

}  // namespace

SinCos sincos(double x) {
  if (!std::isfinite(x)) return {nan, nan};
  if (x == 0.0) return {x, 1.0};  // keeps the sign
  const Reduced angle = reduced(x);
  const double s = sine_of(angle.rest);
  const double c = cosine_of(angle.rest);
  // A quarter turn takes (cos, sin) to (-sin, cos).
  const bool odd = (angle.quarters & 1) != 0;
  const double turned_sin = odd ? c : s;
  const double turned_cos = odd ? s : c;
  return {(angle.quarters & 2) != 0 ? -turned_sin : turned_sin,
          ((angle.quarters + 1) & 2) != 0 ? -turned_cos : turned_cos};
}

double sin(double x) {
  if (!std::isfinite(x)) return nan;
  if (x == 0.0) return x;
  const Reduced angle = reduced(x);
  const double size = (angle.quarters & 1) != 0 ? cosine_of(angle.rest) : sine_of(angle.rest);
  return (angle.quarters & 2) != 0 ? -size : size;
}

double cos(double x) {
  if (!std::isfinite(x)) return nan;
  const Reduced angle = reduced(x);
  const double size = (angle.quarters & 1) != 0 ? sine_of(angle.rest) : cosine_of(angle.rest);
  return ((angle.quarters + 1) & 2) != 0 ? -size : size;
}

double sinc(double x) {
  if (std::isinf(x)) return 0.0;
  if (std::abs(x) > 0.5 * half_pi.high) return sin(x) / x;
  const double z = x * x;
  return 1.0 + z * sine_tail(z);
}

double asin(double x) {
  if (!(std::abs(x) <= 1.0)) return nan;
  return std::copysign(angle_of({std::abs(x), 0.0}, other_side(x)), x);
}

double acos(double x) {
  if (!(std::abs(x) <= 1.0)) return nan;
  return angle_of(other_side(x), {x, 0.0});
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return nan;

  // Beside an infinity the other number is as good as 0; two infinities make a diagonal.
  if (std::isinf(x) || std::isinf(y)) {
    x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
    y = std::copysign(std::isinf(y) ? 1.0 : 0.0, y);
  }
  if (x == 0.0 && y == 0.0) return std::copysign(std::signbit(x) ? pi.high : 0.0, y);

  // Close to the positive x axis the angle is the slope, correctly rounded however small.
  if (x > 0.0 && std::abs(y) < 0x1p-60 * x) return y / x;

  // Very large and very small points move to where pairs neither overflow nor underflow.
  const double size = std::max(std::abs(x), std::abs(y));
  if (size > 0x1p900 || size < 0x1p-900) {
    int exponent = 0;
    std::frexp(size, &exponent);
    x = std::ldexp(x, -exponent);
    y = std::ldexp(y, -exponent);
  }
  return std::copysign(angle_of({std::abs(y), 0.0}, {x, 0.0}), y);
}

}  // namespace tumble::elementary
