/// \file
/// \brief Second measurements of claims, each with a rule of its own, beside the first and never in its place.
#pragma once

#include "driver/check.hpp"
#include "driver/verdict.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// A second measurement, as a `[[second]]` table of a chapter's `claims.toml` describes it.
struct Second {
  std::string id;         // of the claim, and a word, for example "3.3.1b clamped"
  std::string claim;      // the id of the claim
  std::string scene;      // what is run
  std::string control;    // what it is compared with
  std::string otherwise;  // what would make it come out the other way
  std::string quantity;   // the number that decides, one of its figure's
  std::string unit;       // of the number
  std::string confirmed;  // the comparison that confirms
  std::string refuted;    // the comparison that refutes
  std::string ruled;      // the day on which the rule was committed
  std::string run;        // the day of the measurement; empty before it
  std::string figure;     // the figure that computes the number; empty before the measurement
  std::string place;      // how messages about it begin
};

// A second measurement with the number that was found.
struct SecondEntry {
  Second second;                            // the rule
  Verdict verdict = Verdict::not_measured;  // what the rule says of the number
  CheckedNumber number;                     // the number
  std::string note;                         // why there is no verdict; empty if there is one
};

// Reads the second measurements of a file of claims.
std::vector<Second> read_seconds(const std::filesystem::path& path);

// Finds the number of a second measurement and applies its rule.
SecondEntry judge_second(const Second& second, const std::vector<DrawnFigure>& figures);

// "4.5 m, refuted on 2026-11-26 (scene; control: ...)" for each, or "".
std::string seconds_text(const std::vector<SecondEntry>& seconds);

// Why a number decides nothing: drawn with other settings, or not computed. Empty if it decides.
std::string why_no_verdict(const CheckedNumber& number);

// Refuses a number over random scenes that has too few of them or no interval.
void require_seeds(const CheckedNumber& number, const std::string& place);

}  // namespace tumble::chapters
