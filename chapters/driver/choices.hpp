/// \file
/// \brief Choices that the thesis leaves open: our values, read where they are defined, and the numbers with others.
#pragma once

#include "driver/check.hpp"
#include "driver/ledger.hpp"
#include "driver/tolerances.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// Something that had to be chosen.
struct Choice {
  std::string id;          // a few words
  std::string section;     // of the thesis
  std::string chapter;     // the folder of the chapter
  std::string what;        // what the thesis does not give
  std::string value;       // ours, in words; may be empty if `from` is not
  std::string from;        // where ours is defined, see chosen_values(); may be empty
  std::string why;         // why it is that
  std::string unmeasured;  // why it was not varied; empty exactly if it was
  std::string place;       // how messages about it begin
};

// A number of a figure, measured with other values of a choice too.
struct Variation {
  std::string choice;   // its id
  std::string figure;   // which computes all the numbers
  std::string chosen;   // the quantity as it is
  std::string half;     // the quantity with half the value; may be empty
  std::string doubled;  // the quantity with twice the value; may be empty
  std::string other;    // the quantity with yet another value; may be empty
  std::string change;   // which value that is, in words
  std::string place;    // how messages about it begin
};

// What a file of choices has.
struct Choices {
  std::vector<Choice> choices;        // tables `[[choice]]`
  std::vector<Variation> variations;  // tables `[[varied]]`
};

// Reads a chapter's `choices.toml`.
//
// `[[choice]]` has `id`, `section`, `what`, `why`, `value` or `from` or both, and `unmeasured` unless a
// `[[varied]]` names it. `[[varied]]` has an `id` of its own, `choice`, `figure`, `chosen`, and at least
// one of `half`, `double` and `other`, the last with `change`.
Choices read_choices(const std::filesystem::path& path);

// A number with another value of a choice.
struct VariedNumber {
  std::string change;                       // "half", "double", or in other words
  CheckedNumber number;                     // the number; its value is NaN if it is not measured
  Verdict verdict = Verdict::not_measured;  // what the claim's rule says of it
};

// One number as it is and as it is otherwise.
struct VariedEntry {
  std::string figure;                 // which computes it
  std::string claim;                  // that it decides; empty if none
  VariedNumber chosen;                // as it is
  std::vector<VariedNumber> changed;  // with other values
  // Whether the verdict is another one with one of the values.
  [[nodiscard]] bool changes_verdict() const;
};

// A choice with the numbers that were tried.
struct ChoiceEntry {
  Choice choice;                     // what was chosen
  std::vector<VariedEntry> numbers;  // empty if nothing was varied
};

// Finds the numbers of each choice, and what they would decide.
//
// A number decides a claim if the claim names it and its figure. One that decides nothing by a rule
// has the verdict not comparable.
std::vector<ChoiceEntry> find_choices(const Choices& all, const std::vector<DrawnFigure>& figures,
                                      const std::vector<LedgerEntry>& ledger);

// A value with its name.
struct ChosenValue {
  std::string name;     // of the setting or constant
  std::string value;    // as it is defined; empty for a figure that was not drawn here
  std::string unit;     // "-" without one
  std::string meaning;  // one line
};

// Where values can come from.
struct ValueSources {
  const std::vector<Tolerance>& constants;  // from read_all_tolerances()
  const std::vector<DrawnFigure>& figures;  // from check_figures()
};

// Reads the values that a choice's `from` names, with blanks between keys and `;` between sources:
// "scene fig6_6: rows speed; technique damped: contact_passes; constants: damped_push; figure
// claim_2_4_3b_synchronising: cages". Scenes and techniques give their defaults.
std::vector<ChosenValue> chosen_values(const Choice& choice, const ValueSources& sources);

}  // namespace tumble::chapters
