/// \file
/// \brief The ledger: what the thesis claims, the number that decides, the verdict.
#include "driver/ledger.hpp"

#include "tumble/record/table_file.hpp"

#include "driver/csv.hpp"
#include "driver/reads.hpp"
#include "driver/records.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>

namespace tumble::chapters {
namespace {

// A rule may be fixed ahead of the experiment.
const RecordForm kOpenForm{"claim",
                           {"id", "chapter", "section", "statement", "experiment"},
                           {"quantity", "unit", "confirmed", "refuted", "reason"}};

const RecordForm kMeasuredForm{"claim",
                               {"id", "section", "statement", "experiment", "technique", "reading",
                                "quantity", "unit", "reason", "figure", "test"},
                               {"confirmed", "refuted", "reads", "reads_because", "ruled"},
                               {"comparable"},
                               "second"};

// The rule must be there exactly if the claim is comparable, and be one.
void check_rule(const Claim& claim) {
  if (!claim.comparable) {
    if (claim.confirmed.empty() && claim.refuted.empty()) return;
    throw std::invalid_argument(claim.place + "not comparable, so nothing confirms or refutes it");
  }
  for (const auto& [key, text] :
       {std::pair{"confirmed", claim.confirmed}, {"refuted", claim.refuted}}) {
    if (text.empty()) {
      throw std::invalid_argument(claim.place + "the key '" + key + "' is missing");
    }
  }
  try {
    read_rule(claim.confirmed, claim.refuted);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(claim.place + error.what());
  }
}

void check_claim(const Claim& claim) {
  const bool lettered = claim.id.size() == claim.section.size() + 1 &&
                        claim.id.rfind(claim.section, 0) == 0 && claim.id.back() >= 'a' &&
                        claim.id.back() <= 'z';
  if (!lettered) {
    throw std::invalid_argument(claim.place + "the id is not section " + claim.section +
                                " and a letter");
  }
  if (claim.open) {
    const bool ruled = !(claim.confirmed + claim.refuted + claim.quantity + claim.unit).empty();
    if (ruled && (claim.quantity.empty() || claim.unit.empty() || claim.reason.empty()))
      throw std::invalid_argument(claim.place + "a rule needs quantity, unit and reason");
    if (ruled) check_rule(claim);
    return;
  }
  static constexpr std::array readings{"as_printed", "as_meant", "ours", "-"};
  if (std::ranges::find(readings, claim.reading) == readings.end()) {
    throw std::invalid_argument(claim.place + "reading '" + claim.reading +
                                "': give as_printed, as_meant, ours or -");
  }
  check_rule(claim);
  check_reads(claim.reads, claim.reads_because, claim.place);
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
  if (number.unit != claim.unit) {
    throw std::invalid_argument(claim.place + "the unit is " + claim.unit + ", but " +
                                claim.figure + " computes it in " + number.unit);
  }
  const std::string missing = why_no_verdict(number);
  if (!missing.empty()) return without_number(claim, missing);
  require_seeds(number, claim.place);
  if (!claim.comparable) return {claim, Verdict::not_comparable, number, claim.reason};
  const Rule rule = read_rule(claim.confirmed, claim.refuted);
  return {claim, rule.verdict(number.value), number, ""};
}

// The claim that is measured a second time.
LedgerEntry& entry_of(std::vector<LedgerEntry>& ledger, const Second& second) {
  for (LedgerEntry& entry : ledger)
    if (entry.claim.id == second.claim) return entry;
  throw std::invalid_argument(second.place + "there is no claim " + second.claim);
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

std::vector<Claim> read_claims(const std::filesystem::path& path) {
  const bool open = path.filename() == "open_claims.toml";
  std::vector<Claim> claims;
  for (Record& record : read_records(path, open ? kOpenForm : kMeasuredForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    const auto comparable = record.flags.find("comparable");
    claims.push_back({texts["id"],
                      texts["section"],
                      open ? texts["chapter"] : path.parent_path().filename().string(),
                      texts["statement"],
                      texts["experiment"],
                      open,
                      texts["technique"],
                      texts["reading"],
                      texts["quantity"],
                      texts["unit"],
                      comparable == record.flags.end() || comparable->second,
                      texts["confirmed"],
                      texts["refuted"],
                      texts["reason"],
                      texts["figure"],
                      texts["test"],
                      texts["reads"],
                      texts["reads_because"],
                      texts["ruled"],
                      record.place});
    check_claim(claims.back());
  }
  return claims;
}

std::vector<LedgerEntry> judge(const std::vector<Claim>& claims,
                               const std::vector<DrawnFigure>& figures,
                               const std::vector<Second>& seconds) {
  std::map<std::string, const Claim*> known;
  std::vector<LedgerEntry> ledger;
  for (const Claim& claim : claims) {
    const auto [other, is_new] = known.emplace(claim.id, &claim);
    if (!is_new) {
      throw std::invalid_argument(claim.place + "this id stands also at " + other->second->place);
    }
    ledger.push_back(judged(claim, figures));
  }
  for (const Second& second : seconds)
    entry_of(ledger, second).seconds.push_back(judge_second(second, figures));
  std::ranges::sort(ledger, [](const LedgerEntry& a, const LedgerEntry& b) {
    return earlier_in_thesis(a.claim.id, b.claim.id);
  });
  return ledger;
}

std::string ledger_csv(const std::vector<LedgerEntry>& ledger) {
  std::string text =
      "id,section,statement,technique,reading,quantity,unit,value,low,high,seeds,rule,verdict,"
      "reads,reads_because,second,figure,test\n";
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
                                         rule_text(claim.confirmed, claim.refuted),
                                         verdict_text(entry.verdict),
                                         claim.reads,
                                         claim.reads_because,
                                         seconds_text(entry.seconds),
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
