/// \file
/// \brief Three numbers that are computed side by side.
///
/// Internal to geometry. The separating axis test is the innermost loop of a simulation and does the
/// same for each of three axes of a box. Written with these it takes half the instructions. Each
/// lane is rounded like a plain double, so results do not depend on whether the machine has
/// vector instructions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tumble {

/// Three doubles, and a fourth that pads.
struct Lanes {
  /// What the hardware holds in one register: two doubles, or (of comparisons) two masks.
  using Two = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));  ///< see Two

  Two xy;  ///< the first and second
  Two z_;  ///< the third and the padding

  /// Three numbers that lie `stride` apart in memory.
  static Lanes of(const double* p, std::size_t stride = 1) {
    return {Two{p[0], p[stride]}, Two{p[2 * stride], 0.0}};
  }

  /// One of them.
  /// \param i 0, 1 or 2
  double operator[](std::size_t i) const {
    double value;
    std::memcpy(&value, reinterpret_cast<const char*>(this) + i * sizeof(double), sizeof(double));
    return value;
  }

  /// The same three in cyclic order from the second: y, z, x.
  [[nodiscard]] Lanes next() const { return {Two{xy[1], z_[0]}, Two{xy[0], 0.0}}; }

  /// The same three in cyclic order from the third: z, x, y.
  [[nodiscard]] Lanes after() const { return {Two{z_[0], xy[0]}, Two{xy[1], 0.0}}; }

  /// Their sum: (x + y) + z.
  [[nodiscard]] double sum() const { return xy[0] + xy[1] + z_[0]; }
};

/// Adds lane by lane: p + q.
inline Lanes operator+(const Lanes& p, const Lanes& q) { return {p.xy + q.xy, p.z_ + q.z_}; }

/// Subtracts lane by lane: p - q.
inline Lanes operator-(const Lanes& p, const Lanes& q) { return {p.xy - q.xy, p.z_ - q.z_}; }

/// Multiplies lane by lane: p q.
inline Lanes operator*(const Lanes& p, const Lanes& q) { return {p.xy * q.xy, p.z_ * q.z_}; }

/// Multiplies all lanes by one number: s p.
inline Lanes operator*(double s, const Lanes& p) { return {s * p.xy, s * p.z_}; }

/// Adds one number to all lanes: p + s.
inline Lanes operator+(const Lanes& p, double s) { return {p.xy + s, p.z_ + s}; }

/// Takes the sign bits away: |p|.
inline Lanes abs(const Lanes& p) {
  constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
  return {Lanes::Two(Lanes::Bits(p.xy) & kAllButSign), Lanes::Two(Lanes::Bits(p.z_) & kAllButSign)};
}

/// Which lanes are above those of another: bit 0 for the first lane, bit 1 and bit 2 for the others.
inline unsigned above(const Lanes& p, const Lanes& q) {
  const Lanes::Bits bits = (Lanes::Bits(p.xy > q.xy) & Lanes::Bits{1, 2}) |
                           (Lanes::Bits(p.z_ > q.z_) & Lanes::Bits{4, 0});
  return static_cast<unsigned>(bits[0] | bits[1]);
}

}  // namespace tumble
