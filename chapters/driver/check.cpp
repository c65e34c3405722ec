/// \file
/// \brief Whether the numbers of the figures are still those that were written down.
#include "driver/check.hpp"

#include "driver/csv.hpp"
#include "driver/figure_texts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
const std::string kNumbers = "_numbers.csv";
const std::string kProgram = "reproduce_";

DrawnFigure& figure_named(std::vector<DrawnFigure>& figures, const std::string& name) {
  for (DrawnFigure& figure : figures)
    if (figure.name == name) return figure;
  figures.emplace_back().name = name;
  return figures.back();
}

CheckedNumber& number_named(DrawnFigure& figure, const std::string& quantity) {
  for (CheckedNumber& number : figure.numbers)
    if (number.quantity == quantity) return number;
  CheckedNumber& number = figure.numbers.emplace_back();
  number.quantity = quantity;
  number.value = number.low = number.high = kMissing;
  number.expected = number.tolerance = kMissing;
  return number;
}

// What should come out: one line for each number. The file with the texts gives the order of the figures.
void read_expected(const std::filesystem::path& path, std::vector<DrawnFigure>& figures) {
  const std::string chapter = path.parent_path().filename().string();
  const std::filesystem::path texts = path.parent_path() / "figures.toml";
  if (std::filesystem::exists(texts)) {
    for (const FigureText& text : read_figure_texts(texts))
      figure_named(figures, text.name).chapter = chapter;
  }
  const auto lines = split_csv(read_file(path));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string>& cells = lines[i];
    const bool complete = cells.size() == 6 && !std::isnan(read_number(cells[3])) &&
                          read_number(cells[4]) >= 0.0 && !cells[5].empty();
    if (!complete)
      throw std::invalid_argument(path.string() + ", line '" + cells[0] +
                                  (cells.size() > 1 ? "," + cells[1] : "") +
                                  "...': give figure,quantity,unit,value,tolerance,reason");
    DrawnFigure& figure = figure_named(figures, cells[0]);
    figure.chapter = chapter;
    CheckedNumber& number = number_named(figure, cells[1]);
    number.unit = cells[2];
    number.expected = read_number(cells[3]);
    number.tolerance = read_number(cells[4]);
    number.reason = cells[5];
  }
}

// What came out: comment lines `# key: value`, then the numbers.
void read_numbers(const std::filesystem::path& path, DrawnFigure& figure) {
  const std::string text = read_file(path);
  std::istringstream in(text);
  for (std::string line; std::getline(in, line) && line.starts_with("# ");) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string key = line.substr(2, colon - 2);
    const std::string value = line.substr(colon + 2);
    if (key == "parameter") {
      figure.parameters.push_back(value);
    } else {
      figure.head[key] = value;
    }
  }
  // A figure that no expected file knows shows its chapter by its command.
  const std::string command = figure.head["command"];
  if (figure.chapter.empty() && command.starts_with(kProgram))
    figure.chapter = command.substr(kProgram.size(), command.find(' ') - kProgram.size());
  const auto lines = split_csv(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != 6) throw FileError("not a file of numbers: " + path.string());
    CheckedNumber& number = number_named(figure, lines[i][0]);
    number.unit = lines[i][1];
    number.value = read_number(lines[i][2]);
    number.low = read_number(lines[i][3]);
    number.high = read_number(lines[i][4]);
    number.seeds = static_cast<int>(read_number(lines[i][5]));
  }
  for (CheckedNumber& number : figure.numbers)
    number.compared = figure.head["settings"] == "default";
}

}  // namespace

bool CheckedNumber::agrees() const {
  return !compared || std::abs(value - expected) <= tolerance;  // false for NaN
}

std::vector<DrawnFigure> expected_figures(const std::vector<std::filesystem::path>& expected) {
  std::vector<DrawnFigure> figures;
  for (const std::filesystem::path& path : expected) read_expected(path, figures);
  return figures;
}

std::vector<DrawnFigure> check_figures(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& expected) {
  std::vector<DrawnFigure> figures = expected_figures(expected);

  // The order of a directory is up to the file system: sort.
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    files.push_back(entry.path());
  if (error) throw FileError("cannot read " + folder.string());
  std::ranges::sort(files);
  for (const std::filesystem::path& path : files) {
    const std::string name = path.filename().string();
    const bool ours = name.size() > kNumbers.size() &&
                      name.compare(name.size() - kNumbers.size(), kNumbers.size(), kNumbers) == 0;
    if (!ours) continue;
    const std::string figure = name.substr(0, name.size() - kNumbers.size());
    read_numbers(path, figure_named(figures, figure));
  }
  return figures;
}

const DrawnFigure* figure_of(const std::vector<DrawnFigure>& figures, const std::string& name) {
  for (const DrawnFigure& figure : figures)
    if (figure.name == name) return &figure;
  return nullptr;
}

const CheckedNumber* number_of(const DrawnFigure* figure, const std::string& quantity) {
  if (figure == nullptr) return nullptr;
  for (const CheckedNumber& number : figure->numbers)
    if (number.quantity == quantity) return &number;
  return nullptr;
}

std::string difference_text(const std::string& figure, const CheckedNumber& number) {
  const std::string what = figure + ", " + number.quantity + ": ";
  if (std::isnan(number.value)) return what + "expected, but not computed";
  const std::string value = full_text(number.value) + ' ' + number.unit;
  if (std::isnan(number.expected)) return what + value + ", but no expected.csv knows it";
  return what + value + ", expected " + full_text(number.expected) + " to within " +
         short_text(number.tolerance);
}

const CheckedNumber& find_number(const std::vector<DrawnFigure>& figures, const std::string& figure,
                                 const std::string& quantity, const std::string& place) {
  const DrawnFigure* drawn = figure_of(figures, figure);
  if (drawn == nullptr) throw std::invalid_argument(place + "there is no figure " + figure);
  const CheckedNumber* number = number_of(drawn, quantity);
  if (number == nullptr)
    throw std::invalid_argument(place + "figure " + figure + " has no quantity '" + quantity +
                                '\'');
  return *number;
}

}  // namespace tumble::chapters
