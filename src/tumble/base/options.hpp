/// \file
/// \brief Options of a technique, declared once beside their struct: `describe(Options&, Visitor&)`.
///
/// A struct of options has a function template `describe` that names each field to a visitor: key, field, range,
/// unit, meaning. OptionDeclarer makes Parameters of it, with the struct's initial values as defaults; OptionReader
/// fills a struct from Parameters.
#pragma once

#include "tumble/base/parameters.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tumble {

/// A word of an option and the value for which it stands.
template <class Value>
struct Word {
  std::string_view word;  ///< as typed by a user
  Value value;            ///< in the struct
};

/// A list of words; deduced from the field alone.
template <class Value>
using Words = std::vector<Word<std::type_identity_t<Value>>>;

/// The names of an enumeration as words, each with its name_of().
template <class Value>
std::vector<Word<Value>> words_of(std::span<const Value> all) {
  std::vector<Word<Value>> words;
  for (const Value& value : all) words.push_back({name_of(value), value});
  return words;
}

/// Declares options as Parameters.
///
/// An option has a key, as typed by a user; a field of the struct, whose value is the default; the smallest and the largest
/// value accepted; a unit, "-" without one; and a meaning, one line.
class OptionDeclarer {
 public:
  /// \param parameters  get the options, in the order of description
  explicit OptionDeclarer(Parameters& parameters) : parameters_(parameters) {}

  /// A number.
  void number(std::string_view key, double field, double low, double high, std::string_view unit,
              std::string_view meaning) {
    parameters_.add(declare::number(std::string(key), field, low, high, std::string(unit),
                                    std::string(meaning)));
  }
  /// A whole number.
  void whole(std::string_view key, int field, int low, int high, std::string_view meaning) {
    parameters_.add(declare::whole(std::string(key), field, low, high, std::string(meaning)));
  }
  /// A switch.
  void flag(std::string_view key, bool field, std::string_view meaning) {
    parameters_.add(declare::flag(std::string(key), field, std::string(meaning)));
  }
  /// A choice of words.
  /// \param words    the choices; the list for users begins with the default
  template <class Value>
  void word(std::string_view key, const Value& field, const Words<Value>& words,
            std::string_view meaning) {
    std::vector<std::string> choices;
    for (const Word<Value>& word : words) {
      const auto place = word.value == field ? choices.begin() : choices.end();
      choices.insert(place, std::string(word.word));
    }
    parameters_.add(declare::word(std::string(key), std::move(choices), std::string(meaning)));
  }
  /// A text.
  void text(std::string_view key, const std::string& field, std::string_view meaning) {
    parameters_.add(declare::text(std::string(key), field, std::string(meaning)));
  }

 private:
  Parameters& parameters_;
};

/// Reads options from Parameters, which have checked them; with the functions of OptionDeclarer.
class OptionReader {
 public:
  /// \param parameters  as an OptionDeclarer made them, with values changed
  explicit OptionReader(const Parameters& parameters) : parameters_(parameters) {}

  /// \cond the same functions as those of OptionDeclarer
  void number(std::string_view key, double& field, double, double, std::string_view,
              std::string_view) {
    field = parameters_.number(key);
  }
  void whole(std::string_view key, int& field, int, int, std::string_view) {
    field = parameters_.count(key);
  }
  void flag(std::string_view key, bool& field, std::string_view) { field = parameters_.flag(key); }
  template <class Value>
  void word(std::string_view key, Value& field, const Words<Value>& words, std::string_view) {
    const auto chosen = std::find_if(words.begin(), words.end(), [&](const Word<Value>& word) {
      return word.word == parameters_.word(key);
    });
    field = chosen->value;  // Parameters accepts no other word
  }
  void text(std::string_view key, std::string& field, std::string_view) {
    field = parameters_.text(key);
  }

  /// \endcond

 private:
  const Parameters& parameters_;
};

/// Declares the options of a struct: keys, defaults, units, ranges and meanings.
template <class Options>
Parameters declared_options() {
  Options options;
  Parameters parameters;
  OptionDeclarer declarer(parameters);
  describe(options, declarer);
  return parameters;
}

/// Fills a struct of options.
/// \param parameters  as declared_options() returned them, with values changed
template <class Options>
Options read_options(const Parameters& parameters) {
  Options options;
  OptionReader reader(parameters);
  describe(options, reader);
  return options;
}

}  // namespace tumble
