/// \file
/// \brief Equal bit by bit, for what was computed before and need not be again.
#pragma once

#include <cstring>

namespace tumble {

/// Whether two vectors of fixed size have the same bits: -0 differs from 0, and a NaN equals itself.
/// \return true if whatever is computed from the one is the same from the other
template <class Vector>
[[nodiscard]] bool same_bits(const Vector& a, const Vector& b) {
  static_assert(Vector::SizeAtCompileTime > 0, "the numbers are part of the vector");
  return std::memcmp(a.data(), b.data(), sizeof(Vector)) == 0;
}

}  // namespace tumble
