/// \file
/// \brief Whether the bits are the same: of two vectors, and, by one number, of two runs.
#pragma once

#include "tumble/base/types.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace tumble {

/// FNV-1a, 64 bits wide, over the bit patterns of numbers.
///
/// Equal hashes of two runs mean equal bits for any purpose of ours: +0 and -0 differ, and a NaN
/// shows. The order in which numbers are added matters.
/// \see Fowler, Noll, Vo: the FNV hash.
class StateHash {
 public:
  /// Mixes in a whole number, byte by byte from the lowest.
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ ^= (value >> (8 * byte)) & 0xffU;
      value_ *= 0x100000001b3U;  // the FNV prime
    }
  }

  /// Mixes in the bits of a number.
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);  // std::bit_cast is missing in em++ 3.1.6
    add(bits);
  }

  /// Mixes in three numbers.
  void add(const Vec3& v) {
    for (int k = 0; k < 3; ++k) add(v[k]);
  }

  /// Mixes in four numbers.
  void add(const Quat& q) {
    add(q.w());
    add(Vec3(q.vec()));
  }

  /// The hash of all that was added so far.
  [[nodiscard]] std::uint64_t value() const { return value_; }

  /// The hash as 16 hexadecimal digits, the form that files and the golden values use.
  /// \return lower-case digits, no prefix
  [[nodiscard]] std::string text() const {
    constexpr const char* digits = "0123456789abcdef";
    std::string out(16, '0');
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = digits[(value_ >> (60 - 4 * i)) & 0xfU];
    return out;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;  // the FNV offset basis
};

/// Whether two vectors of fixed size have the same bits: -0 differs from 0, and a NaN equals itself.
/// \return true if whatever is computed from the one is the same from the other
template <class Vector>
[[nodiscard]] bool same_bits(const Vector& a, const Vector& b) {
  static_assert(Vector::SizeAtCompileTime > 0, "the numbers are part of the vector");
  return std::memcmp(a.data(), b.data(), sizeof(Vector)) == 0;
}

}  // namespace tumble
