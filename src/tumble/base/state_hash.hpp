/// \file
/// \brief One number that says whether two runs went through the same bits.
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
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;  // the FNV offset basis
};

}  // namespace tumble
