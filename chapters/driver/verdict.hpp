/// \file
/// \brief Rules: the number that decides, and the verdict. Second measurements of claims, each with a rule of its own, beside
///        the first and never in its place.
#pragma once

#include "driver/check.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// What became of a claim.
enum class Verdict {
  confirmed,       // the number fulfils the comparison that confirms
  qualified,       // neither comparison holds
  refuted,         // the number fulfils the comparison that refutes
  not_comparable,  // there is a number, but no line that could be drawn
  not_measured     // there is no number
};

// A verdict in words.
std::string verdict_text(Verdict verdict);

// A comparison with a limit, such as `<= 5`.
struct Comparison {
  bool below = true;      // holds for numbers below the limit; otherwise for those above it
  bool inclusive = true;  // and for the limit itself
  double limit = 0.0;     // [unit of the number]

  // Whether a number fulfils it.
  [[nodiscard]] bool holds(double value) const;
};

// Reads a comparison.
Comparison read_comparison(const std::string& text);

// What confirms a claim and what refutes it; in between it is qualified.
struct Rule {
  Comparison confirmed;  // one half of the line of numbers
  Comparison refuted;    // the other half, apart from the first

  // Applies it.
  [[nodiscard]] Verdict verdict(double value) const;
};

// Reads the two comparisons of a rule.
Rule read_rule(const std::string& confirmed, const std::string& refuted);

// A rule in words.
std::string rule_text(const std::string& confirmed, const std::string& refuted);

// A second measurement, as a `[[second]]` table of a chapter's `claims.toml` describes it.
struct Second {
  std::string id;         // of the claim, and a word, for example "3.3.1b clamped"
  std::string claim;      // the id of the claim
  std::string scene;      // what is run
  std::string control;    // what it is compared with
  std::string otherwise;  // what would make it come out the other way
  std::string quantity;   // the number that decides, one of its figure's
  std::string unit;       // of the number
  std::string confirmed;  // the comparison that confirms
  std::string refuted;    // the comparison that refutes
  std::string ruled;      // the day on which the rule was committed
  std::string run;        // the day of the measurement; empty before it
  std::string figure;     // the figure that computes the number; empty before the measurement
  std::string place;      // how messages about it begin
};

// A second measurement with the number that was found.
struct SecondEntry {
  Second second;                            // the rule
  Verdict verdict = Verdict::not_measured;  // what the rule says of the number
  CheckedNumber number;                     // the number
  std::string note;                         // why there is no verdict; empty if there is one
};

// Reads the second measurements of a file of claims.
std::vector<Second> read_seconds(const std::filesystem::path& path);

// Finds the number of a second measurement and applies its rule.
SecondEntry judge_second(const Second& second, const std::vector<DrawnFigure>& figures);

// "4.5 m, refuted on 2026-11-26 (scene; control: ...)" for each, or "".
std::string seconds_text(const std::vector<SecondEntry>& seconds);

// Why a number decides nothing: drawn with other settings, or not computed. Empty if it decides.
std::string why_no_verdict(const CheckedNumber& number);

// Refuses a number over random scenes that has too few of them or no interval.
void require_seeds(const CheckedNumber& number, const std::string& place);

}  // namespace tumble::chapters
