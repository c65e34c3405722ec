/// \file
/// \brief Writing JSON.
#include "tumble/record/json.hpp"

#include "tumble/base/number_text.hpp"

#include <cmath>

namespace tumble {

// A comma after what stands before, and a line of its own; nothing between a key and its value.
void Json::next() {
  if (!after_key_ && depth_ > 0)
    out_.append(first_ ? "\n" : ",\n").append(2 * static_cast<std::size_t>(depth_), ' ');
  first_ = false;
  after_key_ = false;
}

Json& Json::begin() {
  next();
  out_ += '{';
  ++depth_;
  first_ = true;
  return *this;
}

Json& Json::end() {
  --depth_;
  if (!first_) out_.append("\n").append(2 * static_cast<std::size_t>(depth_), ' ');
  out_ += '}';
  first_ = false;
  return *this;
}

Json& Json::begin_list() {
  next();
  out_ += '[';
  ++depth_;
  first_ = true;
  return *this;
}

Json& Json::end_list() {
  --depth_;
  if (!first_) out_.append("\n").append(2 * static_cast<std::size_t>(depth_), ' ');
  out_ += ']';
  first_ = false;
  return *this;
}

Json& Json::key(std::string_view name) {
  next();
  write_text(name);
  out_ += ": ";
  after_key_ = true;
  return *this;
}

void Json::write_text(std::string_view value) {
  constexpr const char* digits = "0123456789abcdef";
  out_ += '"';
  for (const char c : value) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out_.append(1, '\\').append(1, c);
    } else if (code < 0x20U) {
      out_.append("\\u00").append(1, digits[code >> 4U]).append(1, digits[code & 0xfU]);
    } else {
      out_ += c;
    }
  }
  out_ += '"';
}

void Json::write_number(double value) {
  out_ += std::isfinite(value) ? shortest_text(value) : "null";
}

Json& Json::field(std::string_view name, double value) {
  key(name).after_key_ = false;
  write_number(value);
  return *this;
}

Json& Json::field(std::string_view name, std::int64_t value) {
  key(name).after_key_ = false;
  out_ += std::to_string(value);
  return *this;
}

Json& Json::field(std::string_view name, std::string_view value) {
  key(name).after_key_ = false;
  write_text(value);
  return *this;
}

Json& Json::item(std::string_view value) {
  next();
  write_text(value);
  return *this;
}

Json& Json::item(double value) {
  next();
  write_number(value);
  return *this;
}

}  // namespace tumble
