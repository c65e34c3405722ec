/// \file
/// \brief Common parts of the fuzz targets: their input, and the mistake that they look for.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace tumble::fuzz {

// The input of a target: any bytes.
using Bytes = std::span<const std::uint8_t>;

// The library did what it promises not to do. The message names the value.
class BrokenPromise : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws BrokenPromise with this text unless the condition holds.
void promise(bool holds, const std::string& text);

// Breaks the promise if a message of a refusal is empty or holds control characters.
void require_message(const std::string& message);

// Runs something that may refuse its input.
//
// True if it threw std::invalid_argument; the message has to say something, and must not hold control characters
// that a terminal would obey. It is put into `why` if that is wanted.
template <class Action>
bool refuses(const Action& action, std::string* why = nullptr) {
  try {
    action();
  } catch (const std::invalid_argument& refusal) {
    require_message(refusal.what());
    if (why != nullptr) *why = refusal.what();
    return true;
  }
  return false;
}

// Draws numbers from bytes, in order; after the last byte all are 0.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  // One byte.
  std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }

  // A number from 0 to 1, of two bytes.
  double unit() {
    const unsigned low = byte();
    const unsigned high = byte();
    return static_cast<double>(low + 256U * high) / 65535.0;
  }

  // A number from low to high.
  double uniform(double low, double high) { return low + unit() * (high - low); }

  // A power of ten with an exponent from low to high.
  double power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }

  // Eight bytes, the lowest first.
  std::uint64_t seed() {
    std::uint64_t all = 0;
    for (unsigned k = 0; k < 8; ++k) all |= std::uint64_t{byte()} << (8U * k);
    return all;
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

}  // namespace tumble::fuzz
