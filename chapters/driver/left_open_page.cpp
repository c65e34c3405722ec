/// \file
/// \brief The page of what the thesis leaves open.
#include "driver/choices.hpp"
#include "driver/markup.hpp"
#include "driver/pages.hpp"

#include <cmath>

namespace tumble::chapters {
namespace {

std::string value_html(const ChosenValue& value) {
  const std::string unit = value.unit == "-" ? "" : ' ' + value.unit;
  const std::string text = value.value.empty()
                               ? "run <code>make figures</code>"
                               : "<strong>" + whole_html(value.value + unit) + "</strong>";
  return "<code>" + html_text(value.name) + "</code> = " + text + " <span class=\"soft\">" +
         prose_html(value.meaning) + "</span>";
}

std::string values_html(const Choice& choice, const ValueSources& sources) {
  std::string text = prose_html(choice.value);
  for (const ChosenValue& value : chosen_values(choice, sources))
    text += (text.empty() ? "" : "<br>\n") + value_html(value);
  return text;
}

std::string number_of(const VariedNumber& varied) {
  if (std::isnan(varied.number.value)) return "run <code>make figures</code>";
  const std::string text = number_html(varied.number.value, varied.number.unit);
  if (varied.verdict == Verdict::not_comparable) return text;
  return text + ' ' + verdict_html(varied.verdict);
}

std::string numbers_row(const VariedEntry& entry, const ValueSources& sources) {
  const DrawnFigure* figure = figure_of(sources.figures, entry.figure);
  const std::string target = entry.claim.empty() && figure != nullptr
                                 ? place_of_figure(figure->chapter, entry.figure)
                                 : "ledger.html#" + label_of("claim", entry.claim);
  const std::string name = entry.claim.empty() ? entry.figure : "claim " + entry.claim;
  std::string text = "<tr><td>" + prose_html(entry.chosen.number.quantity) + " (<a href=\"" +
                     target + "\">" + html_text(name) +
                     "</a>)</td><td class=\"number\" data-name=\"as it is\">" +
                     number_of(entry.chosen) + "</td><td class=\"number\">";
  for (const VariedNumber& one : entry.changed)
    text +=
        "<p><span class=\"soft\">" + prose_html(one.change) + ":</span> " + number_of(one) + "</p>";
  return text + "</td></tr>\n";
}

std::string choice_html(const ChoiceEntry& entry, const ValueSources& sources) {
  const Choice& choice = entry.choice;
  std::string text = "<div class=\"entry\">\n<p><strong>" + prose_html(choice.what) +
                     "</strong> · thesis " + html_text(choice.section) + "</p>\n<dl>\n" +
                     row_html("Ours", values_html(choice, sources)) +
                     row_html("Why", prose_html(choice.why));
  if (!choice.unmeasured.empty())
    return text + row_html("Not varied", prose_html(choice.unmeasured)) + "</dl>\n</div>\n";
  text +=
      "</dl>\n<table class=\"numbers varied\">\n<thead><tr><th>number</th><th>as it is</th>"
      "<th>with another value</th></tr></thead>\n";
  for (const VariedEntry& number : entry.numbers) text += numbers_row(number, sources);
  return text + "</table>\n</div>\n";
}

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// How many verdicts were tried, and which of them change.
std::string summary_md(const std::vector<ChoiceEntry>& choices) {
  std::size_t varied = 0;
  std::size_t tried = 0;
  std::string changing;
  for (const ChoiceEntry& entry : choices) {
    varied += entry.numbers.empty() ? 0 : 1;
    for (const VariedEntry& number : entry.numbers) {
      if (number.claim.empty()) continue;
      ++tried;
      if (!number.changes_verdict()) continue;
      std::string others;
      for (const VariedNumber& one : number.changed) {
        if (one.verdict != number.chosen.verdict)
          others +=
              (others.empty() ? "" : ", ") + verdict_text(one.verdict) + " (" + one.change + ')';
      }
      changing += "- \\ref " + label_of("claim", number.claim) + " \"" + number.claim + "\" is " +
                  verdict_text(number.chosen.verdict) + "; other values of \\ref " +
                  label_of("choice", entry.choice.id) + " \"" + entry.choice.id + "\" give " +
                  others + '\n';
    }
  }
  std::string text =
      "There are " + plural(choices.size(), "choice", "choices") + "; " + std::to_string(varied) +
      " of them were varied. A number that decides a claim was computed with other values " +
      plural(tried, "time", "times") + ".";
  if (changing.empty()) return text + "\n\n";
  return text + " These verdicts would be others:\n\n" + changing + '\n';
}

}  // namespace

std::string left_open_page(const Findings& findings, const std::vector<Tolerance>& constants) {
  const ValueSources sources{constants, findings.figures};
  std::string text = R"(# What the thesis leaves open {#left_open}

The thesis names thresholds without their values, and shows scenes without their sizes. Whatever it does give is used as
it is. Here is what had to be chosen: our value, as the program has it, the reason, and what half and twice the value
would do to the numbers that lean on it; now and then those are means over fewer random cases, as the figure says.
Every small number of the library is in \ref tolerances.

)";
  text += summary_md(findings.choices);
  std::string chapter;
  for (const ChoiceEntry& entry : findings.choices) {
    if (entry.choice.chapter != chapter)
      text += "## " + chapter_title(entry.choice.chapter) + " {#left_open_" + entry.choice.chapter +
              "}\n\n";
    chapter = entry.choice.chapter;
    text += "\\anchor " + label_of("choice", entry.choice.id) + '\n' +
            as_is(choice_html(entry, sources));
  }
  return text;
}

}  // namespace tumble::chapters
