/// \file
/// \brief Whether the numbers of the figures are still those that were written down.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::chapters {

/// A number beside the one that was expected.
struct CheckedNumber {
  std::string quantity;    ///< in words
  std::string unit;        ///< "-" for a ratio or a count
  double value = 0.0;      ///< as computed; NaN if it is missing
  double low = 0.0;        ///< lower end of the interval over seeds; NaN if there is none
  double high = 0.0;       ///< upper end of the interval over seeds; NaN if there is none
  int seeds = 0;           ///< random scenes that it was measured over
  double expected = 0.0;   ///< from `expected.csv`; NaN if it is not there
  double tolerance = 0.0;  ///< [unit] absolute
  std::string reason;      ///< where the expected value and the tolerance come from
  bool compared = true;    ///< false if the figure was drawn with other settings
  /// Whether it is within its tolerance.
  /// \return false also if one of the two is missing
  [[nodiscard]] bool agrees() const;
};

/// A figure as its files describe it.
struct DrawnFigure {
  std::string name;                         ///< of its files
  std::string chapter;                      ///< the folder of the chapter that computes it
  std::map<std::string, std::string> head;  ///< comment lines `# key: value` by key
  std::vector<std::string> parameters;      ///< the lines of key "parameter", in order
  std::vector<CheckedNumber> numbers;       ///< in the order of `expected.csv`
};

/// What every figure should give, without what it gives.
/// \param expected  the `expected.csv` of each chapter, in order; the `figures.toml` beside it gives the order
///                  of the figures
/// \return every figure; each number's value is missing
/// \throws FileError for a file that cannot be read, std::invalid_argument for a line that is not
///         figure, quantity, unit, value, tolerance, reason
std::vector<DrawnFigure> expected_figures(const std::vector<std::filesystem::path>& expected);

/// Reads the numbers of all figures and puts the expected ones beside them.
///
/// The order is that of expected_figures(). A figure that was not computed has
/// missing values; one that no expected file knows comes last, without expected values: both
/// differ, so that neither can be forgotten.
/// \param folder    where `NAME_numbers.csv` are
/// \param expected  the `expected.csv` of each chapter, in order
/// \return every figure
/// \throws FileError for a folder or file that cannot be read, std::invalid_argument as
///         expected_figures() does
std::vector<DrawnFigure> check_figures(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& expected);

/// Finds a figure by its name.
/// \param figures  from check_figures()
/// \param name     the figure's name
/// \return the figure, or nullptr if there is none
const DrawnFigure* figure_of(const std::vector<DrawnFigure>& figures, const std::string& name);

/// Finds a number of a figure by its name.
/// \param figure    a figure, or nullptr
/// \param quantity  the number's name
/// \return the number, or nullptr if there is no such figure or number
const CheckedNumber* number_of(const DrawnFigure* figure, const std::string& quantity);

/// A difference in words.
/// \param figure  the figure's name
/// \param number  a number that does not agree
/// \return figure, number, value, expected value and tolerance
std::string difference_text(const std::string& figure, const CheckedNumber& number);

/// Finds a number that something else speaks of.
/// \param figures   from check_figures()
/// \param figure    the figure's name
/// \param quantity  the number's name
/// \param place     how the message begins if one of them does not exist
/// \return the number; its value may be missing
/// \throws std::invalid_argument naming the figure or quantity that does not exist
const CheckedNumber& find_number(const std::vector<DrawnFigure>& figures, const std::string& figure,
                                 const std::string& quantity, const std::string& place);

}  // namespace tumble::chapters
