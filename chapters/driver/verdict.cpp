/// \file
/// \brief Rules: the number that decides, and the verdict.
#include "driver/verdict.hpp"

#include "driver/csv.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace tumble::chapters {

std::string verdict_text(Verdict verdict) {
  static constexpr std::array words{"confirmed", "qualified", "refuted", "not comparable",
                                    "not measured"};
  return words[static_cast<std::size_t>(verdict)];
}

bool Comparison::holds(double value) const {
  if (value == limit) return inclusive;
  return below ? value < limit : value > limit;
}

Comparison read_comparison(const std::string& text) {
  Comparison comparison{.below = text.rfind('<', 0) == 0,
                        .inclusive = text.size() > 1 && text[1] == '='};
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

std::string rule_text(const std::string& confirmed, const std::string& refuted) {
  if (confirmed.empty()) return "";
  return "confirmed if " + confirmed + ", refuted if " + refuted + ", qualified in between";
}

}  // namespace tumble::chapters
