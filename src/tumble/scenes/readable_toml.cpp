/// \file
/// \brief A check of a TOML text before it is parsed.
#include "tumble/scenes/readable_toml.hpp"

#include <algorithm>
#include <stdexcept>

namespace tumble {
namespace {

constexpr int most_dots = 64;

}  // namespace

std::string not_toml(std::string_view file, std::size_t line, const std::string& why) {
  return std::string(file) + ":" + std::to_string(line) + ": not TOML: " + why;
}

void require_readable(std::string_view text, std::string_view file) {
  std::size_t line = 1;
  int dots = 0;  // in the present key or number
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(not_toml(file, line, why));
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (c == '#') {  // a comment
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '"' || c == '\'') {  // a string, of one line or with three quotes of several
      const bool several = text.substr(i, 3) == std::string(3, c);
      for (i += several ? 3 : 1; i < text.size(); ++i) {
        if (text[i] == '\n') {
          ++line;
          if (!several) break;
        }
        if (c == '"' && text[i] == '\\') {
          ++i;
        } else if (text[i] == c && (!several || text.substr(i, 3) == std::string(3, c))) {
          i += several ? 2 : 0;
          break;
        }
      }
    } else if (static_cast<unsigned char>(c) >= 0x80U &&
               !(i < 3 && text.substr(0, 3) == "\xEF\xBB\xBF")) {
      refuse("a letter that is not ASCII stands outside of quotes");
    } else if (c == '.') {
      if (++dots > most_dots) refuse("a key has more than " + std::to_string(most_dots) + " dots");
    } else if (c == '\n' || c == '=' || c == ',' || c == '{') {
      dots = 0;
    }
  }
}

}  // namespace tumble
