/// \file
/// \brief The thesis's table of contents, and where each section is in this book.
#include "driver/thesis_map.hpp"

#include "driver/markup.hpp"
#include "driver/records.hpp"

#include <algorithm>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const RecordForm kForm{
    "section", {"id", "title", "state"}, {"about", "pages", "figures", "because"}};

void check_section(const ThesisSection& section) {
  const bool out = section.state == "out of scope";
  if (section.state != "here" && section.state != "not yet" && !out)
    throw std::invalid_argument(section.place + "state '" + section.state +
                                "': give here, not yet or out of scope");
  if (section.state == "here" && (section.pages.empty() || section.about.empty()))
    throw std::invalid_argument(section.place + "it is here: give pages and about");
  if (out == section.because.empty())
    throw std::invalid_argument(section.place + "because: give it if and only if out of scope");
}

// Figures that stand under a number of the thesis. Of two pictures of one figure, the second is one more link.
std::string figures_html(const ThesisSection& section, const Findings& findings) {
  std::string text;
  std::string last;
  for (const std::string& name : section.figures) {
    const DrawnFigure* figure = figure_of(findings.figures, name);
    if (figure == nullptr)
      throw std::invalid_argument(section.place + "no figure is called " + name);
    const std::string number = "figure " + thesis_number(name);
    text += "<a href=\"" + place_of_figure(figure->chapter, name) + "\">" +
            (number == last ? "the same, another picture" : number) + "</a><br>";
    last = number;
  }
  return text;
}

// The claims of a section with their verdicts, then the tests that hold them.
std::string claims_html(const ThesisSection& section, const Findings& findings) {
  std::string claims;
  std::string tests;
  int count = 0;
  for (const LedgerEntry& entry : findings.ledger) {
    const Claim& claim = entry.claim;
    if (claim.section != section.id) continue;
    claims += "<a href=\"ledger.html#" + label_of("claim", claim.id) + "\">" + claim.id + "</a> " +
              words_html(entry) + "<br>";
    if (claim.test.empty()) continue;
    tests += "<br>" + html_text(claim.test);
    ++count;
  }
  if (count == 0) return claims;
  return claims + "<details><summary>" + std::to_string(count) + (count == 1 ? " test" : " tests") +
         "</summary><span class=\"soft\">" + tests.substr(4) + "</span></details>";
}

std::string references(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : "; ") + ("\\ref " + label);
  return text;
}

std::string row(const ThesisSection& section, const Findings& findings) {
  std::string here = section.about;
  if (section.state != "here") here = "<strong>" + section.state + "</strong>. " + here;
  if (!section.because.empty()) here += "It is left out because " + section.because + '.';
  if (!section.pages.empty()) here += "<br>" + references(section.pages);
  return "<tr><td>\\anchor " + label_of("map", section.id) + " <strong>" + section.id +
         "</strong> " + section.title + "</td><td>" + here + "</td><td>\\htmlonly " +
         figures_html(section, findings) + claims_html(section, findings) +
         "\\endhtmlonly</td></tr>\n";
}

}  // namespace

std::vector<ThesisSection> read_thesis_map(const std::filesystem::path& path) {
  std::vector<ThesisSection> sections;
  for (Record& record : read_records(path, kForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    const ThesisSection section{texts["id"],
                                texts["title"],
                                texts["state"],
                                texts["about"],
                                texts["because"],
                                words_of(texts["pages"]),
                                words_of(texts["figures"]),
                                record.place};
    check_section(section);
    if (!sections.empty() && !earlier_in_thesis(sections.back().id, section.id))
      throw std::invalid_argument(section.place + "it does not come after " + sections.back().id);
    sections.push_back(section);
  }
  return sections;
}

std::string thesis_map_page(const std::vector<ThesisSection>& sections, const Findings& findings) {
  for (const LedgerEntry& entry : findings.ledger) {
    const auto is_its = [&](const ThesisSection& one) { return one.id == entry.claim.section; };
    if (std::ranges::none_of(sections, is_its))
      throw std::invalid_argument(entry.claim.place + "the map has no section " +
                                  entry.claim.section);
  }
  std::string text = R"(# The thesis and this book {#thesis_map}

The thesis's table of contents on the left; beside it what this book has of each section, and what was measured: its numbered
figures, its claims with their verdicts, and the tests that hold them.

Where to get the thesis: K. Egan, *Techniques for Real-Time Rigid Body Simulation*, honors thesis, Department of Computer
Science, Brown University, 2003. A search for author and title finds it; it is not part of this project. Nothing here needs it, but all
of it is meant to be read beside it.

)";
  std::string chapter;
  for (const ThesisSection& section : sections) {
    const std::string its = section.id.substr(0, section.id.find('.'));
    if (its != chapter) {
      if (!chapter.empty()) text += "</table>\n\n";
      text += (its == "A" ? "## Appendix A" : "## Chapter " + its) + " {#map_" + its +
              "}\n\n<table class=\"map\">\n<tr><th>Thesis</th><th>This "
              "book</th><th>Measured</th></tr>\n";
    }
    chapter = its;
    text += row(section, findings);
  }
  return text + (sections.empty() ? "" : "</table>\n");
}

}  // namespace tumble::chapters
