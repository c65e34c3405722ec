/// \file
/// \brief Pieces of HTML that the page of figures and the pages of the site share.
#pragma once

#include "driver/findings.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// HTML in a page for Doxygen, which hands it on as it is.
std::string as_is(const std::string& html);

// A label that \\ref finds: letters, digits and underscores.
std::string label_of(const std::string& kind, const std::string& id);

// The name of a chapter's folder, for reading.
std::string chapter_title(std::string chapter);

// Where on the site a figure is.
// chapter: that computes it
std::string place_of_figure(const std::string& chapter, const std::string& figure);

// Text as HTML shows it.
std::string html_text(const std::string& text);

std::string prose_html(const std::string& text);

// Text that stays on one line: "1e-10 s" would be broken after its hyphen.
std::string whole_html(const std::string& text);

// A number for reading, with at most 6 significant digits, and its unit.
std::string number_html(double value, const std::string& unit);

// The interval over seeds of a number.
std::string interval_html(const CheckedNumber& number);

// A verdict in colour and in words.
std::string verdict_html(Verdict verdict);

// The verdict of a claim with its second word.
std::string words_html(const LedgerEntry& entry);

// A line of a list of properties.
std::string row_html(const std::string& name, const std::string& html);

// A claim as a box: statement, verdict, number, rule.
std::string claim_html(const LedgerEntry& entry, const std::string& figure_link);

// How a figure is shown.
struct FigureStyle {
  std::string folder;         // of the pictures, from the page: "" or "figures/"
  std::string heading;        // "h2" or "h3"
  bool fold_numbers = false;  // whether the table of numbers has to be opened first
};

// The numbers of a figure, each beside the expected one.
std::string numbers_html(const DrawnFigure& figure, bool fold);

// A figure: picture, caption, film if it has one, claims that it decides, numbers, how to draw it again.
std::string figure_html(const DrawnFigure& figure, const std::vector<LedgerEntry>& ledger,
                        const FigureStyle& style);

// The pictures of the gallery as a grid of thumbnails that lead to the pictures.
std::string gallery_html(const std::vector<DrawnFigure>& figures, const std::string& folder);

// What a figure says of itself.
std::string head_html(const DrawnFigure& figure, const std::string& key);

}  // namespace tumble::chapters
