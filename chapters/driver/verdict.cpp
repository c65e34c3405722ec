/// \file
/// \brief The rule that decides a claim, and what it says about a number.
#include "driver/verdict.hpp"

#include "driver/csv.hpp"

#include <cmath>
#include <stdexcept>

namespace tumble::chapters {

std::string verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::qualified:
      return "qualified";
    case Verdict::refuted:
      return "refuted";
    case Verdict::not_comparable:
      return "not comparable";
    case Verdict::not_measured:
      break;
  }
  return "not measured";
}

bool Comparison::holds(double value) const {
  if (value == limit) return inclusive;
  return below ? value < limit : value > limit;
}

Comparison read_comparison(const std::string& text) {
  Comparison comparison;
  comparison.below = text.rfind('<', 0) == 0;
  comparison.inclusive = text.size() > 1 && text[1] == '=';
  const std::size_t number = text.find_first_not_of(' ', comparison.inclusive ? 2 : 1);
  const bool known = comparison.below || text.rfind('>', 0) == 0;
  if (known && number != std::string::npos) {
    comparison.limit = read_number(text.substr(number));
    if (!std::isnan(comparison.limit)) return comparison;
  }
  throw std::invalid_argument("'" + text + "' is no comparison: give < <= > or >= and a number");
}

Verdict Rule::verdict(double value) const {
  if (std::isnan(value)) return Verdict::not_measured;
  if (confirmed.holds(value)) return Verdict::confirmed;
  return refuted.holds(value) ? Verdict::refuted : Verdict::qualified;
}

Rule read_rule(const std::string& confirmed, const std::string& refuted) {
  const Rule rule{read_comparison(confirmed), read_comparison(refuted)};

  // Two half lines are apart if they point away from each other and do not share the limit.
  const Comparison& low = rule.confirmed.below ? rule.confirmed : rule.refuted;
  const Comparison& high = rule.confirmed.below ? rule.refuted : rule.confirmed;
  const bool opposite = low.below && !high.below;
  const bool apart =
      low.limit < high.limit || (low.limit == high.limit && !(low.inclusive && high.inclusive));
  if (!opposite || !apart) {
    throw std::invalid_argument("'" + confirmed + "' and '" + refuted +
                                "' can both hold: one number must not confirm and refute");
  }
  return rule;
}

}  // namespace tumble::chapters
