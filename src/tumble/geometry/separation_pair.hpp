/// \file
/// \brief Two boxes seen in each other's frames: what the tests of a pair share.
///
/// Internal to geometry: callers use separation.hpp and manifold.hpp.
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/separation.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tumble {

/// Three doubles that are computed side by side, and a fourth that pads.
///
/// The separating axis test is the innermost loop of a simulation and does the same for each of three
/// axes of a box. Written with these it takes half the instructions. Each lane is rounded like a plain
/// double, so results do not depend on whether the machine has vector instructions.
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

  /// Their absolute values: the sign bits are taken away.
  [[nodiscard]] Lanes abs() const {
    constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
    return {Two(Bits(xy) & kAllButSign), Two(Bits(z_) & kAllButSign)};
  }
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

/// x, y, z again after x, y, z: the axes after axis i are kCycle[i + 1] and kCycle[i + 2].
inline constexpr std::array<std::size_t, 5> kCycle{0, 1, 2, 0, 1};

/// Two boxes, and where they are relative to each other.
///
/// Symbols: A_i, B_j the axes of the first and second box; a, b their half sizes.
struct BoxPair {
  /// Computes all of it, once for both the separation and the manifold.
  /// \param one    the first box, kept by reference
  /// \param other  the second box, kept by reference
  BoxPair(const Box& one, const Box& other);

  const Box& first;            ///< the box that normals leave
  const Box& second;           ///< the box that normals enter
  Vec3 d_w;                    ///< [m] from the first centre to the second, world frame
  Lanes d_first;               ///< [m] the same in the frame of the first box
  Lanes d_second;              ///< [m] the same in the frame of the second box
  std::array<Lanes, 3> c;      ///< [-] c[i][j] is the dot product of A_i and B_j
  std::array<Lanes, 3> abs_c;  ///< [-] the absolute values of c
  Lanes a;                     ///< [m] half sizes of the first box
  Lanes b;                     ///< [m] half sizes of the second box

  /// How far a separation may be off by rounding [m]: tolerance::separation_rounding of all lengths in it.
  [[nodiscard]] double rounding() const {
    return tolerance::separation_rounding * (a.sum() + b.sum() + d_first.abs().sum());
  }
};

/// Does the work of separation(const Box&, const Box&, const SeparationOptions&).
/// \param options  how to search; not checked
Separation separation(const BoxPair& pair, const SeparationOptions& options);

}  // namespace tumble
