/// \file
/// \brief Mistakes that the fuzz targets look for.
#include "fuzz/promise.hpp"

#include <algorithm>

namespace tumble::fuzz {

void promise(bool holds, const std::string& text) {
  if (!holds) throw BrokenPromise(text);
}

void require_message(const std::string& message) {
  promise(!message.empty(), "a refusal without a message");
  const bool clean = std::ranges::none_of(message, [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20U && c != '\n') || code == 0x7fU;
  });
  promise(clean, "a refusal with control characters in its message");
}

}  // namespace tumble::fuzz
