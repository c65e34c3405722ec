/// \file
/// \brief The elementary functions against the long double functions of the C library.
#include "tumble/math/elementary.hpp"

#include "tumble/base/state_hash.hpp"
#include "tumble/math/double_double.hpp"

#include "support/test.hpp"

namespace {

constexpr double pi = 3.14159265358979324;

bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// Distance in units in the last place of the wanted value, subnormal numbers included.
double units(double got, long double want) {
  const double rounded = static_cast<double>(want);
  if (same(got, rounded)) return 0.0;
  if (!std::isfinite(got) || !std::isfinite(rounded)) return kInfinity;
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(1.0L, std::max(exponent, -1021) - 53);
  return static_cast<double>(
      std::fabs(static_cast<long double>(got) - static_cast<long double>(rounded)) / unit);
}

// The largest distance from the correctly rounded value over random arguments in [low, high), or over
// 2 to such exponents. The judge has 11 bits more than a double.
template <typename Ours, typename Judge>
double worst(double low, double high, Ours ours, Judge judge, bool exponents = false) {
  Random random(7);
  double largest = 0.0;
  for (int i = 0; i < 20000; ++i) {
    double x = random.uniform(low, high);
    if (exponents) x = std::exp2(x);
    largest = std::max(largest, units(ours(x), judge(static_cast<long double>(x))));
  }
  return largest;
}

// One unit off the correctly rounded value at most: the promise of the header. Against the exact
// value, measured over two million arguments each: sin, cos 0.83 units, exp, pow 0.68, others 0.60,
// sinc 1.5.
constexpr double promised = 1.0;

}  // namespace

TEST_CASE("Sine and cosine are within one unit in the last place", "[unit][elementary]") {
  using elementary::cos;
  using elementary::sin;
  for (const double range : {0.8, 10.0, 1e3, 1.6e6}) {
    CHECK(worst(
              -range, range, [](double x) { return sin(x); },
              [](long double x) { return std::sin(x); }) <= promised);
    CHECK(worst(
              -range, range, [](double x) { return cos(x); },
              [](long double x) { return std::cos(x); }) <= promised);
  }
  CHECK(worst(
            -300.0, 1.0, [](double x) { return sin(x); }, [](long double x) { return std::sin(x); },
            true) <= promised);
}

TEST_CASE("Sine and cosine keep all digits beside multiples of a quarter turn",
          "[unit][elementary]") {
  // The doubles nearest to k π/2 leave rests down to 1e-17; the judge reduces with 66 bits of π,
  // so the case that is known to all digits is checked exactly: sin(fl(π)) = π - fl(π).
  CHECK(elementary::sin(0x1.921fb54442d18p+1) == 0x1.1a62633145c07p-53);
  CHECK(elementary::cos(0x1.921fb54442d18p+0) == 0x1.1a62633145c07p-54);
  int failures = 0;
  for (int k = 1; k < 1000; ++k) {
    const double x = k * 0x1.921fb54442d18p+0;
    const elementary::SinCos both = elementary::sincos(x);
    if (units(both.sin, std::sin(static_cast<long double>(x))) > promised) ++failures;
    if (units(both.cos, std::cos(static_cast<long double>(x))) > promised) ++failures;
    if (both.sin != elementary::sin(x) || both.cos != elementary::cos(x)) ++failures;
  }
  CHECK(failures == 0);
}

TEST_CASE("Far out, sine belongs to an angle within the rounding of the argument",
          "[unit][elementary]") {
  int failures = 0;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::exp2(random.uniform(21.0, 50.0));
    const elementary::SinCos both = elementary::sincos(x);
    // The promise: half a unit of x, 2^-53 x, whatever the slope.
    const double error =
        std::abs(both.sin - static_cast<double>(std::sin(static_cast<long double>(x))));
    if (!(error <= 0x1p-53 * x + 0x1p-52)) ++failures;
    if (!(std::abs(both.sin * both.sin + both.cos * both.cos - 1.0) <= 1e-15)) ++failures;
  }
  CHECK(failures == 0);
  CHECK(std::abs(elementary::sin(1e308)) <= 1.0);
}

TEST_CASE("The cardinal sine is within one unit and 1 at zero", "[unit][elementary]") {
  const auto judge = [](long double x) { return std::sin(x) / x; };
  CHECK(worst(-1.0, 1.0, elementary::sinc, judge) <= promised);
  CHECK(worst(-40.0, 40.0, elementary::sinc, judge) <= promised);
  CHECK(elementary::sinc(0.0) == 1.0);
  CHECK(elementary::sinc(-1e-200) == 1.0);
  CHECK(elementary::sinc(kInfinity) == 0.0);
  CHECK(std::isnan(elementary::sinc(kNan)));
}

TEST_CASE("Exponential and logarithm are within one unit in the last place", "[unit][elementary]") {
  const auto exp = [](long double x) { return std::exp(x); };
  const auto log = [](long double x) { return std::log(x); };
  CHECK(worst(-1.0, 1.0, elementary::exp, exp) <= promised);
  CHECK(worst(-745.0, 709.7, elementary::exp, exp) <= promised);
  CHECK(worst(0.5, 2.0, elementary::log, log) <= promised);
  CHECK(worst(-1073.0, 1023.0, elementary::log, log, true) <= promised);
  CHECK(elementary::exp(1.0) == 2.71828182845904524);
  CHECK(elementary::log(2.0) == 0.69314718055994531);
}

TEST_CASE("Powers are within one unit in the last place, and exact where they can be",
          "[unit][elementary]") {
  CHECK(worst(
            -1000.0, 1000.0, [](double x) { return elementary::pow(x, 0.3); },
            [](long double x) { return std::pow(x, static_cast<long double>(0.3)); },
            true) <= promised);
  CHECK(worst(
            0.4, 2.5, [](double x) { return elementary::pow(x, -700.3); },
            [](long double x) { return std::pow(x, static_cast<long double>(-700.3)); }) <=
        promised);
  CHECK(worst(
            -7000.0, 6000.0, [](double y) { return elementary::pow(0.9, y); },
            [](long double y) { return std::pow(static_cast<long double>(0.9), y); }) <= promised);

  int failures = 0;
  for (int base = -40; base <= 40; ++base) {
    double product = 1.0;
    for (int exponent = 0; exponent <= 9; ++exponent) {  // 40^9 < 2^53
      if (elementary::pow(base, exponent) != product) ++failures;
      product *= base;
    }
    if (elementary::pow(base * base, 0.5) != std::abs(base)) ++failures;
  }
  CHECK(failures == 0);
  CHECK(elementary::pow(2.0, -1074.0) == std::numeric_limits<double>::denorm_min());
  CHECK(elementary::pow(0.1, 1.0) == 0.1);
}

TEST_CASE("Arc functions are within one unit in the last place", "[unit][elementary]") {
  const auto asin = [](long double x) { return std::asin(x); };
  const auto acos = [](long double x) { return std::acos(x); };
  CHECK(worst(-1.0, 1.0, elementary::asin, asin) <= promised);
  CHECK(worst(-1.0, 1.0, elementary::acos, acos) <= promised);
  CHECK(worst(-900.0, 0.0, elementary::asin, asin, true) <= promised);
  CHECK(worst(1.0 - 1e-9, 1.0, elementary::acos, acos) <= promised);
  for (const double x : {-3.0, -1e-300, 1e-300, 0.7, 1e300}) {
    const auto ours = [x](double y) { return elementary::atan2(y, x); };
    const auto judge = [x](long double y) { return std::atan2(y, static_cast<long double>(x)); };
    CHECK(worst(-10.0, 10.0, ours, judge) <= promised);
    CHECK(worst(-1070.0, 1020.0, ours, judge, true) <= promised);
  }
}

TEST_CASE("Special values of the elementary functions are those of C", "[unit][elementary]") {
  constexpr std::array values{0.0,  -0.0, 1.0,  -1.0,  0.5,    -0.5,   2.0,       -2.0,       3.0,
                              -3.0, 2.5,  -2.5, 1e300, -1e300, 1e-310, kInfinity, -kInfinity, kNan};
  int failures = 0;
  for (const double x : values) {
    if (std::isinf(x) || x == 0.0 || std::isnan(x)) {
      if (!same(elementary::sin(x), std::sin(x))) ++failures;
      if (!same(elementary::cos(x), std::cos(x))) ++failures;
    }
    if (units(elementary::exp(x), std::exp(static_cast<long double>(x))) > 1.0) ++failures;
    if (units(elementary::log(x), std::log(static_cast<long double>(x))) > 1.0) ++failures;
    if (units(elementary::asin(x), std::asin(static_cast<long double>(x))) > 1.0) ++failures;
    if (units(elementary::acos(x), std::acos(static_cast<long double>(x))) > 1.0) ++failures;
    for (const double y : values) {
      // Of the C library's double functions, since long double neither overflows nor underflows
      // here; 2 units are allowed to it and us together.
      const auto differ = [](double a, double b) {
        return !same(a, b) && !(units(a, static_cast<long double>(b)) <= 2.0);
      };
      if (differ(elementary::atan2(y, x), std::atan2(y, x))) ++failures;
      if (differ(elementary::pow(x, y), std::pow(x, y))) ++failures;
    }
  }
  CHECK(failures == 0);
  CHECK(same(elementary::exp(710.0), kInfinity));
  CHECK(same(elementary::exp(-746.0), 0.0));
  CHECK(same(elementary::log(-1.0), kNan));
  CHECK(same(elementary::asin(1.0000000000000002), kNan));
  CHECK(same(elementary::acos(-1.0000000000000002), kNan));
  CHECK(elementary::acos(-1.0) == pi);
  CHECK(elementary::acos(1.0) == 0.0);
}

TEST_CASE("The elementary functions return the committed bits",
          "[determinism][golden][elementary]") {
  StateHash hash;
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-20.0, 20.0);
    const double u = random.uniform(-1.0, 1.0);
    hash.add(elementary::sin(x));
    hash.add(elementary::cos(x));
    hash.add(elementary::sinc(x));
    hash.add(elementary::exp(x));
    hash.add(elementary::log(std::abs(x)));
    hash.add(elementary::pow(std::abs(x), u));
    hash.add(elementary::asin(u));
    hash.add(elementary::acos(u));
    hash.add(elementary::atan2(u, x));
  }
  CHECK(hash.text() == "5e14c8ba6f3529ba");
}
