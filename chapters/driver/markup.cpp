/// \file
/// \brief Pieces of HTML that say one thing: a text, a number, a verdict, a claim.
#include "driver/markup.hpp"

#include "driver/csv.hpp"

#include <cmath>
#include <map>
#include <regex>

namespace tumble::chapters {
namespace {

// An end of an interval: four digits, and whole numbers whole.
std::string end_html(double value) {
  return whole_html(formatted(std::abs(value) >= 1000.0 ? "%.0f" : "%.4g", value));
}

// "<= 5" as it is printed.
std::string printed_rule(std::string rule) {
  for (const auto& [typed, printed] : {std::pair{"<=", "≤"}, {">=", "≥"}}) {
    for (std::size_t at = rule.find(typed); at != std::string::npos; at = rule.find(typed)) {
      rule.replace(at, 2, printed);
    }
  }
  return html_text(rule);
}

// The number that decides, or why there is none.
std::string finding_html(const LedgerEntry& entry) {
  if (entry.verdict == Verdict::not_measured) return prose_html(entry.note);
  const CheckedNumber& number = entry.number;
  const std::string text = prose_html(number.quantity) + ": <strong>" +
                           number_html(number.value, number.unit) + "</strong>" +
                           interval_html(number);
  return number.agrees() ? text : text + ", <span class=\"bad\">not as expected</span>";
}

// A second measurement: its number, its verdict, its day, what it compares, and what would have turned it.
std::string second_html(const SecondEntry& entry) {
  const Second& second = entry.second;
  const bool measured = entry.verdict != Verdict::not_measured;
  return prose_html(second.quantity) + ": " +
         (measured ? "<strong>" + number_html(entry.number.value, second.unit) + "</strong>" +
                         interval_html(entry.number) + ' ' + verdict_html(entry.verdict) + " on " +
                         second.run
                   : prose_html(entry.note)) +
         "<br><span class=\"soft\">" + prose_html(second.scene) +
         " Control: " + prose_html(second.control) + " Rule of " + second.ruled + ": " +
         printed_rule(rule_text(second.confirmed, second.refuted)) + ". " +
         prose_html(second.otherwise) + "</span>";
}

std::string rule_html(const Claim& claim) {
  const std::string reason = "<br><span class=\"soft\">" + prose_html(claim.reason) + "</span>";
  if (!claim.comparable) return "none" + reason;
  return printed_rule(rule_text(claim.confirmed, claim.refuted)) + "; fixed " +
         (claim.ruled.empty() ? "before the first run" : prose_html(claim.ruled)) + reason;
}

}  // namespace

std::string as_is(const std::string& html) { return "\\htmlonly\n" + html + "\\endhtmlonly\n\n"; }

std::string label_of(const std::string& kind, const std::string& id) {
  std::string label = kind + '_';
  for (const char c : id) {
    const bool kept = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    label += kept ? c : '_';
  }
  return label;
}

std::string chapter_title(std::string chapter) {
  for (char& c : chapter) c = c == '_' ? ' ' : c;
  if (const std::size_t at = chapter.find("lcp"); at != std::string::npos)
    chapter.replace(at, 3, "LCP");  // letters that stand for words
  if (!chapter.empty() && chapter[0] >= 'a' && chapter[0] <= 'z') {
    chapter[0] = static_cast<char>(chapter[0] - 'a' + 'A');
  }
  return chapter.empty() ? "Others" : chapter;
}

std::string html_text(const std::string& text) {
  static const std::map<char, std::string> entities{
      {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\\', "&#92;"}};
  std::string result;
  for (const char c : text) {
    const auto entity = entities.find(c);
    result += entity == entities.end() ? std::string(1, c) : entity->second;
  }
  return result;
}

std::string prose_html(const std::string& text) {
  return std::regex_replace(html_text(text), std::regex("`([^`]*)`"), "<code>$1</code>");
}

std::string whole_html(const std::string& text) {
  return "<span class=\"whole\">" + html_text(text) + "</span>";
}

std::string number_html(double value, const std::string& unit) {
  if (std::isnan(value)) return "missing";
  return whole_html(formatted("%.6g", value) + (unit == "-" ? "" : ' ' + unit));
}

std::string interval_html(const CheckedNumber& number) {
  if (number.seeds == 0) return "";
  return " (" + end_html(number.low) + " to " + end_html(number.high) + " over " +
         std::to_string(number.seeds) + " random cases)";
}

std::string verdict_html(Verdict verdict) {
  const std::string words = verdict_text(verdict);
  std::string name = words;
  for (char& c : name) c = c == ' ' ? '-' : c;
  return "<span class=\"verdict " + name + "\">" + words + "</span>";
}

std::string words_html(const LedgerEntry& entry) {
  const std::string verdict = verdict_html(entry.verdict);
  const std::string& reads = entry.claim.reads;
  if (reads.empty()) return verdict;
  return verdict + " <span class=\"reads\">" + html_text(reads) + "</span>";
}

std::string row_html(const std::string& name, const std::string& html) {
  return "<dt>" + name + "</dt><dd>" + html + "</dd>\n";
}

std::string claim_html(const LedgerEntry& entry, const std::string& figure_link) {
  const Claim& claim = entry.claim;
  std::string text = "<div class=\"entry\">\n<p><strong>Claim " + claim.id + "</strong> " +
                     words_html(entry) + "<br>\n" + prose_html(claim.statement) + "</p>\n<dl>\n";
  if (!claim.open) {
    text += row_html("Number", finding_html(entry)) + row_html("Rule", rule_html(claim)) +
            row_html("Reads",
                     "<em>" + html_text(claim.reads) + "</em>: " + prose_html(claim.reads_because));
    for (const SecondEntry& second : entry.seconds) text += row_html("Second", second_html(second));
  }
  text += row_html("Experiment", prose_html(claim.experiment));
  if (claim.open) {
    text += row_html("Chapter", html_text(claim.chapter));
  } else {
    const std::string reading = claim.reading == "-" ? "" : " (" + claim.reading + ')';
    text += row_html("Technique", html_text(claim.technique + reading));
    if (!figure_link.empty()) {
      text += row_html("Figure", "<a href=\"" + html_text(figure_link) + "\">" +
                                     html_text(claim.figure) + "</a>");
    }
    text += row_html("Test", html_text(claim.test));
  }
  return text + "</dl>\n</div>\n";
}

std::string place_of_figure(const std::string& chapter, const std::string& figure) {
  return label_of("figures_of", chapter) + ".html#" + figure;
}

}  // namespace tumble::chapters
