/// \file
/// \brief The ledger: what the thesis claims, the number that decides, the verdict.
#pragma once

#include "driver/verdict.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// One claim of the thesis, as a file of claims describes it.
struct Claim {
  std::string id;             // thesis section and a letter, for example "3.3.1c"
  std::string section;        // of the thesis
  std::string chapter;        // the chapter that measures it, or will
  std::string statement;      // retold
  std::string experiment;     // the run and its counts
  bool open = false;          // no chapter measures it yet: of what follows it has at most a rule
  std::string technique;      // under test
  std::string reading;        // of the technique: "as_printed", "as_meant", "ours" or "-"
  std::string quantity;       // the number that decides, one of its figure's
  std::string unit;           // of the number
  bool comparable = true;     // false: there is no rule, and `reason` says why
  std::string confirmed;      // the comparison that confirms
  std::string refuted;        // the comparison that refutes
  std::string reason;         // why the lines are where they are
  std::string figure;         // the figure that computes the number
  std::string test;           // the test that holds it
  std::string reads;          // how the verdict reads with the thesis in hand: see reads.hpp
  std::string reads_because;  // why, in a sentence
  std::string ruled;          // when the rule was fixed, if not before the first run
  std::string place;          // how messages about it begin
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
  std::vector<SecondEntry> seconds = {};    // later measurements
};

// Finds the numbers of each claim, the first and the later ones, and applies their rules.
//
// A figure that was not drawn, or drawn with other settings than its defaults, measures nothing.
std::vector<LedgerEntry> judge(const std::vector<Claim>& claims,
                               const std::vector<DrawnFigure>& figures,
                               const std::vector<Second>& seconds = {});

// The ledger as a table.
std::string ledger_csv(const std::vector<LedgerEntry>& ledger);

// Whether one claim comes before another in the thesis.
bool earlier_in_thesis(const std::string& a, const std::string& b);

}  // namespace tumble::chapters
