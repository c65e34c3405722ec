/// \file
/// \brief The page that shows all figures.
#include "driver/index_page.hpp"

#include "driver/csv.hpp"

#include <cmath>

namespace tumble::chapters {
namespace {

// Pictures keep their white ground in the dark too: their text and axes are dark.
constexpr const char* kTop = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Figures of Tumble</title>
<link rel="icon" href="data:,">
<style>
:root { color-scheme: light dark; --text: #1d1d1f; --page: #fbfbfa; --soft: #5c5c62;
        --line: #dcdcd8; --link: #00558a; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e8e6e3; --page: #16181b; --soft: #a3a3a8; --line: #34373c;
          --link: #7fc4f2; --bad: #ff8a80; }
}
body { margin: 0 auto; max-width: 46rem; padding: 1rem; font: 1rem/1.55 system-ui, sans-serif;
       color: var(--text); background: var(--page); overflow-wrap: break-word; }
h1 { font-size: 1.6rem; line-height: 1.2; } h2 { font-size: 1.25rem; line-height: 1.3; }
a { color: var(--link); }
article { border-top: 1px solid var(--line); margin-top: 2.5rem; }
.soft { color: var(--soft); font-size: 0.9rem; }
.bad { color: var(--bad); font-weight: 600; }
img { display: block; width: 100%; height: auto; background: #fff; border-radius: 8px;
      box-sizing: border-box; padding: 4px; }
pre, code { font: 0.88rem/1.5 ui-monospace, monospace; }
pre { overflow-x: auto; padding: 0.5rem 0.7rem; border: 1px solid var(--line);
      border-radius: 6px; }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; }
th, td { text-align: left; vertical-align: top; padding: 0.3rem 0.5rem 0.3rem 0;
         border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
td:first-child { overflow-wrap: break-word; width: 55%; }
td.number { font-variant-numeric: tabular-nums; } .whole { white-space: nowrap; }
summary { cursor: pointer; } nav li { margin: 0.2rem 0; }
</style>
</head>
<body>
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string head(const DrawnFigure& figure, const std::string& key) {
  const auto found = figure.head.find(key);
  return found == figure.head.end() ? std::string() : escaped(found->second);
}

// Text that stays on one line: "1e-10 s" would be broken after its hyphen.
std::string whole(const std::string& text) {
  return "<span class=\"whole\">" + escaped(text) + "</span>";
}

std::string number_row(const CheckedNumber& number) {
  const std::string unit = number.unit == "-" ? "" : ' ' + number.unit;
  const std::string value =
      std::isnan(number.value) ? "missing" : whole(short_text(number.value) + unit);
  std::string expected = "no expected value";
  if (!number.compared) {
    expected = "not compared: other settings";
  } else if (!std::isnan(number.expected)) {
    expected = whole(short_text(number.expected)) + ' ' +
               whole("± " + short_text(number.tolerance) + unit);
  }
  return "<tr><td>" + escaped(number.quantity) + "<br><span class=\"soft\">" +
         escaped(number.reason) + "</span></td><td class=\"number\">" +
         (number.agrees() ? value : "<span class=\"bad\">" + value + "</span>") +
         "<br><span class=\"soft\">" + expected + "</span></td></tr>\n";
}

// One figure. The settings are those of the last drawing; `make figure` draws others elsewhere.
std::string article(const DrawnFigure& figure) {
  const std::string& name = figure.name;
  std::string text = "<article id=\"" + name + "\">\n<h2>" + head(figure, "title") + "</h2>\n" +
                     "<p class=\"soft\">" + name + " · thesis " + head(figure, "thesis") +
                     "</p>\n<a href=\"" + name + ".png\"><img src=\"" + name + ".svg\" alt=\"" +
                     head(figure, "title") + "\"></a>\n<p>" + head(figure, "caption") + "</p>\n";
  text +=
      "<table>\n<tr><th>number</th><th>here<br><span class=\"soft\">expected</span></th></tr>\n";
  for (const CheckedNumber& number : figure.numbers) text += number_row(number);
  text += "</table>\n<details>\n<summary>Draw it again, with other parameters</summary>\n";
  text +=
      "<pre>make figure NAME=" + name + "\nmake figure NAME=" + name + " SET='key=value'</pre>\n";
  text += "<ul>\n";
  for (const std::string& parameter : figure.parameters) {
    text += "<li><code>" + escaped(parameter) + "</code></li>\n";
  }
  text += "</ul>\n<p class=\"soft\">The numbers were computed by <code>" + head(figure, "command") +
          "</code>.</p>\n</details>\n<p class=\"soft\"><a href=\"" + name + ".csv\">" + name +
          ".csv</a> · <a href=\"" + name + ".svg\">svg</a> · <a href=\"" + name +
          ".png\">png</a></p>\n</article>\n";
  return text;
}

}  // namespace

std::string index_page(const std::vector<DrawnFigure>& figures) {
  std::string text = kTop;
  text +=
      "<h1>Figures of Tumble</h1>\n<p>Every picture is drawn by gnuplot from numbers that the "
      "library has just computed; every number in a table is compared with the value that "
      "was written down for it beforehand.</p>\n<p>" +
      escaped(summary_text(figures)) + ".</p>\n";
  text += "<nav><ul>\n";
  for (const DrawnFigure& figure : figures) {
    text += "<li><a href=\"#" + figure.name + "\">" + head(figure, "title") + "</a></li>\n";
  }
  text += "</ul></nav>\n";
  for (const DrawnFigure& figure : figures) text += article(figure);
  return text + "</body>\n</html>\n";
}

}  // namespace tumble::chapters
