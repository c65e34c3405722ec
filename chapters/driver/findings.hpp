/// \file
/// \brief All that the figures have found: numbers, verdicts, errata.
#pragma once

#include "driver/check.hpp"
#include "driver/choices.hpp"
#include "driver/errata.hpp"
#include "driver/ledger.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// The contents of the pages.
struct Findings {
  std::vector<DrawnFigure> figures;  // from check_figures()
  std::vector<LedgerEntry> ledger;   // from judge()
  std::vector<ErratumEntry> errata;  // from find_errata()
  std::vector<ChoiceEntry> choices;  // from find_choices()
  std::vector<std::string> stale;  // statements of pages and README's films that are no longer true
};

// Reads everything that chapters expect and claim, and what their figures gave.
Findings read_findings(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& files);

// Every number that is not the expected one, every one in a page that is not the computed one, and every film
// that is not the one that was painted, in words.
std::vector<std::string> differences(const Findings& findings);

// The last line of `make figures`. Its words never change, so that a script can read it.
std::string summary_text(const Findings& findings);

// What the last line leaves out: other figures, and numbers that were not compared.
std::string others_text(const Findings& findings);

// Whether a figure is a picture of the gallery, a figure of the thesis, ...: by its name.
bool is_of_kind(const DrawnFigure& figure, const std::string& prefix);

// The thesis's number of a figure: fig6_6_projectile and fig6_6_projectile_curves are two pictures of one.
std::string thesis_number(const std::string& name);

// Whether the figure's numbers were computed here.
bool is_drawn(const DrawnFigure& figure);

}  // namespace tumble::chapters
