/// \file
/// \brief The page that shows all figures.
#include "driver/markup.hpp"
#include "driver/pages.hpp"
#include "driver/reads.hpp"

#include <map>

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
        --line: #dcdcd8; --link: #00558a; --bad: #b3261e; --partly: #7a5200; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e8e6e3; --page: #16181b; --soft: #a3a3a8; --line: #34373c;
          --link: #7fc4f2; --bad: #ff8a80; --partly: #f0b95a; }
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
.entry { margin: 0.8rem 0; padding: 0.1rem 0.9rem; border: 1px solid var(--line);
         border-radius: 8px; }
.entry p { margin: 0.6rem 0; } dl { margin: 0 0 0.6rem; font-size: 0.9rem; }
dt { color: var(--soft); } dd { margin: 0 0 0.4rem; }
@media (min-width: 34rem) {
  dl { display: grid; grid-template-columns: 6rem minmax(0, 1fr); } dd { margin-bottom: 0.2rem; }
}
.verdict { padding: 0 0.5rem; border: 1px solid; border-radius: 1rem; font-weight: 600;
           font-size: 0.9rem; white-space: nowrap; color: var(--soft); }
.verdict.confirmed { color: var(--link); } .verdict.qualified { color: var(--partly); }
.verdict.refuted { color: var(--bad); }
.reads { font-size: 0.9rem; font-style: italic; color: var(--soft); }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr));
           gap: 1rem; }
.gallery figure, .film { margin: 0; } figcaption { font-size: 0.9rem; margin-top: 0.3rem; }
</style>
</head>
<body>
)";

std::string link_to(const std::string& place, const std::string& words) {
  return "<li><a href=\"#" + place + "\">" + words + "</a></li>\n";
}

}  // namespace

std::string index_page(const Findings& findings) {
  const std::string gallery = gallery_html(findings.figures, "");
  std::string contents;
  std::string articles;
  std::map<std::string, std::string> thesis;  // by name, and so by number
  for (const DrawnFigure& figure : findings.figures) {
    if (is_of_kind(figure, "gallery_")) continue;
    const std::string article = figure_html(figure, findings.ledger, {"", "h2", false});
    if (is_of_kind(figure, "fig")) {
      thesis[figure.name] = article;
      continue;
    }
    contents += link_to(figure.name, head_html(figure, "title"));
    articles += article;
  }
  if (!gallery.empty()) contents += link_to("gallery", "Gallery");

  std::string text = kTop;
  text +=
      "<h1>Figures of Tumble</h1>\n<p>Every picture is drawn by gnuplot from numbers that the "
      "library has just computed; every number in a table is compared with the value that "
      "was written down for it beforehand. The verdict on a claim of the thesis follows from its "
      "number by a rule; beside it stands how it reads with the thesis in hand.</p>\n<p>" +
      html_text(summary_text(findings)) + ". " + html_text(reads_counts(findings.ledger)) +
      ". <a href=\"claims.csv\">claims.csv</a> has every claim.</p>\n";
  text += "<p>First the figures of the thesis, then <a href=\"#others\">all others</a>.</p>\n";
  for (const auto& [name, article] : thesis) text += article;
  text += "<h2 id=\"others\">All other figures</h2>\n<nav><ul>\n" + contents + "</ul></nav>\n" +
          articles;
  if (!gallery.empty()) text += "<h2 id=\"gallery\">Gallery</h2>\n" + gallery;
  return text + "</body>\n</html>\n";
}

}  // namespace tumble::chapters
