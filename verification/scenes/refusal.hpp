/// \file
/// \brief Messages about scene files that are refused, for tests.
#pragma once

#include "tumble/scenes/scene_file.hpp"

#include <stdexcept>
#include <string>

namespace tumble::test {

// A box that is as it should be.
inline const std::string kBox = "[[box]]\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 2, 0]\n";

// The message with which a text is refused; empty if it is read.
inline std::string refusal(const std::string& text) {
  try {
    (void)parse_scene(text, "my.toml");
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace tumble::test
