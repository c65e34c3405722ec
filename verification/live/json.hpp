/// \file
/// \brief Reading JSON back, for tests of written files.
#pragma once

#include <cctype>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::test {

// A value that was read.
struct JsonValue {
  // What it is: `{` an object, `[` a list, `"` a text, `0` a number, `n` null, true or false.
  char kind = 'n';
  std::string text;                         // of a text
  double number = 0.0;                      // of a number
  std::vector<JsonValue> items;             // of a list
  std::map<std::string, JsonValue> fields;  // of an object

  // A field of an object.
  [[nodiscard]] const JsonValue& at(const std::string& name) const { return fields.at(name); }
};

// Reads JSON strictly: nothing before it, a line break at most after it, no field twice.
class JsonReader {
 public:
  // Reads a whole text.
  static JsonValue read(const std::string& text) {
    JsonReader reader(text);
    JsonValue value = reader.value();
    reader.blanks();
    if (reader.at_ != text.size()) reader.fail("end");
    return value;
  }

 private:
  explicit JsonReader(const std::string& text) : text_(text) {}

  [[noreturn]] void fail(const char* expected) const {
    throw std::runtime_error("JSON at " + std::to_string(at_) + ": expected " + expected + ": " +
                             text_.substr(at_, 40));
  }
  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  bool take(char c) {
    blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string string() {
    if (!take('"')) fail("a text");
    std::string out;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (static_cast<unsigned char>(text_[at_]) < 0x20U) fail("no control character");
      if (text_[at_] == '\\') {
        ++at_;
        if (text_.find_first_of("\"\\", at_) != at_) fail("a quote or a backslash after one");
      }
      out += text_[at_];
    }
    if (!take('"')) fail("a quote");
    return out;
  }
  JsonValue value() {
    JsonValue out;
    if (take('{')) {
      out.kind = '{';
      if (take('}')) return out;
      do {
        const std::string name = string();
        if (!take(':')) fail(":");
        if (!out.fields.emplace(name, value()).second) fail("each field once");
      } while (take(','));
      if (!take('}')) fail("}");
    } else if (take('[')) {
      out.kind = '[';
      if (take(']')) return out;
      do {
        out.items.push_back(value());
      } while (take(','));
      if (!take(']')) fail("]");
    } else if (at_ < text_.size() && text_[at_] == '"') {
      out.kind = '"';
      out.text = string();
    } else if (text_.compare(at_, 4, "null") == 0) {
      at_ += 4;
    } else {
      char* end = nullptr;
      out.kind = '0';
      out.number = std::strtod(text_.c_str() + at_, &end);
      const auto length = static_cast<std::size_t>(end - (text_.c_str() + at_));
      const char first = at_ < text_.size() ? text_[at_] : ' ';
      if (length == 0 || (first != '-' && std::isdigit(static_cast<unsigned char>(first)) == 0))
        fail("a value");
      at_ += length;
    }
    return out;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace tumble::test
