/// \file
/// \brief Pieces of HTML that the page of figures and the pages of the site share.
#pragma once

#include "driver/findings.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// HTML in a page for Doxygen, which hands it on as it is.
/// \param html  HTML
/// \return a paragraph of Markdown
std::string as_is(const std::string& html);

/// A label that \\ref finds: letters, digits and underscores.
/// \param kind  for example "claim"
/// \param id    for example "2.1a"
/// \return for example "claim_2_1a"
std::string label_of(const std::string& kind, const std::string& id);

/// The name of a chapter's folder, for reading.
/// \param chapter  for example "basic_colliding"
/// \return for example "Basic colliding"
std::string chapter_title(std::string chapter);

/// Text as HTML shows it.
/// \param text  any text
/// \return the same with < > & " and \ written as entities, so that neither a browser nor Doxygen
///         takes a part of it for its own
std::string html_text(const std::string& text);

/// \param text  a sentence, in which names of code stand between backticks
/// \return the same as HTML, names as code
std::string prose_html(const std::string& text);

/// Text that stays on one line: "1e-10 s" would be broken after its hyphen.
/// \param text  any text
/// \return HTML
std::string whole_html(const std::string& text);

/// A number for reading, with at most 6 significant digits, and its unit.
/// \param value  the number; NaN gives "missing"
/// \param unit   "-" is not shown
/// \return HTML that stays on one line
std::string number_html(double value, const std::string& unit);

/// The interval over seeds of a number.
/// \param number  the number
/// \return HTML, for example " (0.1 to 0.3 over 20 seeds)"; empty if nothing is random
std::string interval_html(const CheckedNumber& number);

/// A verdict in colour and in words.
/// \param verdict  which
/// \return HTML with the classes `verdict` and the verdict's words, joined by hyphens
std::string verdict_html(Verdict verdict);

/// A line of a list of properties.
/// \param name  the property
/// \param html  its value
/// \return the elements dt and dd
std::string row_html(const std::string& name, const std::string& html);

/// A claim as a box: statement, verdict, number, rule.
/// \param entry        the claim
/// \param figure_link  where its figure is; empty if the box stands there
/// \return an HTML element of class `entry`
std::string claim_html(const LedgerEntry& entry, const std::string& figure_link);

/// How a figure is shown.
struct FigureStyle {
  std::string folder;         ///< of the pictures, from the page: "" or "figures/"
  std::string heading;        ///< "h2" or "h3"
  bool fold_numbers = false;  ///< whether the table of numbers has to be opened first
};

/// The numbers of a figure, each beside the expected one.
/// \param figure  the figure
/// \param fold    whether the table has to be opened first
/// \return an HTML `table`; empty for a figure without numbers
std::string numbers_html(const DrawnFigure& figure, bool fold);

/// A figure: picture, caption, film if it has one, claims that it decides, numbers, how to draw it again.
/// \param figure  the figure
/// \param ledger  all claims
/// \param style   how
/// \return an HTML `article` with the figure's name as its id
std::string figure_html(const DrawnFigure& figure, const std::vector<LedgerEntry>& ledger,
                        const FigureStyle& style);

/// The pictures of the gallery as a grid of thumbnails that lead to the pictures.
/// \param figures  all figures; those called `gallery_...` are taken
/// \param folder   of the pictures, from the page
/// \return an HTML element of class `gallery`; empty if there is none
std::string gallery_html(const std::vector<DrawnFigure>& figures, const std::string& folder);

/// What a figure says of itself.
/// \param figure  the figure
/// \param key     for example "title"
/// \return HTML; the figure's name as title of one that was not drawn, otherwise empty
std::string head_html(const DrawnFigure& figure, const std::string& key);

}  // namespace tumble::chapters
