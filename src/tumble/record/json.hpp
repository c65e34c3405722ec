/// \file
/// \brief Writing a JSON file in a fixed order.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tumble {

/// A JSON text as it is being written: begin, fields, end.
///
/// Numbers have the shortest digits that read back to the same bits; those that JSON cannot say (NaN, infinities) are `null`.
class Json {
 public:
  /// Opens an object.
  Json& begin();
  /// Closes the object opened last.
  Json& end();
  /// Opens a list.
  Json& begin_list();
  /// Closes the list opened last.
  Json& end_list();
  /// Writes the name of the value that follows.
  Json& key(std::string_view name);
  /// Writes a field.
  Json& field(std::string_view name, double value);
  /// Writes a field.
  Json& field(std::string_view name, std::int64_t value);
  /// Writes a field.
  Json& field(std::string_view name, std::string_view value);
  /// Writes an item of a list.
  Json& item(std::string_view value);
  /// Writes an item of a list.
  Json& item(double value);
  /// What was written: the text, with a line break at its end.
  [[nodiscard]] std::string text() const { return out_ + "\n"; }

 private:
  void next();
  void write_text(std::string_view value);
  void write_number(double value);

  std::string out_;
  int depth_ = 0;
  bool first_ = true;  // nothing stands in the innermost object or list yet
  bool after_key_ = false;
};

}  // namespace tumble
