/// \file
/// \brief Numbers of twice the precision, as unevaluated sums of two doubles.
#pragma once

#include <limits>

/// Arithmetic with the rounding error kept.
///
/// The error of a sum or product of two doubles is itself a double (barring overflow and
/// underflow), and a few more operations find it. The elementary functions carry it where it would
/// otherwise cost the last bit of a result.
/// \see Dekker, "A floating-point technique for extending the available precision",
///      Numerische Mathematik 18 (1971); Knuth, The Art of Computer Programming, 4.2.2.
namespace tumble::double_double {

/// What functions return where they are not defined.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The number high + low, where low is about a rounding error of high.
struct Pair {
  double high = 0.0;  ///< the number rounded to a double, or nearly
  double low = 0.0;   ///< the remainder
};

/// a + b exactly, for |a| >= |b| or a = 0: the sum and its error.
constexpr Pair ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly: the sum and its error.
constexpr Pair sum(double a, double b) {
  const double sum = a + b;
  const double b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// a b exactly; both factors below 2^996.
///
/// Each factor is split into halves of 26 bits, whose products are exact.
constexpr Pair product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double a_far = splitter * a;
  const double a_high = a_far - (a_far - a);
  const double a_low = a - a_high;
  const double b_far = splitter * b;
  const double b_high = b_far - (b_far - b);
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// a + b to about 104 bits of the larger one.
constexpr Pair sum(const Pair& a, const Pair& b) {
  const Pair s = sum(a.high, b.high);
  return ordered_sum(s.high, s.low + (a.low + b.low));
}

/// a b to about 104 bits.
constexpr Pair product(const Pair& a, const Pair& b) {
  const Pair p = product(a.high, b.high);
  return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// a / b to about 104 bits.
/// \param b  the divisor, not 0
constexpr Pair quotient(const Pair& a, const Pair& b) {
  const double reciprocal = 1.0 / b.high;  // good enough for the correction, and not waited for
  const double q = a.high / b.high;
  const Pair back = product(q, b.high);
  const double rest = ((a.high - back.high) - back.low) + (a.low - q * b.low);
  return ordered_sum(q, rest * reciprocal);
}

/// a times a power of two, exactly.
/// \param power  a power of two, with any sign, or 0
constexpr Pair scaled(const Pair& a, double power) { return {a.high * power, a.low * power}; }

/// Σ c_k z^k with the even and the odd terms summed side by side, which halves the waiting.
/// \tparam N how many coefficients, at least 2
template <int N>
constexpr double series(const double (&c)[N], double z) {
  const double square = z * z;
  double last = c[N - 1];
  double other = c[N - 2];
  for (int k = N - 3; k >= 0; k -= 2) {
    last = last * square + c[k];
    if (k > 0) other = other * square + c[k - 1];
  }
  // `last` holds the powers of the parity of N - 1.
  return N % 2 == 1 ? last + z * other : other + z * last;
}

}  // namespace tumble::double_double
