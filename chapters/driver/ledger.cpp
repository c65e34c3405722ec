/// \file
/// \brief The ledger: what the thesis claims, the number that decides, the verdict.
#include "driver/ledger.hpp"

#include "tumble/record/csv_cells.hpp"

#include "driver/csv.hpp"
#include "driver/records.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>

namespace tumble::chapters {
namespace {

constexpr int kFewestSeeds = 20;  // random scenes that a number must come from, if any

// A rule may be fixed ahead of the experiment.
const RecordForm kOpenForm{"claim",
                           {"id", "chapter", "section", "statement", "experiment"},
                           {"quantity", "unit", "confirmed", "refuted", "reason"}};

const RecordForm kMeasuredForm{"claim",
                               {"id", "section", "statement", "experiment", "technique", "reading",
                                "quantity", "unit", "reason", "figure", "test"},
                               {"confirmed", "refuted"},
                               {"comparable"}};

// The rule must be there exactly if the claim is comparable, and be one.
void check_rule(const Claim& claim) {
  if (!claim.comparable) {
    if (claim.confirmed.empty() && claim.refuted.empty()) return;
    throw std::invalid_argument(claim.place + "not comparable, so nothing confirms or refutes it");
  }
  for (const auto& [key, text] :
       {std::pair{"confirmed", claim.confirmed}, {"refuted", claim.refuted}}) {
    if (text.empty()) throw std::invalid_argument(claim.place + "the key '" + key + "' is missing");
  }
  try {
    read_rule(claim.confirmed, claim.refuted);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(claim.place + error.what());
  }
}

void check_claim(const Claim& claim) {
  const bool lettered = claim.id.size() == claim.section.size() + 1 &&
                        claim.id.starts_with(claim.section) && claim.id.back() >= 'a' &&
                        claim.id.back() <= 'z';
  if (!lettered)
    throw std::invalid_argument(claim.place + "the id is not section " + claim.section +
                                " and a letter");
  if (claim.open) {
    const bool ruled = !(claim.confirmed + claim.refuted + claim.quantity + claim.unit).empty();
    if (ruled && (claim.quantity.empty() || claim.unit.empty() || claim.reason.empty()))
      throw std::invalid_argument(claim.place + "a rule needs quantity, unit and reason");
    if (ruled) check_rule(claim);
    return;
  }
  static constexpr std::array readings{"as_printed", "as_meant", "ours", "-"};
  if (std::find(readings.begin(), readings.end(), claim.reading) == readings.end())
    throw std::invalid_argument(claim.place + "reading '" + claim.reading +
                                "': give as_printed, as_meant, ours or -");
  check_rule(claim);
}

LedgerEntry without_number(const Claim& claim, const std::string& note) {
  LedgerEntry entry{claim, Verdict::not_measured, {}, note};
  entry.number.value = entry.number.low = entry.number.high =
      std::numeric_limits<double>::quiet_NaN();
  return entry;
}

LedgerEntry judged(const Claim& claim, const std::vector<DrawnFigure>& figures) {
  if (claim.open) return without_number(claim, "no chapter measures it yet");
  const CheckedNumber& number = find_number(figures, claim.figure, claim.quantity, claim.place);
  if (number.unit != claim.unit)
    throw std::invalid_argument(claim.place + "the unit is " + claim.unit + ", but " +
                                claim.figure + " computes it in " + number.unit);
  if (!number.compared) return without_number(claim, "drawn with other settings");
  if (std::isnan(number.value)) return without_number(claim, "not computed here: run make figures");
  const bool interval = number.low <= number.high;  // false for NaN
  if (number.seeds > 0 && (number.seeds < kFewestSeeds || !interval))
    throw std::invalid_argument(claim.place + "measured over " + std::to_string(number.seeds) +
                                " random scenes: take at least " + std::to_string(kFewestSeeds) +
                                " and give the interval");
  if (!claim.comparable) return {claim, Verdict::not_comparable, number, claim.reason};
  const Rule rule = read_rule(claim.confirmed, claim.refuted);
  return {claim, rule.verdict(number.value), number, ""};
}

// "2.4.3a" gives 2, 4, 3 and a letter. A claim on a section comes before those on its parts, and
// appendix A after all chapters.
std::vector<long> thesis_place(const std::string& id) {
  constexpr long more_than_sections = 1000;
  std::vector<long> place;
  for (const char* at = id.c_str(); *at != '\0';) {
    char* end = nullptr;
    const long number = std::strtol(at, &end, 10);
    if (end != at) {
      place.push_back(number);
      at = end;
    } else {
      const bool appendix = *at >= 'A' && *at <= 'Z';
      if (*at != '.') place.push_back(*at + (appendix ? more_than_sections : -more_than_sections));
      ++at;
    }
  }
  return place;
}

}  // namespace

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
  Comparison comparison;
  comparison.below = text.starts_with('<');
  comparison.inclusive = text.size() > 1 && text[1] == '=';
  const std::size_t number = text.find_first_not_of(' ', comparison.inclusive ? 2 : 1);
  const bool known = comparison.below || text.starts_with('>');
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
  if (!opposite || !apart)
    throw std::invalid_argument("'" + confirmed + "' and '" + refuted +
                                "' can both hold: one number must not confirm and refute");
  return rule;
}

std::vector<Claim> read_claims(const std::filesystem::path& path) {
  const bool open = path.filename() == "open_claims.toml";
  std::vector<Claim> claims;
  for (Record& record : read_records(path, open ? kOpenForm : kMeasuredForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    const auto comparable = record.flags.find("comparable");
    claims.push_back(
        {texts["id"], texts["section"],
         open ? texts["chapter"] : path.parent_path().filename().string(), texts["statement"],
         texts["experiment"], open, texts["technique"], texts["reading"], texts["quantity"],
         texts["unit"], comparable == record.flags.end() || comparable->second, texts["confirmed"],
         texts["refuted"], texts["reason"], texts["figure"], texts["test"], record.place});
    check_claim(claims.back());
  }
  return claims;
}

std::vector<LedgerEntry> judge(const std::vector<Claim>& claims,
                               const std::vector<DrawnFigure>& figures) {
  std::map<std::string, const Claim*> known;
  std::vector<LedgerEntry> ledger;
  for (const Claim& claim : claims) {
    const auto [other, is_new] = known.emplace(claim.id, &claim);
    if (!is_new)
      throw std::invalid_argument(claim.place + "this id stands also at " + other->second->place);
    ledger.push_back(judged(claim, figures));
  }
  std::sort(ledger.begin(), ledger.end(), [](const LedgerEntry& a, const LedgerEntry& b) {
    return earlier_in_thesis(a.claim.id, b.claim.id);
  });
  return ledger;
}

std::string rule_text(const Claim& claim) {
  if (claim.confirmed.empty()) return "";
  return "confirmed if " + claim.confirmed + ", refuted if " + claim.refuted +
         ", qualified in between";
}

std::string ledger_csv(const std::vector<LedgerEntry>& ledger) {
  std::string text =
      "id,section,statement,technique,reading,quantity,unit,value,low,high,seeds,rule,verdict,"
      "figure,test\n";
  for (const LedgerEntry& entry : ledger) {
    const Claim& claim = entry.claim;
    const bool measured = entry.verdict != Verdict::not_measured;
    const std::vector<std::string> cells{claim.id,
                                         claim.section,
                                         claim.statement,
                                         claim.technique,
                                         claim.reading,
                                         claim.quantity,
                                         claim.unit,
                                         full_text(entry.number.value),
                                         full_text(entry.number.low),
                                         full_text(entry.number.high),
                                         measured ? std::to_string(entry.number.seeds) : "",
                                         rule_text(claim),
                                         verdict_text(entry.verdict),
                                         claim.figure,
                                         claim.test};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text += ',';
      text += csv_cell(cells[i]);
    }
    text += '\n';
  }
  return text;
}

bool earlier_in_thesis(const std::string& a, const std::string& b) {
  return thesis_place(a) < thesis_place(b);
}

}  // namespace tumble::chapters
