/// \file
/// \brief What a figure is before it is drawn: parameters in, tables and numbers out.
#pragma once

#include "tumble/base/parameters.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The programs that compute the figures, and the page that shows them.
///
/// A chapter hands over a list of figures; the driver gives them a command line, writes their
/// numbers into files and gnuplot draws from those. Nothing that a reader sees on a picture was
/// typed by hand.
namespace tumble::chapters {

/// One column of a table.
struct Column {
  std::string name;     ///< with its unit as suffix, for example "time_s"
  std::string unit;     ///< "s"; "-" for a ratio or a count
  std::string meaning;  ///< one line
};

/// Rows of numbers: one CSV file. NaN is an empty cell.
struct Table {
  std::string suffix;                          ///< file is `figure.csv`, or `figure_suffix.csv`
  std::vector<Column> columns;                 ///< what the rows hold
  std::vector<std::vector<double>> rows = {};  ///< each as long as `columns`
};

/// A number that the figure is about, compared with `expected.csv` after drawing.
struct Quantity {
  std::string name;                                        ///< in words, unique within the figure
  std::string unit;                                        ///< "-" for a ratio or a count
  double value = 0.0;                                      ///< as computed in this run
  double low = std::numeric_limits<double>::quiet_NaN();   ///< lower end of the interval over seeds
  double high = std::numeric_limits<double>::quiet_NaN();  ///< upper end of the interval over seeds
  int seeds = 0;  ///< random scenes that it was measured over; 0: nothing is random
};

/// Commands of gnuplot that were computed, such as boxes in three dimensions: a script loads them.
struct Drawing {
  std::string suffix;    ///< file is `figure_suffix.gp`
  std::string commands;  ///< its bytes
};

/// All that one run of a figure computed.
struct Result {
  std::vector<Table> tables;           ///< what gnuplot draws from
  std::vector<Quantity> quantities;    ///< what is checked
  std::vector<Drawing> drawings = {};  ///< what gnuplot is to draw as it is
  /// Paints the film of the figure: the bytes of a GIF. Empty: it has none. The driver alone asks for it, since
  /// it takes seconds.
  std::function<std::string()> film = {};
};

/// A figure that a chapter can compute.
struct Figure {
  std::string name;       ///< of its files; a thesis figure begins with "fig", a claim with "claim"
  std::string section;    ///< of the thesis
  std::string title;      ///< one line
  std::string caption;    ///< what to look at, what agrees and what does not
  std::string film = {};  ///< what to look at in its film, if it has one
  Parameters parameters = {};      ///< what a reader can change with --set key=value
  std::vector<std::string> quick;  ///< what --quick sets first, each as key=value
  /// Computes everything; throws std::runtime_error if no such result exists.
  std::function<Result(const Parameters&)> experiment;
};

}  // namespace tumble::chapters
