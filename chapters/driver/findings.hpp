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

/// The contents of the pages.
struct Findings {
  std::vector<DrawnFigure> figures;  ///< from check_figures()
  std::vector<LedgerEntry> ledger;   ///< from judge()
  std::vector<ErratumEntry> errata;  ///< from find_errata()
  std::vector<ChoiceEntry> choices;  ///< from find_choices()
  std::vector<std::string>
      stale;  ///< statements of pages and README's films that are no longer true
};

/// Reads everything that chapters expect and claim, and what their figures gave.
/// \param folder  where `NAME_numbers.csv` are; if it does not exist, nothing has been computed
/// \param files   `expected.csv`, `claims.toml`, `errata.toml`, `choices.toml`, `figures.toml`, `page.md` of the
///                chapters, in order, `open_claims.toml`, and films `NAME.gif` that README shows: distinguished by
///                their names
/// \return figures, ledger, errata, choices, and statements of pages or films that are no longer true
/// \throws FileError, std::invalid_argument as the readers of these files do, and the latter for a
///         file of another name
Findings read_findings(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& files);

/// Every number that is not the expected one, every one in a page that is not the computed one, and every film
/// that is not the one that was painted, in words.
/// \param findings  from read_findings()
/// \return a line for each: figure, page or film, what it has, what it should have
std::vector<std::string> differences(const Findings& findings);

/// The last line of `make figures`. Its words never change, so that a script can read it.
/// \param findings  from read_findings()
/// \return "13 thesis figures, 8 claims measured, 57 not measured, 0 differ from expected"
std::string summary_text(const Findings& findings);

/// What the last line leaves out: other figures, and numbers that were not compared.
/// \param findings  from read_findings()
/// \return for example "also 7 figures of the shared layers"; empty if there is nothing
std::string others_text(const Findings& findings);

/// Whether a figure is a picture of the gallery, a figure of the thesis, ...: by its name.
/// \param figure  the figure
/// \param prefix  "gallery_", "fig", "claim"
/// \return true if the name begins so
bool is_of_kind(const DrawnFigure& figure, const std::string& prefix);

/// The thesis's number of a figure: fig6_6_projectile and fig6_6_projectile_curves are two pictures of one.
/// \param name  "fig5_6_pyramid"
/// \return "5.6"
std::string thesis_number(const std::string& name);

/// Whether the figure's numbers were computed here.
/// \param figure  the figure
/// \return false if only its expected values are known
bool is_drawn(const DrawnFigure& figure);

}  // namespace tumble::chapters
