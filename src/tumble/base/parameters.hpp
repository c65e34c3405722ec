/// \file
/// \brief Settings that a user can name: `key=value`, with default, unit, range and meaning.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble {

/// What values a setting takes.
enum class ParameterKind : std::uint8_t {
  number,  ///< a finite number
  whole,   ///< a whole number
  flag,    ///< `on` or `off`
  word,    ///< one of a list of words
  text     ///< any text; checked where it is used
};

/// One setting: its name, what it may be, and what it is now.
struct Parameter {
  std::string key;                             ///< what a user writes before the =
  ParameterKind kind = ParameterKind::number;  ///< what values it takes
  std::string value;                           ///< what it is now, as text
  std::string unit = "-";                      ///< "m", "s", ...; "-" without one
  std::string meaning;                         ///< one line
  double low = 0.0;                            ///< smallest value of a number
  double high = 0.0;                           ///< largest value of a number
  std::vector<std::string> choices;            ///< the words that a word may be
};

/// The kinds of settings that can be declared.
///
/// What declares a setting takes its key, its default, the smallest and the largest value accepted, its unit, "-" without
/// one, and its meaning, one line.
namespace declare {

/// A number.
Parameter number(std::string key, double initial, double low, double high, std::string unit,
                 std::string meaning);

/// A whole number.
Parameter whole(std::string key, std::int64_t initial, std::int64_t low, std::int64_t high,
                std::string meaning);

/// A switch.
Parameter flag(std::string key, bool initial, std::string meaning);

/// A choice of words.
/// \param choices  the words accepted; the first is the default
Parameter word(std::string key, std::vector<std::string> choices, std::string meaning);

/// A text. It is checked where it is used.
/// \param initial  the default, not empty
Parameter text(std::string key, std::string initial, std::string meaning);

}  // namespace declare

/// The settings of one scene, technique or figure, in the order in which they were declared.
///
/// Settings are declared once, with default, unit and meaning; the command line, the
/// lists of `tumble scenes NAME` and `tumble techniques NAME`, the chapter drivers and the
/// recorded files all read the same declaration.
class Parameters {
 public:
  /// Declares settings.
  Parameters(std::initializer_list<Parameter> items = {}) : items_(items) {}

  /// Declares one more setting.
  Parameters& add(Parameter item) {
    items_.push_back(std::move(item));
    return *this;
  }

  /// Changes a setting.
  /// \throws std::invalid_argument if there is no such key or the value is not accepted; the
  ///         message lists the accepted ones
  void set(std::string_view key, std::string_view value);

  /// Changes a setting.
  /// \param setting  as a command line has it: key=value
  /// \throws std::invalid_argument without a "=", and as set()
  void assign(std::string_view setting);

  /// Whether there is a setting of this name.
  [[nodiscard]] bool has(std::string_view key) const;

  /// The value of a number.
  [[nodiscard]] double number(std::string_view key) const;

  /// The value of a whole number.
  [[nodiscard]] std::int64_t whole(std::string_view key) const;

  /// The value of a whole number, as most code wants it.
  /// \param key its name, declared as whole within the range of int
  [[nodiscard]] int count(std::string_view key) const { return static_cast<int>(whole(key)); }

  /// The value of a switch; true for `on`.
  [[nodiscard]] bool flag(std::string_view key) const;

  /// The value of a choice: one of its words.
  [[nodiscard]] const std::string& word(std::string_view key) const;

  /// The value of a text.
  [[nodiscard]] const std::string& text(std::string_view key) const { return word(key); }

  /// All settings, in the order of declaration.
  [[nodiscard]] std::span<const Parameter> all() const { return items_; }

 private:
  [[nodiscard]] const Parameter& get(std::string_view key) const;

  std::vector<Parameter> items_;
};

}  // namespace tumble
