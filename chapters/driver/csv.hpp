/// \file
/// \brief Tables of numbers as files, written and read.
#pragma once

#include "driver/figure.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::chapters {

// A file could not be read or written; commands answer with exit code 4.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A number as printf writes it.
std::string formatted(const char* format, double value);

// The shortest digits of a number that read back to the same bits; nothing for NaN.
std::string full_text(double value);

// A number for reading, with at most 10 significant digits.
std::string short_text(double value);

// Reads a number.
double read_number(const std::string& text);

// Writes a file whole or not at all: under another name first, then renamed.
void write_file(const std::filesystem::path& path, const std::string& text);

// Reads a whole file.
std::string read_file(const std::filesystem::path& path);

// Splits a CSV file into cells. Lines that begin with # and empty lines are left out; a cell
// with commas stands in double quotes.
std::vector<std::vector<std::string>> split_csv(const std::string& text);

// A table as CSV.
std::string csv_of(const std::string& head, const Table& table);

}  // namespace tumble::chapters
