/// \file
/// \brief The pages of the site that are made from numbers, claims and constants.
#include "driver/pages.hpp"

#include "driver/markup.hpp"
#include "driver/reads.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::chapters {
namespace {

// "5 confirmed, 1 refuted, 59 not measured": verdicts that nothing got are left out.
std::string counts_of(const std::vector<LedgerEntry>& ledger) {
  std::string text;
  for (const Verdict verdict : {Verdict::confirmed, Verdict::qualified, Verdict::refuted,
                                Verdict::not_comparable, Verdict::not_measured}) {
    std::size_t count = 0;
    for (const LedgerEntry& entry : ledger) count += entry.verdict == verdict ? 1 : 0;
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + verdict_text(verdict);
  }
  return text;
}

// "40 verdicts stand, ...": how the verdicts read; nothing without verdicts.
std::string reads_of(const std::vector<LedgerEntry>& ledger) {
  return "Read with the thesis in hand: " + reads_counts(ledger);
}

// The measured claims at a glance.
std::string overview_html(const std::vector<LedgerEntry>& ledger) {
  std::string text;
  for (const LedgerEntry& entry : ledger) {
    if (entry.verdict == Verdict::not_measured) continue;
    const Claim& claim = entry.claim;
    text += "<p><a href=\"#" + label_of("claim", claim.id) + "\">" + claim.id + "</a> " +
            words_html(entry) + ' ' + prose_html(claim.statement) + "</p>\n";
  }
  return text.empty() ? text : as_is("<div class=\"entry overview\">\n" + text + "</div>\n");
}

std::string claims_html(const std::vector<LedgerEntry>& ledger, bool measured) {
  std::string text;
  for (const LedgerEntry& entry : ledger) {
    if ((entry.verdict != Verdict::not_measured) != measured) continue;
    text += "\\anchor " + label_of("claim", entry.claim.id) + '\n' +
            as_is(claim_html(entry, place_of_figure(entry.claim.chapter, entry.claim.figure)));
  }
  return text.empty() ? "None here: run `make figures`.\n\n" : text;
}

std::string finding(const CheckedNumber& number) {
  const std::string value = std::isnan(number.value)
                                ? "not measured here: run <code>make figures</code>"
                                : "<strong>" + number_html(number.value, number.unit) + "</strong>";
  return prose_html(number.quantity) + ": " + value;
}

// Where an erratum shows, and its two numbers.
std::string experiment_html(const ErratumEntry& entry) {
  const Erratum& erratum = entry.erratum;
  const bool misprint = erratum.kind == "misprint";
  return row_html("Shown by", prose_html(erratum.scene)) +
         row_html("Literally", finding(entry.failure)) +
         row_html(misprint ? "Corrected" : "Otherwise", finding(entry.mended)) +
         row_html("Figure", "<a href=\"" + place_of_figure(erratum.chapter, erratum.figure) +
                                "\">" + html_text(erratum.figure) + "</a>") +
         row_html("Test", html_text(erratum.test)) +
         row_html("Command", "<code>" + html_text(erratum.command) + "</code>") + "</dl>\n</div>\n";
}

std::string erratum_html(const ErratumEntry& entry) {
  const Erratum& erratum = entry.erratum;
  return "<div class=\"entry\">\n<p><strong>" + html_text(erratum.id) + ". " +
         prose_html(erratum.title) + "</strong><br>\n" + erratum.kind + " · thesis " +
         html_text(erratum.section) + "</p>\n<dl>\n" +
         row_html("Printed", prose_html(erratum.printed)) +
         row_html("Read as", prose_html(erratum.reading)) +
         (erratum.kind == "wording" ? "</dl>\n</div>\n" : experiment_html(entry));
}

// All errata with their titles, section by section of the thesis.
std::string errata_list_html(const std::vector<ErratumEntry>& errata) {
  std::string text;
  std::string section;
  for (const ErratumEntry& entry : errata) {
    const Erratum& erratum = entry.erratum;
    if (erratum.section != section)
      text += (text.empty() ? "" : "</ul>\n") + ("<p>Thesis " + html_text(erratum.section)) +
              "</p>\n<ul>\n";
    section = erratum.section;
    text += "<li><a href=\"#" + label_of("erratum", erratum.id) + "\">" + html_text(erratum.id) +
            "</a> " + prose_html(erratum.title) + "</li>\n";
  }
  return text.empty() ? text : as_is(text + "</ul>\n");
}

std::string tolerance_html(const Tolerance& tolerance) {
  const std::string unit = tolerance.unit == "-" ? "" : ' ' + tolerance.unit;
  return "<div class=\"entry\">\n<p><code>" + html_text(tolerance.name) + "</code> = <strong>" +
         whole_html(tolerance.value + unit) + "</strong><br>\n" + prose_html(tolerance.meaning) +
         "</p>\n<p class=\"soft\">Reason: " + prose_html(tolerance.reason) + " (" +
         html_text(tolerance.section) + ")</p>\n</div>\n";
}

// Links to the parts of a long page, each once and in their order.
std::string jumps_md(const std::string& kind, const std::vector<std::string>& parts) {
  std::string text;
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    if (part != parts.begin() && *part == *(part - 1)) continue;
    text += (text.empty() ? "" : " · ") + ("\\ref " + label_of(kind, *part)) + " \"" +
            chapter_title(*part) + '"';
  }
  return text.empty() ? text : text + "\n\n";
}

std::string part_md(const std::string& kind, const std::string& part) {
  return "\\anchor " + label_of(kind, part) + "\n\n## " + chapter_title(part) + "\n\n";
}

// What figures measure of each technique on the same scene.
std::string techniques_md(const std::vector<DrawnFigure>& figures) {
  std::string text;
  for (const DrawnFigure& figure : figures) {
    if (!is_of_kind(figure, "technique_gaps") || figure.numbers.empty()) continue;
    text += "### " + head_html(figure, "title") + "\n\n" +
            as_is("<div class=\"entry\">\n<p><a href=\"" +
                  place_of_figure(figure.chapter, figure.name) + "\">" + figure.name +
                  "</a></p>\n" + numbers_html(figure, false) + "</div>\n");
  }
  if (text.empty()) return text;
  return "## Each technique on the same scene {#ledger_techniques}\n\n" + text;
}

}  // namespace

std::string counts_text(const Findings& findings) {
  const auto words = static_cast<std::size_t>(std::ranges::count_if(
      findings.errata, [](const ErratumEntry& one) { return one.erratum.kind == "wording"; }));
  return "Of " + std::to_string(findings.ledger.size()) +
         " claims of the thesis: " + counts_of(findings.ledger) + ". " + reads_of(findings.ledger) +
         ". " + std::to_string(findings.errata.size() - words) +
         " errata, each with the two numbers that show it, and " + std::to_string(words) +
         " slips of wording.\n";
}

std::string ledger_page(const Findings& findings) {
  std::string text = R"(# Ledger of claims {#ledger}

The thesis argues from experience and prints hardly a number. Here each thing that it says is an
experiment: one number decides, by a rule that was written down before the experiment ran for the
first time. Of )";
  text += std::to_string(findings.ledger.size()) + " claims: " + counts_of(findings.ledger) + R"(.

A rule can be a bad reading of its sentence, and a number can depend on a value that is ours. The rules stay as they are, and so each
verdict has a second word, from a reading with the thesis in hand: it *stands*; or its *rule misread the sentence*; or it *hangs on* a
choice that the thesis leaves open (\ref left_open). )";
  text +=
      reads_of(findings.ledger) +
      R"(. Where a verdict needs a fairer scene or a comparison, a second measurement stands beside the
first, with its own rule and the day on which it was made.

The same as a table: \htmlonly <a href="figures/claims.csv">claims.csv</a> \endhtmlonly

)";
  text += overview_html(findings.ledger);
  text += "## Measured {#ledger_measured}\n\n" + claims_html(findings.ledger, true);
  text += techniques_md(findings.figures);
  text += "## Not measured {#ledger_not_measured}\n\n" + claims_html(findings.ledger, false);
  return text;
}

std::string errata_page(const Findings& findings) {
  std::string text = R"(# Errata of the thesis {#errata}

A *misprint* contradicts what the thesis itself says elsewhere, cannot be computed, or does not end, under every plausible
reading: the techniques correct it. A *choice* was meant by the author, or the text leaves it open: the techniques of the thesis
keep it, in the milder reading, and other solutions are in our own. Each of both has a scene in which it shows and two numbers: the text
taken literally, or in its worst reading, and what we do. A slip of *wording* changes nothing that is computed.

)";
  if (findings.errata.empty()) text += "No chapter has found one yet.\n\n";
  text += errata_list_html(findings.errata);
  for (const ErratumEntry& entry : findings.errata) {
    text += "\\anchor " + label_of("erratum", entry.erratum.id) + '\n' + as_is(erratum_html(entry));
  }
  return text;
}

std::string tolerances_page(const std::vector<Tolerance>& tolerances) {
  std::string text =
      "# Small numbers {#tolerances}\n\nEvery tolerance and threshold of the library, " +
      std::to_string(tolerances.size()) + R"( of them, as
the tolerances.hpp of each folder in src/tumble defines them. Those without a unit are ratios and hold for boxes of any
size and mass. "The same" refers to the number before; `0x1p-27` is 2 to the power of -27.

)";
  std::vector<std::string> layers;
  for (const Tolerance& tolerance : tolerances) layers.push_back(tolerance.layer);
  text += jumps_md("small_numbers", layers);
  std::string layer;
  for (const Tolerance& tolerance : tolerances) {
    if (tolerance.layer != layer) text += part_md("small_numbers", tolerance.layer);
    layer = tolerance.layer;
    text += as_is(tolerance_html(tolerance));
  }
  return text;
}

std::vector<std::string> figure_chapters(const Findings& findings) {
  std::vector<std::string> chapters;
  for (const DrawnFigure& figure : findings.figures)
    if (!is_of_kind(figure, "gallery_") && (chapters.empty() || chapters.back() != figure.chapter))
      chapters.push_back(figure.chapter);
  return chapters;
}

std::string gallery_page(const Findings& findings) {
  std::string text = R"(# Gallery and figures {#gallery}

All pictures are drawn from numbers that the library has computed; `make figures` draws them again.

## Twelve scenes {#gallery_scenes}

)";
  const std::string thumbnails = gallery_html(findings.figures, "figures/");
  if (!thumbnails.empty()) text += as_is(thumbnails);
  text +=
      "\n## All figures {#gallery_figures}\n\nWith their numbers, and how to draw them again:\n\n";
  for (const std::string& chapter : figure_chapters(findings))
    text += "- \\subpage " + label_of("figures_of", chapter) + '\n';
  return text;
}

std::string figures_page(const Findings& findings, const std::string& chapter) {
  std::string text = "# Figures: " + chapter_title(chapter) + " {#" +
                     label_of("figures_of", chapter) + "}\n\nTo the chapter: \\ref " +
                     (chapter == "choosing" ? "choose_a_technique" : chapter) + ".\n\n";
  for (const DrawnFigure& figure : findings.figures)
    if (figure.chapter == chapter && !is_of_kind(figure, "gallery_"))
      text += as_is(figure_html(figure, findings.ledger, {"figures/", "h3", true}));
  return text;
}

}  // namespace tumble::chapters
