/// \file
/// \brief Counts requests for memory, to show that a warm step makes none.
#pragma once

#include <cstdint>

namespace tumble {

// Counts requests for memory since its construction: every form of the global `operator new`, and
// the calls of `malloc`, `calloc` and `realloc` in the program's own objects, where Eigen's
// matrices of run-time size take theirs.
//
// A program that uses it links allocation_counter.cpp, which replaces `operator new`; CMake also
// lets the linker redirect the C functions. Only calls from within shared libraries are not seen.
class AllocationCount {
 public:
  // Starts counting.
  AllocationCount();

  // How often memory has been asked for, by all threads, since this object was made.
  [[nodiscard]] std::int64_t value() const;

 private:
  std::int64_t start_;
};

}  // namespace tumble
