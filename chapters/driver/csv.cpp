/// \file
/// \brief Tables of numbers as files, written and read.
#include "driver/csv.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/record/table_file.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

namespace tumble::chapters {

std::string formatted(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string full_text(double value) { return std::isnan(value) ? "" : shortest_text(value); }

std::string short_text(double value) { return formatted("%.10g", value); }

double read_number(const std::string& text) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole_text = end != text.c_str() && *end == '\0';
  return whole_text && std::isfinite(value) ? value : nan;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code ignored;  // what cannot be made cannot be written into
  std::filesystem::create_directories(path.parent_path(), ignored);
  try {
    tumble::write_file(path, text);
  } catch (const CannotWrite& error) {
    throw FileError(error.what());
  }
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw FileError("cannot read " + path.string());
  return text.str();
}

std::vector<std::vector<std::string>> split_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    lines.push_back(cells_of(line));
  }
  return lines;
}

std::string csv_of(const std::string& head, const Table& table) {
  std::string text = head;
  std::string names;
  for (const Column& column : table.columns) {
    text += "# column: " + column.name + " [" + column.unit + "] " + column.meaning + '\n';
    if (!names.empty()) names += ',';
    names += column.name;
  }
  text += names + '\n';
  for (const std::vector<double>& row : table.rows) {
    if (row.size() != table.columns.size()) throw std::logic_error("a row of another length");
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      text += full_text(row[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace tumble::chapters
