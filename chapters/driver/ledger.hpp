/// \file
/// \brief The ledger: what the thesis claims, the number that decides, the verdict.
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

// One claim of the thesis, as a file of claims describes it.
struct Claim {
  std::string id;          // thesis section and a letter, for example "3.3.1c"
  std::string section;     // of the thesis
  std::string chapter;     // the chapter that measures it, or will
  std::string statement;   // retold
  std::string experiment;  // the run and its counts
  bool open = false;       // no chapter measures it yet: of what follows it has at most a rule
  std::string technique;   // under test
  std::string reading;     // of the technique: "as_printed", "as_meant", "ours" or "-"
  std::string quantity;    // the number that decides, one of its figure's
  std::string unit;        // of the number
  bool comparable = true;  // false: there is no rule, and `reason` says why
  std::string confirmed;   // the comparison that confirms
  std::string refuted;     // the comparison that refutes
  std::string reason;      // why the lines are where they are
  std::string figure;      // the figure that computes the number
  std::string test;        // the test that holds it
  std::string place;       // how messages about it begin
};

// Reads a file of claims: a chapter's `claims.toml`, or `open_claims.toml` with those that no
// chapter measures yet. The chapter of the former is the folder it lies in.
std::vector<Claim> read_claims(const std::filesystem::path& path);

// A claim with the number that was found.
struct LedgerEntry {
  Claim claim;                              // the sentence
  Verdict verdict = Verdict::not_measured;  // what the rule says of the number
  CheckedNumber number;                     // the number; its value is NaN if it is not measured
  std::string note;                         // why there is no verdict; empty if there is one
};

// Finds the number of each claim and applies its rule.
//
// A figure that was not drawn, or drawn with other settings than its defaults, measures nothing.
std::vector<LedgerEntry> judge(const std::vector<Claim>& claims,
                               const std::vector<DrawnFigure>& figures);

// The rule of a claim in words.
std::string rule_text(const Claim& claim);

// The ledger as a table.
std::string ledger_csv(const std::vector<LedgerEntry>& ledger);

// Whether one claim comes before another in the thesis.
bool earlier_in_thesis(const std::string& a, const std::string& b);

}  // namespace tumble::chapters
