/// \file
/// \brief Sine, exponential and their kin with the same bits on every machine.
#pragma once

/// Elementary functions made of + - × ÷, sqrt and exact functions only.
///
/// C libraries differ in the last bit of std::sin, std::exp and so on; a simulation multiplies
/// such differences until two machines show different piles. These functions use only operations
/// that IEEE 754 rounds correctly, so they return the same bits wherever doubles are IEEE doubles
/// and multiply-add is not contracted (`-ffp-contract=off`).
///
/// Accuracy: results are within 1 unit in the last place of the correctly rounded value.
/// Cost: sine, cosine and exponential take about 1 to 3 times as long as those of glibc, the others up to
/// 9 times (100 ns for a power): accuracy there is bought with pairs of doubles, not with tables.
/// Special values follow C (ISO C, annex F) without its flags and errno: NaN in, NaN out; outside
/// the domain NaN; a zero result keeps its sign.
namespace tumble::elementary {

/// Sine and cosine of one angle.
struct SinCos {
  double sin;  ///< [-] sine
  double cos;  ///< [-] cosine
};

/// Both at the price of little more than one.
///
/// Above 1.6e6 rad the result is that of some angle within half a unit in the last place of x.
/// \param x [rad] any angle
/// \return sine and cosine; both NaN for NaN and infinities
SinCos sincos(double x);

/// Sine.
/// \param x [rad] any angle, see sincos()
/// \return [-] -1 to 1; NaN for NaN and infinities; sin(-0) is -0
double sin(double x);

/// Cosine.
/// \param x [rad] any angle, see sincos()
/// \return [-] -1 to 1; NaN for NaN and infinities
double cos(double x);

/// Cardinal sine, sin(x)/x.
/// \param x [rad] any angle, see sincos()
/// \return [-] 1 at 0; 0 for infinities, the limit
double sinc(double x);

/// Exponential, \f$e^x\f$.
/// \param x [-] any number
/// \return infinity above 709.78, 0 below -745.13, smaller doubles in between as they come
double exp(double x);

/// Natural logarithm.
/// \param x [-] 0 or above
/// \return -infinity at ±0, NaN below 0
double log(double x);

/// Power, \f$\text{base}^{\text{exponent}}\f$.
/// \param base      [-] any number
/// \param exponent  [-] any number
/// \return 1 if the exponent is 0 or the base 1 (even beside NaN); NaN for a negative finite base
///         with an exponent that is not whole; exact results are returned exactly
double pow(double base, double exponent);

/// Arc sine.
/// \param x [-] -1 to 1
/// \return [rad] -π/2 to π/2; NaN outside the domain
double asin(double x);

/// Arc cosine.
/// \param x [-] -1 to 1
/// \return [rad] 0 to π; NaN outside the domain
double acos(double x);

/// Angle of the point (x, y), counted from the x axis towards the y axis.
/// \param y [any] the point's second coordinate: it comes first, as in C
/// \param x [any] the point's first coordinate, same unit
/// \return [rad] -π to π; signed zeros and infinities as in C: atan2(±0, -0) is ±π
double atan2(double y, double x);

}  // namespace tumble::elementary
