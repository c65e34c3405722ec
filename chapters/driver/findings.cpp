/// \file
/// \brief All that the figures have found: numbers, verdicts, errata.
#include "driver/findings.hpp"

#include "driver/csv.hpp"
#include "driver/figure_texts.hpp"
#include "driver/reads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <regex>
#include <set>
#include <stdexcept>

namespace tumble::chapters {
namespace {

template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::size_t figures_of_kind(const std::vector<DrawnFigure>& figures, const std::string& prefix) {
  std::size_t count = 0;
  for (const DrawnFigure& figure : figures) count += is_of_kind(figure, prefix) ? 1 : 0;
  return count;
}

// Figures of the thesis that are drawn.
std::size_t thesis_figures(const std::vector<DrawnFigure>& figures) {
  std::set<std::string> numbers;
  for (const DrawnFigure& figure : figures)
    if (is_of_kind(figure, "fig")) numbers.insert(thesis_number(figure.name));
  return numbers.size();
}

// Adds "3 figures of the shared layers" to a list; nothing for none.
void append_count(std::string& list, std::size_t count, const std::string& one,
                  const std::string& many) {
  if (count == 0) return;
  list += (list.empty() ? "also " : ", ") + std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// All captions of a chapter, with their comments.
std::string captions_of(const std::filesystem::path& path) {
  std::string captions;
  for (const FigureText& text : read_figure_texts(path))
    captions += text.caption + '\n' + text.film + '\n';
  return captions;
}

// Half a unit of the last digit that is written, and a little for the way to decimals.
double rounding_of(const std::string& digits) {
  const std::size_t exponent = digits.find('e');
  const std::string mantissa = digits.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  const double power =
      exponent == std::string::npos ? 0.0 : read_number(digits.substr(exponent + 1));
  return 0.5000001 * std::pow(10.0, power - static_cast<double>(decimals));
}

// Markdown takes a whole number with a full stop or a bracket after it, first in its line, for an item of a list.
bool looks_like_a_list(const std::smatch& match) {
  const std::string before = match.prefix();
  const std::string after = match.suffix();
  const std::string written = match[1];
  return !match[2].matched && written.find_first_not_of("0123456789") == std::string::npos &&
         (before.empty() || before.back() == '\n') && after.size() > 1 &&
         (after[0] == '.' || after[0] == ')') && after[1] == ' ';
}

// Compares the numbers in a page or in captions with those of the figures.
//
// A number that was computed is followed by a comment that says from where:
// `15.3 <!-- cradle: quantity in words -->`, or `15.3 per cent <!-- ... -->` or `15.3 % <!-- ... -->`
// for a share. It must be the computed one, rounded to the digits that are written. Figures that were
// drawn with other settings are not compared.
std::vector<std::string> stale_numbers(const std::string& page, const std::string& name,
                                       const std::vector<DrawnFigure>& figures) {
  static const std::regex form(R"(([^\s|(]+)( per cent| %)?\s?<!--\s*(\w+):\s*([^>]*?)\s*-->)");
  std::vector<std::string> messages;
  for (std::sregex_iterator it(page.begin(), page.end(), form), end; it != end; ++it) {
    const std::smatch& match = *it;
    const std::string written = match[1];
    const std::string where = name + ": " + written + match[2].str() + " (" + match[3].str() +
                              ", " + match[4].str() + "): ";
    const double value = read_number(written);
    if (std::isnan(value)) {
      messages.push_back(where + "a comment about a number follows a number");
      continue;
    }
    if (looks_like_a_list(match))
      messages.push_back(where +
                         "begins a line and would be shown as a list: put a word before it");
    const CheckedNumber* number = number_of(figure_of(figures, match[3]), match[4]);
    if (number == nullptr) {
      messages.push_back(where + "no figure has this number");
      continue;
    }
    if (!number->compared) continue;
    const double scale = match[2].matched ? 100.0 : 1.0;
    if (!(std::abs(scale * number->value - value) <= rounding_of(written)))  // true for NaN
      messages.push_back(where + "computed is " + short_text(scale * number->value));
  }
  return messages;
}

// What is wrong with a film that README shows; nothing if it was not painted here.
std::vector<std::string> stale_film(const std::filesystem::path& film,
                                    const std::filesystem::path& folder) {
  const std::filesystem::path painted = folder / film.filename();
  if (!std::filesystem::exists(painted) || read_file(painted) == read_file(film)) return {};
  return {film.string() + ": is not the film that was painted now: look at " + painted.string() +
          " and copy it there"};
}

}  // namespace

Findings read_findings(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& files) {
  std::vector<std::filesystem::path> expected;
  std::vector<Claim> claims;
  std::vector<Second> seconds;
  std::vector<Erratum> errata;
  Choices choices;
  std::vector<std::filesystem::path> pages;
  std::vector<std::filesystem::path> films;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.filename().string();
    if (name == "expected.csv") {
      expected.push_back(file);
    } else if (name == "claims.toml" || name == "open_claims.toml") {
      append(claims, read_claims(file));
      if (name == "claims.toml") append(seconds, read_seconds(file));
    } else if (name == "errata.toml") {
      append(errata, read_errata(file));
    } else if (name == "choices.toml") {
      const Choices more = read_choices(file);
      append(choices.choices, more.choices);
      append(choices.variations, more.variations);
    } else if (file.extension() == ".md" || name == "figures.toml") {
      pages.push_back(file);
    } else if (file.extension() == ".gif") {
      films.push_back(file);
    } else {
      throw std::invalid_argument(file.string() +
                                  ": give files called expected.csv, claims.toml, "
                                  "open_claims.toml, errata.toml, choices.toml or figures.toml, a "
                                  "page NAME.md, or a film NAME.gif");
    }
  }
  Findings findings;
  findings.figures = std::filesystem::exists(folder) ? check_figures(folder, expected)
                                                     : expected_figures(expected);
  findings.ledger = judge(claims, findings.figures, seconds);
  findings.errata = find_errata(errata, findings.figures);
  findings.choices = find_choices(choices, findings.figures, findings.ledger);
  require_choices(findings.ledger, findings.choices);
  append(findings.stale, doubtful_reads(findings.ledger, findings.choices));
  for (const std::filesystem::path& page : pages) {
    const std::string text = page.extension() == ".md" ? read_file(page) : captions_of(page);
    append(findings.stale, stale_numbers(text, page.string(), findings.figures));
    append(findings.stale, stale_verdicts(text, page.string(), findings.ledger));
  }
  for (const std::filesystem::path& film : films) append(findings.stale, stale_film(film, folder));
  return findings;
}

std::vector<std::string> differences(const Findings& findings) {
  std::vector<std::string> lines;
  for (const DrawnFigure& figure : findings.figures) {
    for (const CheckedNumber& number : figure.numbers)
      if (!number.agrees()) lines.push_back(difference_text(figure.name, number));
  }
  append(lines, findings.stale);
  return lines;
}

std::string summary_text(const Findings& findings) {
  const auto open =
      static_cast<std::size_t>(std::ranges::count_if(findings.ledger, [](const LedgerEntry& entry) {
        return entry.verdict == Verdict::not_measured;
      }));
  return std::to_string(thesis_figures(findings.figures)) + " thesis figures, " +
         std::to_string(findings.ledger.size() - open) + " claims measured, " +
         std::to_string(open) + " not measured, " + std::to_string(differences(findings).size()) +
         " differ from expected";
}

std::string others_text(const Findings& findings) {
  const std::vector<DrawnFigure>& figures = findings.figures;
  const std::size_t gallery = figures_of_kind(figures, "gallery_");
  const std::size_t claims = figures_of_kind(figures, "claim");
  const std::size_t shared = figures.size() - figures_of_kind(figures, "fig") - gallery - claims;
  std::size_t set_aside = 0;
  for (const DrawnFigure& figure : figures) {
    for (const CheckedNumber& number : figure.numbers) set_aside += number.compared ? 0 : 1;
  }
  std::string text;
  append_count(text, claims, "figure of claims", "figures of claims");
  append_count(text, shared, "figure of the shared layers", "figures of the shared layers");
  append_count(text, gallery, "picture of the gallery", "pictures of the gallery");
  append_count(text, set_aside, "number not compared: drawn with other settings",
               "numbers not compared: drawn with other settings");
  return text;
}

bool is_of_kind(const DrawnFigure& figure, const std::string& prefix) {
  return figure.name.starts_with(prefix);
}

std::string thesis_number(const std::string& name) {
  std::string number = name.substr(3, name.find('_', name.find('_') + 1) - 3);
  std::replace(number.begin(), number.end(), '_', '.');
  return number;
}

bool is_drawn(const DrawnFigure& figure) { return !figure.head.empty(); }

}  // namespace tumble::chapters
