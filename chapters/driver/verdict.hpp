/// \file
/// \brief Rules: the number that decides, and the verdict.
#pragma once

#include <string>

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

}  // namespace tumble::chapters
