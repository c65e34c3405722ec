/// \file
/// \brief Messages about scene files that are refused, for tests.
#pragma once

#include "support/test.hpp"

namespace tumble::test {

// A box that is as it should be.
inline const std::string kBox = "[[box]]\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 2, 0]\n";

// The message with which a text is refused; empty if it is read.
inline std::string refusal(const std::string& text) {
  return refusal_of([&] { (void)parse_scene(text, "my.toml"); });
}

}  // namespace tumble::test
