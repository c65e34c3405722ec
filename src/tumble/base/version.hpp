/// \file
/// \brief Which version this is, and how it was built.
#pragma once

#include <string>
#include <string_view>

namespace tumble {

/// How the library was built.
struct BuildInfo {
  std::string_view version;   ///< of Tumble, for example "0.1.0"
  std::string_view compiler;  ///< for example "GNU 12.2.0"
  std::string_view flags;     ///< those that decide about bits

  /// All of it in one line, for example "tumble 0.1.0 (GNU 12.2.0; -O3 -ffp-contract=off)".
  [[nodiscard]] std::string text() const;
};

/// How this library was built; the same for every call.
BuildInfo build_info();

}  // namespace tumble
