/// \file
/// \brief The page that shows appendix A line by line beside the source.
#include "driver/appendix_a.hpp"
#include "driver/markup.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace tumble::chapters {
namespace {

// "COLLIDE" gives "collide".
std::string lower(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name;
}

std::string line_label(const AppendixListing& listing, int line) {
  return lower(listing.name) + '_' + std::to_string(line);
}

std::string link_html(const std::string& target, const std::string& text) {
  return "<a href=\"" + target + "\">" + html_text(text) + "</a>";
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string code_html(const SourceExcerpt& code) {
  const std::string place =
      link_html(source_link(code.path, code.first), "line " + std::to_string(code.first));
  if (code.lines.empty()) return "<p class=\"soft\">no statement of its own, " + place + "</p>";
  std::string text = "<p>" + place + "</p><pre class=\"listed\">";
  for (const std::string& line : code.lines) text += html_text(line) + '\n';
  if (code.cut) text += "…\n";
  return text + "</pre>";
}

std::string cell_html(const std::string& name, const std::vector<SourceExcerpt>& code) {
  std::string text = "<td data-name=\"" + name + "\">";
  for (const SourceExcerpt& one : code) text += code_html(one);
  return text + "</td>\n";
}

// Why the code is not what is printed.
std::string reasons_html(const AppendixLine& line, const std::vector<ErratumEntry>& errata) {
  std::string text;
  for (const std::string& id : line.errata) {
    const auto entry =
        std::ranges::find_if(errata, [&](const ErratumEntry& one) { return one.erratum.id == id; });
    if (entry == errata.end())
      throw std::invalid_argument(line.place + "there is no erratum '" + id + '\'');
    text += "<p>" + link_html("errata.html#" + label_of("erratum", id), id) + " (" +
            entry->erratum.kind + "): " + prose_html(entry->erratum.printed) +
            " <strong>Read as:</strong> " + prose_html(entry->erratum.reading) + "</p>";
  }
  if (!line.why.empty()) text += "<p>" + prose_html(line.why) + "</p>";
  return text;
}

std::string rows_of(const AppendixListing& listing, const AppendixLine& line,
                    const std::vector<ErratumEntry>& errata) {
  const std::string label = line_label(listing, line.number);
  const std::string reasons = reasons_html(line, errata);
  std::string text = "<tbody id=\"" + label + "\">\n<tr><th scope=\"rowgroup\"" +
                     (reasons.empty() ? "" : " rowspan=\"2\"") + ">" +
                     link_html('#' + label, std::to_string(line.number)) + "</th>\n<td><p>" +
                     prose_html(line.says) + "</p></td>\n" + cell_html("As printed", line.printed) +
                     cell_html("As meant", line.meant) + "</tr>\n";
  if (!reasons.empty()) text += "<tr><td class=\"why\" colspan=\"3\">" + reasons + "</td></tr>\n";
  return text + "</tbody>\n";
}

// The files of a reading, in the order in which they come.
std::string files_html(const AppendixListing& listing,
                       std::vector<SourceExcerpt> AppendixLine::*reading) {
  std::vector<std::string> paths;
  std::string text;
  for (const AppendixLine& line : listing.lines) {
    for (const SourceExcerpt& code : line.*reading) {
      if (std::ranges::find(paths, code.path) != paths.end()) continue;
      paths.push_back(code.path);
      text += (text.empty() ? "" : ", ") +
              link_html(source_link(code.path, code.first), file_name(code.path));
    }
  }
  return text;
}

std::string listing_md(const AppendixListing& listing, const std::vector<ErratumEntry>& errata) {
  std::string text =
      "## " + listing.name + " {#appendix_a_" + lower(listing.name) + "}\n\n" +
      prose_html(listing.about) + " Thesis " + listing.section +
      "; described in the chapter \\ref " + listing.chapter + ".\n\n" +
      (listing.mends.empty() ? "" : "**Mended also as printed:** " + listing.mends + "\n\n");
  std::string table =
      "<table class=\"listing\">\n<thead><tr><th scope=\"col\">Line</th><th scope=\"col\">What it "
      "says</th><th scope=\"col\">As printed<br>" +
      files_html(listing, &AppendixLine::printed) + "</th><th scope=\"col\">As meant<br>" +
      files_html(listing, &AppendixLine::meant) + "</th></tr></thead>\n";
  for (const AppendixLine& line : listing.lines) table += rows_of(listing, line, errata);
  return text + as_is(table + "</table>\n");
}

// The listings with their lines, to jump to.
std::string jumps_html(const std::vector<AppendixListing>& listings) {
  std::string text = "<nav class=\"jumps\">\n";
  for (const AppendixListing& listing : listings) {
    text += "<p>" + link_html("#appendix_a_" + lower(listing.name), listing.name);
    for (const AppendixLine& line : listing.lines)
      text += ' ' + link_html('#' + line_label(listing, line.number), std::to_string(line.number));
    text += "</p>\n";
  }
  return text + "</nav>\n";
}

}  // namespace

std::string source_link(const std::string& path, std::size_t line) {
  std::string page;
  for (const char c : file_name(path)) {
    if (c == '_' || c == '.') {
      page += c == '_' ? "__" : "_8";
    } else {
      page += c;
    }
  }
  char anchor[24];
  std::snprintf(anchor, sizeof anchor, "#l%05zu", line);
  return page + "_source.html" + anchor;
}

std::string appendix_page(const std::vector<AppendixListing>& listings,
                          const std::vector<ErratumEntry>& errata) {
  std::size_t lines = 0;
  for (const AppendixListing& listing : listings) lines += listing.lines.size();
  std::string text =
      "# Appendix A side by side {#appendix_a}\n\nThe thesis ends with " +
      std::to_string(listings.size()) + " listings, " + std::to_string(lines) +
      R"( numbered lines in all. Here each line is retold beside the source that does it, twice: as
printed, mistakes included, and as meant, which is what the technique does (\ref how_to_read_readings). Where
the two differ, the erratum below the line gives the reason; its entry in \ref errata has the numbers that show it. A line
number above code leads to that line of the file.

)";
  text += as_is(jumps_html(listings));
  for (const AppendixListing& listing : listings) text += listing_md(listing, errata);
  return text;
}

}  // namespace tumble::chapters
