/// \file
/// \brief The second word of a claim: how the verdict reads with the thesis in hand.
#include "driver/reads.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const std::string kStands = "stands";
const std::string kMisread = "rule misread the sentence";
const std::string kHangs = "hangs on ";
const std::string kRemedy =
    "give reads = \"stands\", \"rule misread the sentence\" or \"hangs on \" and the id of a "
    "choice";

bool is_measured(const LedgerEntry& entry) { return entry.verdict != Verdict::not_measured; }

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// The last claim that a page refers to in a text: its id, or "".
std::string last_claim_in(const std::string& text) {
  static const std::regex reference(R"rx(\\ref\s+claim_\w+\s+"([^"]+)")rx");
  std::string id;
  for (std::sregex_iterator it(text.begin(), text.end(), reference), end; it != end; ++it)
    id = (*it)[1];
  return id;
}

}  // namespace

void check_reads(const std::string& reads, const std::string& because, const std::string& place) {
  if (reads.empty()) throw std::invalid_argument(place + "the key 'reads' is missing: " + kRemedy);
  if (reads != kStands && reads != kMisread && choice_of(reads).empty())
    throw std::invalid_argument(place + "reads '" + reads + "': " + kRemedy);
  if (because.empty())
    throw std::invalid_argument(place +
                                "the key 'reads_because' is missing: say in a sentence "
                                "why it reads so");
}

std::string choice_of(const std::string& reads) {
  return reads.rfind(kHangs, 0) == 0 ? reads.substr(kHangs.size()) : "";
}

void require_choices(const std::vector<LedgerEntry>& ledger,
                     const std::vector<ChoiceEntry>& choices) {
  for (const LedgerEntry& entry : ledger) {
    const std::string wanted = choice_of(entry.claim.reads);
    const auto is_it = [&](const ChoiceEntry& one) { return one.choice.id == wanted; };
    if (!wanted.empty() && std::ranges::none_of(choices, is_it))
      throw std::invalid_argument(entry.claim.place + "hangs on '" + wanted +
                                  "': no choice has this id in a choices.toml");
  }
}

std::vector<std::string> doubtful_reads(const std::vector<LedgerEntry>& ledger,
                                        const std::vector<ChoiceEntry>& choices) {
  std::vector<std::string> messages;
  for (const LedgerEntry& entry : ledger) {
    if (entry.claim.reads != kStands) continue;
    for (const ChoiceEntry& choice : choices) {
      const bool changes = std::ranges::any_of(choice.numbers, [&](const VariedEntry& number) {
        return number.claim == entry.claim.id && number.changes_verdict();
      });
      if (changes)
        messages.push_back(entry.claim.place + "reads 'stands', but another value of '" +
                           choice.choice.id + "' changes the verdict: " + kRemedy);
    }
  }
  return messages;
}

std::string reads_counts(const std::vector<LedgerEntry>& ledger) {
  std::size_t stand = 0;
  std::size_t misread = 0;
  std::size_t hang = 0;
  for (const LedgerEntry& entry : ledger) {
    if (!is_measured(entry)) continue;
    stand += entry.claim.reads == kStands ? 1 : 0;
    misread += entry.claim.reads == kMisread ? 1 : 0;
    hang += choice_of(entry.claim.reads).empty() ? 0 : 1;
  }
  return counted(stand, "verdict stands", "verdicts stand") + ", in " + std::to_string(misread) +
         " the rule misread the sentence, " +
         counted(hang, "hangs on a choice of ours", "hang on a choice of ours");
}

std::vector<std::string> stale_verdicts(const std::string& page, const std::string& name,
                                        const std::vector<LedgerEntry>& ledger) {
  static const std::regex said(
      R"(\*\*(confirmed|qualified|refuted|not comparable)(?:\s+\(([^)]*)\))?\*\*)");
  constexpr std::ptrdiff_t near = 700;  // characters before a verdict
  std::vector<std::string> messages;
  for (std::sregex_iterator it(page.begin(), page.end(), said), end; it != end; ++it) {
    const std::ptrdiff_t at = it->position();
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, at - near);
    const std::string id = last_claim_in(
        page.substr(static_cast<std::size_t>(from), static_cast<std::size_t>(at - from)));
    const std::string where = name + ": " + it->str() + ": ";
    const auto entry =
        std::ranges::find_if(ledger, [&](const LedgerEntry& one) { return one.claim.id == id; });
    if (entry == ledger.end()) {
      messages.push_back(where + "refer to the claim just before its verdict");
      continue;
    }
    const std::string words = std::regex_replace(std::string((*it)[2]), std::regex("\\s+"), " ");
    if (words != entry->claim.reads)
      messages.push_back(where + "claim " + id + " reads '" + entry->claim.reads +
                         "': give that word in brackets");
    if (is_measured(*entry) && (*it)[1] != verdict_text(entry->verdict))
      messages.push_back(where + "claim " + id + " is " + verdict_text(entry->verdict));
  }
  return messages;
}

}  // namespace tumble::chapters
