/// \file
/// \brief Whether the numbers of the figures are still those that were written down.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::chapters {

// A number beside the one that was expected.
struct CheckedNumber {
  std::string quantity;    // in words
  std::string unit;        // "-" for a ratio or a count
  double value = 0.0;      // as computed; NaN if it is missing
  double low = 0.0;        // lower end of the interval over seeds; NaN if there is none
  double high = 0.0;       // upper end of the interval over seeds; NaN if there is none
  int seeds = 0;           // random scenes that it was measured over
  double expected = 0.0;   // from `expected.csv`; NaN if it is not there
  double tolerance = 0.0;  // [unit] absolute
  std::string reason;      // where the expected value and the tolerance come from
  bool compared = true;    // false if the figure was drawn with other settings
  // Whether it is within its tolerance.
  [[nodiscard]] bool agrees() const;
};

// A figure as its files describe it.
struct DrawnFigure {
  std::string name;                         // of its files
  std::string chapter;                      // the folder of the chapter that computes it
  std::map<std::string, std::string> head;  // comment lines `# key: value` by key
  std::vector<std::string> parameters;      // the lines of key "parameter", in order
  std::vector<CheckedNumber> numbers;       // in the order of `expected.csv`
};

// What every figure should give, without what it gives.
std::vector<DrawnFigure> expected_figures(const std::vector<std::filesystem::path>& expected);

// Reads the numbers of all figures and puts the expected ones beside them.
//
// The order is that of expected_figures(). A figure that was not computed has
// missing values; one that no expected file knows comes last, without expected values: both
// differ, so that neither can be forgotten.
std::vector<DrawnFigure> check_figures(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& expected);

// Finds a figure by its name.
const DrawnFigure* figure_of(const std::vector<DrawnFigure>& figures, const std::string& name);

// Finds a number of a figure by its name.
const CheckedNumber* number_of(const DrawnFigure* figure, const std::string& quantity);

// A difference in words.
std::string difference_text(const std::string& figure, const CheckedNumber& number);

// Finds a number that something else speaks of.
const CheckedNumber& find_number(const std::vector<DrawnFigure>& figures, const std::string& figure,
                                 const std::string& quantity, const std::string& place);

}  // namespace tumble::chapters
