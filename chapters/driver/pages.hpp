/// \file
/// \brief The pages of the site that are made from numbers, claims and constants.
///
/// Each is Markdown for Doxygen: headings and labels that other pages can refer to, and HTML between
/// them. The classes of the HTML are styled by site/pages.css.
#pragma once

#include "driver/findings.hpp"
#include "driver/tolerances.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// How many claims got which verdict, and how many errata there are: for the first page.
std::string counts_text(const Findings& findings);

// Every claim with verdict, number, rule, figure and test: first the measured ones.
//
// Other pages refer to it by `\ref ledger`, to a claim by `\ref claim_2_1a "2.1a"`.
std::string ledger_page(const Findings& findings);

// Every erratum: the printed text, our reading, the numbers of both, test, command.
//
// Other pages refer to it by `\ref errata`, to an erratum by `\ref erratum_C1 "C1"`.
std::string errata_page(const Findings& findings);

// Every small number of the library: value, unit, reason, section of the thesis.
std::string tolerances_page(const std::vector<Tolerance>& tolerances);

// The chosen pictures of the gallery, and links to the figures of each chapter.
std::string gallery_page(const Findings& findings);

// The chapters that have figures, in the order of the thesis.
std::vector<std::string> figure_chapters(const Findings& findings);

// The figures of one chapter; a figure is at place_of_figure().
std::string figures_page(const Findings& findings, const std::string& chapter);

// Every choice: value, reason, and what becomes of the numbers with half and twice the value.
//
// Other pages refer to it by `\ref left_open`, to a choice by `\ref choice_passes "passes"`.
std::string left_open_page(const Findings& findings, const std::vector<Tolerance>& constants);

// All figures on one page: picture, caption, claim with its rule and verdict, numbers, how to draw
// it again with which parameters. The pictures of the gallery come last, as thumbnails.
//
// One file without scripts and without anything from elsewhere; it reads on a phone and in the
// dark. Equal figures give equal bytes.
std::string index_page(const Findings& findings);

}  // namespace tumble::chapters
