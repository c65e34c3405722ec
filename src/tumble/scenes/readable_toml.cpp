/// \file
/// \brief A check of a TOML text before it is parsed.
#include "tumble/scenes/readable_toml.hpp"

#include <algorithm>
#include <stdexcept>

namespace tumble {
namespace {

constexpr int most_dots = 64;

bool is_one_of(std::string_view list, char c) { return list.find(c) != std::string_view::npos; }

bool is_in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '+';
}

// What the library looks through as a number: from a digit or sign to a blank, comma, closing bracket or comment.
class InNumber {
 public:
  bool after(char c) {
    if (is_one_of(" \t\r\n\v\f,]}#", c)) {
      inside_ = false;
    } else if (!inside_ && !is_in_word(before_)) {
      inside_ = is_one_of("0123456789+-", c);
    }
    before_ = c;
    return inside_;
  }

 private:
  bool inside_ = false;
  char before_ = '\n';
};

// Goes through a text once, from its first letter on.
class TextCheck {
 public:
  TextCheck(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  void run() {
    // U+FEFF may begin a text.
    for (at_ = text_.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0; at_ < text_.size(); ++at_) one_more();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(not_toml(file_, line_, why));
  }
  [[nodiscard]] bool is_not_ascii() const {
    return at_ < text_.size() && static_cast<unsigned char>(text_[at_]) >= 0x80U;
  }

  void one_more() {
    const char c = text_[at_];
    const bool in_number = number_.after(c);
    if (c == '\n') ++line_;
    if (c == '#') {  // a comment
      at_ = std::min(text_.find('\n', at_), text_.size()) - 1;
    } else if (c == '"' || c == '\'') {
      if (in_number) refuse("a number has a quote in it");
      to_end_of_string(c);
    } else if (is_not_ascii()) {
      refuse("a character that is not ASCII outside of quotes");
    } else if (c == '.') {
      if (++dots_ > most_dots) refuse("a key has more than " + std::to_string(most_dots) + " dots");
    } else if (c == '\n' || c == '=' || c == ',' || c == '{') {
      dots_ = 0;
    }
  }

  // A string is of one line or, with three quotes, of several.
  void to_end_of_string(char quote) {
    const std::string three(3, quote);
    const bool several = text_.substr(at_, 3) == three;
    for (at_ += several ? 3 : 1; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        if (!several) return;
      }
      if (quote == '"' && text_[at_] == '\\') {
        after_backslash();
      } else if (!several && text_[at_] == quote) {
        return;
      } else if (several && text_.substr(at_, 3) == three) {
        at_ += 2;
        // Two quotes may be the last letters of the string.
        for (int more = 0; more < 2 && text_.substr(at_ + 1, 1) == three.substr(0, 1); ++more)
          ++at_;
        return;
      }
    }
  }

  // A quote after a backslash does not end the string. At the end of a line a backslash goes with all
  // blanks that follow.
  void after_backslash() {
    const std::size_t next = at_ + 1;
    for (at_ = next; at_ < text_.size() && is_one_of(" \t\r\n", text_[at_]); ++at_)
      if (text_[at_] == '\n') ++line_;
    if (is_not_ascii()) refuse("a letter that is not ASCII follows a backslash");
    if (at_ > next) --at_;
  }

  std::string_view text_, file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  int dots_ = 0;  // in the present key or number
  InNumber number_;
};

}  // namespace

std::string not_toml(std::string_view file, std::size_t line, const std::string& why) {
  return std::string(file) + ":" + std::to_string(line) + ": not TOML: " + why;
}

void require_readable(std::string_view text, std::string_view file) { TextCheck(text, file).run(); }

}  // namespace tumble
