/// \file
/// \brief Two boxes seen in each other's frames: what the tests of a pair share.
///
/// Internal to geometry: callers use separation.hpp and manifold.hpp.
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/geometry/separation_lanes.hpp"

#include <array>
#include <cstddef>

namespace tumble {

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
    return tolerance::separation_rounding * (a.sum() + b.sum() + abs(d_first).sum());
  }
};

/// Does the work of separation(const Box&, const Box&, const SeparationOptions&).
/// \param options  how to search; not checked
Separation separation(const BoxPair& pair, const SeparationOptions& options);

}  // namespace tumble
