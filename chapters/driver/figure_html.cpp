/// \file
/// \brief A figure in HTML: picture, caption, claims, numbers, how to draw it again.
#include "driver/csv.hpp"
#include "driver/markup.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace tumble::chapters {
namespace {

std::string number_row(const CheckedNumber& number) {
  const std::string unit = number.unit == "-" ? "" : ' ' + number.unit;
  const std::string value =
      std::isnan(number.value) ? "missing" : whole_html(short_text(number.value) + unit);
  std::string expected = "no expected value";
  if (!number.compared) {
    expected = "not compared: other settings";
  } else if (!std::isnan(number.expected)) {
    expected = whole_html(short_text(number.expected)) + ' ' +
               whole_html("± " + short_text(number.tolerance) + unit);
  }
  return "<tr><td>" + prose_html(number.quantity) + "<br><span class=\"soft\">" +
         prose_html(number.reason) + "</span></td><td class=\"number\">" +
         (number.agrees() ? value : "<span class=\"bad\">" + value + "</span>") +
         interval_html(number) + "<br><span class=\"soft\">" + expected + "</span></td></tr>\n";
}

// The picture in one form, leading to the other.
std::string picture(const DrawnFigure& figure, const std::string& folder, const std::string& shown,
                    const std::string& behind) {
  const std::string file = folder + figure.name;
  return "<a href=\"" + file + behind + "\"><img class=\"drawn\" loading=\"lazy\" src=\"" + file +
         shown + "\" alt=\"" + head_html(figure, "title") + "\"></a>\n";
}

// Its film, if it has one; readers that want no motion get the picture.
std::string film(const DrawnFigure& figure, const std::string& folder) {
  if (figure.head.count("film") == 0) return "";
  const std::string file = folder + figure.name;
  return "<figure class=\"film\"><picture><source media=\"(prefers-reduced-motion: reduce)\" "
         "srcset=\"" +
         file + ".png\"><img class=\"drawn\" loading=\"lazy\" src=\"" + file +
         ".gif\" alt=\"Film: " + head_html(figure, "title") + "\"></picture>\n<figcaption>" +
         head_html(figure, "film") + "</figcaption></figure>\n";
}

// How to draw it again, and what can be changed.
std::string recipe(const DrawnFigure& figure) {
  std::string text =
      "<details>\n<summary>Draw it again, with other parameters</summary>\n<pre>make figure NAME=" +
      figure.name + "\nmake figure NAME=" + figure.name + " SET='key=value'</pre>\n<ul>\n";
  for (const std::string& parameter : figure.parameters)
    text += "<li><code>" + html_text(parameter) + "</code></li>\n";
  return text + "</ul>\n<p class=\"soft\">The numbers were computed by <code>" +
         head_html(figure, "command") + "</code>.</p>\n</details>\n";
}

// A command in a caption: "--set" is not broken after its hyphens.
std::string with_whole_options(std::string html) {
  for (std::size_t at = html.find(" --"); at != std::string::npos; at = html.find(" --", at)) {
    const std::size_t end = std::min(html.find(' ', at + 1), html.size());
    const std::string option = html.substr(at + 1, end - at - 1);
    html.replace(at + 1, option.size(), "<span class=\"whole\">" + option + "</span>");
    ++at;
  }
  return html;
}

// Of the tables only the numbers are there under the same name for every figure.
std::string files(const DrawnFigure& figure, const std::string& folder) {
  const std::string& name = figure.name;
  const std::string file = folder + name;
  return "<p class=\"soft\"><a href=\"" + file + "_numbers.csv\">" + name +
         "_numbers.csv</a> · <a href=\"" + file + ".svg\">svg</a> · <a href=\"" + file +
         ".png\">png</a>" +
         (figure.head.count("film") > 0 ? " · <a href=\"" + file + ".gif\">gif</a>" : "") +
         "</p>\n";
}

}  // namespace

std::string numbers_html(const DrawnFigure& figure, bool fold) {
  if (figure.numbers.empty()) return "";
  std::string text =
      "<table class=\"numbers\">\n<tr><th>number</th><th>here<br><span class=\"soft\">expected"
      "</span></th></tr>\n";
  for (const CheckedNumber& number : figure.numbers) text += number_row(number);
  text += "</table>\n";
  if (!fold) return text;
  return "<details>\n<summary>Numbers, and what was expected</summary>\n" + text + "</details>\n";
}

std::string head_html(const DrawnFigure& figure, const std::string& key) {
  const auto found = figure.head.find(key);
  if (found != figure.head.end()) return html_text(found->second);
  return key == "title" ? figure.name : std::string();
}

// The settings are those of the last drawing; `make figure` draws others elsewhere.
std::string figure_html(const DrawnFigure& figure, const std::vector<LedgerEntry>& ledger,
                        const FigureStyle& style) {
  std::string text = "<article id=\"" + figure.name + "\">\n<" + style.heading + ">" +
                     head_html(figure, "title") + "</" + style.heading + ">\n<p class=\"soft\">" +
                     figure.name;
  if (is_drawn(figure)) {
    text += " · thesis " + head_html(figure, "thesis") + "</p>\n" +
            picture(figure, style.folder, ".svg", ".png") + "<p>" + head_html(figure, "caption") +
            "</p>\n" + film(figure, style.folder);
  } else {
    text += "</p>\n<p>Not measured here: run <code>make figures</code>.</p>\n";
  }
  for (const LedgerEntry& entry : ledger)
    if (entry.claim.figure == figure.name) text += claim_html(entry, "");
  text += numbers_html(figure, style.fold_numbers);
  if (is_drawn(figure)) text += recipe(figure) + files(figure, style.folder);
  return text + "</article>\n";
}

// A scene of many boxes is a small PNG and a large SVG.
std::string gallery_html(const std::vector<DrawnFigure>& figures, const std::string& folder) {
  std::string text;
  // Twelve that differ; the others stand in their chapters.
  const std::set<std::string> left_out = {"box_drop",  "bouncing_box",
                                          "two_boxes", "slide",
                                          "slope",     "rocking_block",
                                          "toss",      "line",
                                          "cage",      "fig5_1",
                                          "fig5_6",    "fig6_1",
                                          "pyramid",   "crate_off_table",
                                          "chain",     "pendulum",
                                          "stack",     "wall"};
  for (const DrawnFigure& figure : figures) {
    if (!is_of_kind(figure, "gallery_") || !is_drawn(figure)) continue;
    if (left_out.contains(figure.name.substr(std::string_view("gallery_").size()))) continue;
    text += "<figure id=\"" + figure.name + "\">\n" + picture(figure, folder, ".png", ".svg") +
            "<figcaption>" + head_html(figure, "title") + "<br>\n<span class=\"soft\">" +
            with_whole_options(head_html(figure, "caption")) + "</span></figcaption>\n</figure>\n";
  }
  return text.empty() ? text : "<div class=\"gallery\">\n" + text + "</div>\n";
}

}  // namespace tumble::chapters
