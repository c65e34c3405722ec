/// \file
/// \brief Random numbers that are the same on every machine.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdint>

namespace tumble {

/// A stream of random numbers: SplitMix64, with our own maps to ranges.
///
/// The state is one 64-bit number, so it belongs to a snapshot, and a stream can be named by what
/// it is for: `Random(seed).fork(step).fork(number_of(id))` gives the same numbers however many
/// other streams were drawn from in between. The distributions of the standard library differ
/// between implementations and are not used.
/// \note Never draw twice within one call's arguments: C++ leaves their order open.
/// \see Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
class Random {
 public:
  /// Starts a stream.
  /// \param seed any number; equal seeds give equal streams
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// The next 64 random bits; every value is equally likely.
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio
    return mixed(state_);
  }

  /// A number in [0, 1), a multiple of 2^-53; every such multiple is equally likely.
  double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// A number in [low, high).
  /// \param high  upper end; low when high equals low
  /// \return low + u (high - low)
  double uniform(double low, double high) { return low + unit() * (high - low); }

  /// A whole number in [0, count).
  /// \param count how many values there are, at least 1
  /// \return below count; the bias is below count / 2^32
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((bits() >> 32U) * count) >> 32U);
  }

  /// A point in a box around the origin.
  /// \param half  [any] half the edge length
  /// \return each component in [-half, half)
  Vec3 in_cube(double half);

  /// A direction of length 1, every one equally likely.
  Vec3 direction();

  /// An orientation of length 1, every one equally likely.
  Quat orientation();

  /// A stream of its own, named by a number, that does not disturb this one.
  /// \param name for example a step or a body's number
  /// \return a stream with no visible relation to this one or to other names
  [[nodiscard]] Random fork(std::uint64_t name) const {
    return Random(mixed(state_ ^ mixed(name + 0x9e3779b97f4a7c15U)));
  }

  /// What a snapshot has to keep; hand it to the constructor to go on.
  [[nodiscard]] std::uint64_t state() const { return state_; }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace tumble
