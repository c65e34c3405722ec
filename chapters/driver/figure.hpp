/// \file
/// \brief A figure before it is drawn: parameters in, tables and numbers out.
#pragma once

#include "tumble/base/parameters.hpp"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The programs that compute the figures, and the page that shows them.
//
// A figure is declared where it is measured, and its title and caption stand in the chapter's
// `figures.toml`. The driver gives the figures of a chapter a command line and writes their numbers
// into files; gnuplot draws from those. Nothing that a reader sees on a picture was typed by hand.
namespace tumble::chapters {

using namespace declare;

// One column of a table.
struct Column {
  std::string name;     // with its unit as suffix, for example "time_s"
  std::string unit;     // "s"; "-" for a ratio or a count
  std::string meaning;  // one line
};

// Rows of numbers: one CSV file. NaN is an empty cell.
struct Table {
  std::string suffix;                          // file is `figure.csv`, or `figure_suffix.csv`
  std::vector<Column> columns;                 // the meaning of each number of a row
  std::vector<std::vector<double>> rows = {};  // each as long as `columns`

  // Adds a row.
  template <class... Values>
  void add(const Values&... values) {
    std::vector<double> row;
    (append(row, values), ...);
    if (row.size() != columns.size())
      throw std::logic_error("table '" + suffix + "': a row of " + std::to_string(row.size()) +
                             " numbers for " + std::to_string(columns.size()) + " columns");
    rows.push_back(std::move(row));
  }

 private:
  template <class Value>
  static void append(std::vector<double>& row, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
      row.push_back(static_cast<double>(value));
    } else {
      for (const auto one : value) row.push_back(static_cast<double>(one));
    }
  }
};

// A number that the figure is about, compared with `expected.csv` after drawing.
struct Quantity {
  std::string name;                                        // in words, unique within the figure
  std::string unit;                                        // "-" for a ratio or a count
  double value = 0.0;                                      // as computed in this run
  double low = std::numeric_limits<double>::quiet_NaN();   // lower end of the interval over seeds
  double high = std::numeric_limits<double>::quiet_NaN();  // upper end of the interval over seeds
  int seeds = 0;  // random scenes that it was measured over; 0: nothing is random

  Quantity() = default;  // without a name

  // A number of any type.
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  Quantity(std::string its_name, std::string its_unit, Number number,
           double its_low = std::numeric_limits<double>::quiet_NaN(),
           double its_high = std::numeric_limits<double>::quiet_NaN(), int its_seeds = 0)
      : name(std::move(its_name)),
        unit(std::move(its_unit)),
        value(static_cast<double>(number)),
        low(its_low),
        high(its_high),
        seeds(its_seeds) {}
};

// Commands of gnuplot that were computed, such as boxes in three dimensions: a script loads them.
struct Drawing {
  std::string suffix;    // file is `figure_suffix.gp`
  std::string commands;  // its bytes
};

// All that one run of a figure computed.
struct Result {
  std::vector<Table> tables;           // what gnuplot draws from
  std::vector<Quantity> quantities;    // to be checked
  std::vector<Drawing> drawings = {};  // what gnuplot is to draw as it is
  // Paints the film of the figure, the bytes of a GIF; empty: it has none. Apart from the rest, since it takes seconds.
  std::function<std::string()> film = {};

  // Adds a number.
  template <class... Parts>
  void add(Parts&&... parts) {
    quantities.push_back(Quantity(std::forward<Parts>(parts)...));
  }
};

// A figure that a chapter can compute.
struct Figure {
  std::string name;  // of its files; a thesis figure begins with "fig", a claim with "claim"
  Parameters parameters = {};           // settings that a reader can change with --set key=value
  std::vector<std::string> quick = {};  // what --quick sets first, each as key=value
  // Computes everything; throws std::runtime_error if no such result exists.
  std::function<Result(const Parameters&)> experiment = {};

  // From figures.toml; see with_texts().
  std::string section = {};  // of the thesis
  std::string title = {};    // one line
  std::string caption = {};  // what to look at, what agrees and what does not
  std::string film = {};     // what to look at in its film, if it has one
};

}  // namespace tumble::chapters
