/// \file
/// \brief Tables of numbers as files, written and read.
#pragma once

#include "driver/figure.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::chapters {

/// A file could not be read or written; commands answer with exit code 4.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number as printf writes it.
/// \param format  of one double, for example "%.4g"
/// \param value   any number
/// \return at most 39 characters
std::string formatted(const char* format, double value);

/// A number with 17 significant digits: it reads back to the same bits.
/// \param value any number; NaN gives an empty cell
/// \return for example `0.10000000000000001`
std::string full_text(double value);

/// A number for reading, with at most 10 significant digits.
/// \param value any number
/// \return for example `0.1`
std::string short_text(double value);

/// Reads a number.
/// \param text a decimal number and nothing else
/// \return the number; NaN if it is none or not finite
double read_number(const std::string& text);

/// Writes a file whole or not at all: under another name first, then renamed.
/// \param path  where
/// \param text  all its bytes
/// \throws FileError naming the path
void write_file(const std::filesystem::path& path, const std::string& text);

/// Reads a whole file.
/// \param path which
/// \return all its bytes
/// \throws FileError naming the path
std::string read_file(const std::filesystem::path& path);

/// Splits a CSV file into cells. Lines that begin with # and empty lines are left out; a cell
/// with commas stands in double quotes.
/// \param text the bytes of the file
/// \return one vector of cells for each line, the header line first
std::vector<std::vector<std::string>> split_csv(const std::string& text);

/// A table as CSV.
/// \param head   comment lines that come first, each beginning with "# "
/// \param table  the numbers
/// \return the bytes of the file: head, a comment line for each column, names, rows
std::string csv_of(const std::string& head, const Table& table);

}  // namespace tumble::chapters
