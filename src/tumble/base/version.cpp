/// \file
/// \brief Which version this is; the values come from CMake.
#include "tumble/base/version.hpp"

#ifndef TUMBLE_VERSION
#define TUMBLE_VERSION "unknown"
#endif
#ifndef TUMBLE_COMPILER
#define TUMBLE_COMPILER __VERSION__
#endif
#ifndef TUMBLE_FLAGS
#define TUMBLE_FLAGS "unknown"
#endif

namespace tumble {

std::string BuildInfo::text() const {
  std::string out = "tumble ";
  return out.append(version).append(" (").append(compiler).append("; ").append(flags).append(")");
}

BuildInfo build_info() { return {TUMBLE_VERSION, TUMBLE_COMPILER, TUMBLE_FLAGS}; }

}  // namespace tumble
