/// \file
/// \brief Rules: the number that decides, and the verdict.
#include "driver/verdict.hpp"

#include "driver/csv.hpp"
#include "driver/records.hpp"

#include <array>
#include <cmath>
#include <map>
#include <regex>
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

namespace {

constexpr int kFewestSeeds = 20;  // random scenes that a number must come from, if any

// `run` and `figure` come with the number; all else is committed before it.
const RecordForm kSecondForm{"second",
                             {"id", "claim", "scene", "control", "otherwise", "quantity", "unit",
                              "confirmed", "refuted", "ruled"},
                             {"run", "figure"},
                             {},
                             "claim"};

void check_second(const Second& second) {
  static const std::regex day(R"(\d{4}-\d{2}-\d{2})");
  if (second.id.rfind(second.claim + ' ', 0) != 0)
    throw std::invalid_argument(second.place + "the id is not " + second.claim + " and a word");
  if (second.run.empty() != second.figure.empty())
    throw std::invalid_argument(second.place + "run and figure come together, with the number");
  for (const std::string& date : {second.ruled, second.run}) {
    if (!date.empty() && !std::regex_match(date, day))
      throw std::invalid_argument(second.place + "'" + date + "': give a day as 2026-11-26");
  }
  try {
    read_rule(second.confirmed, second.refuted);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(second.place + error.what());
  }
}

}  // namespace

std::vector<Second> read_seconds(const std::filesystem::path& path) {
  std::vector<Second> seconds;
  for (Record& record : read_records(path, kSecondForm)) {
    std::map<std::string, std::string>& t = record.texts;
    seconds.push_back({t["id"], t["claim"], t["scene"], t["control"], t["otherwise"], t["quantity"],
                       t["unit"], t["confirmed"], t["refuted"], t["ruled"], t["run"], t["figure"],
                       record.place});
    check_second(seconds.back());
  }
  return seconds;
}

SecondEntry judge_second(const Second& second, const std::vector<DrawnFigure>& figures) {
  SecondEntry entry{second, Verdict::not_measured, {}, "not run yet: the rule comes first"};
  if (second.figure.empty()) return entry;
  entry.number = find_number(figures, second.figure, second.quantity, second.place);
  if (entry.number.unit != second.unit)
    throw std::invalid_argument(second.place + "the unit is " + second.unit + ", but " +
                                second.figure + " computes it in " + entry.number.unit);
  entry.note = why_no_verdict(entry.number);
  if (!entry.note.empty()) return entry;
  require_seeds(entry.number, second.place);
  entry.verdict = read_rule(second.confirmed, second.refuted).verdict(entry.number.value);
  return entry;
}

std::string seconds_text(const std::vector<SecondEntry>& seconds) {
  std::string text;
  for (const SecondEntry& entry : seconds) {
    const Second& second = entry.second;
    if (!text.empty()) text += "; ";
    text += second.quantity + ": ";
    text += entry.verdict == Verdict::not_measured
                ? entry.note
                : full_text(entry.number.value) + ' ' + second.unit + ", " +
                      verdict_text(entry.verdict) + " on " + second.run;
  }
  return text;
}

std::string why_no_verdict(const CheckedNumber& number) {
  if (!number.compared) return "drawn with other settings";
  return std::isnan(number.value) ? "not computed here: run make figures" : "";
}

void require_seeds(const CheckedNumber& number, const std::string& place) {
  const bool interval = number.low <= number.high;  // false for NaN
  if (number.seeds > 0 && (number.seeds < kFewestSeeds || !interval)) {
    throw std::invalid_argument(place + "measured over " + std::to_string(number.seeds) +
                                " random scenes: take at least " + std::to_string(kFewestSeeds) +
                                " and give the interval");
  }
}

}  // namespace tumble::chapters
