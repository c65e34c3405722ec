/// \file
/// \brief The second word of a claim: how the verdict reads with the thesis in hand.
///
/// The verdict follows from the number by a rule that is frozen. The second word says whether that verdict is a fair
/// answer to the sentence: `stands`, `rule misread the sentence`, or `hangs on` and the id of a choice of ours.
#pragma once

#include "driver/choices.hpp"
#include "driver/ledger.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// Refuses a second word that is missing, unknown or without its reason.
void check_reads(const std::string& reads, const std::string& because, const std::string& place);

// The choice that a verdict hangs on; empty for the other words.
std::string choice_of(const std::string& reads);

// Refuses a choice that does not exist.
void require_choices(const std::vector<LedgerEntry>& ledger,
                     const std::vector<ChoiceEntry>& choices);

// Claims that are said to stand though another value of a choice changes their verdict, in words.
std::vector<std::string> doubtful_reads(const std::vector<LedgerEntry>& ledger,
                                        const std::vector<ChoiceEntry>& choices);

// "5 stand, in 2 the rule misread the sentence, 1 hangs on a choice of ours", of all claims with a number.
std::string reads_counts(const std::vector<LedgerEntry>& ledger);

// Verdicts in a page that are not those of the ledger.
//
// A page gives a verdict with its second word: `\ref claim_2_1b "2.1b" is **qualified (rule misread the sentence)**`.
std::vector<std::string> stale_verdicts(const std::string& page, const std::string& name,
                                        const std::vector<LedgerEntry>& ledger);

}  // namespace tumble::chapters
