/// \file
/// \brief The entry point of libFuzzer: calls the target that TUMBLE_FUZZ_TARGET names.
#include "fuzz/targets.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    tumble::fuzz::TUMBLE_FUZZ_TARGET({data, size});
  } catch (const tumble::fuzz::BrokenPromise& broken) {
    std::fprintf(stderr, "broken promise: %s\n", broken.what());
    std::abort();
  }
  return 0;
}
