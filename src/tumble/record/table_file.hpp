/// \file
/// \brief CSV files that are made of whole lines, whatever happens.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A file or folder could not be written: disk full, no permission. Commands exit with 4.
class CannotWrite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The folder, within that of an output, of files that are not published yet; see OutputFolder.
inline constexpr std::string_view kUnfinishedFolder = ".unfinished";

/// Writes a whole file at once, under another name first: if it cannot be written, the one of before is left. A link
/// is replaced, not followed.
/// \throws CannotWrite naming the path that it will have when it is published, and the reason
void write_file(const std::filesystem::path& path, std::string_view text);

/// A comma-separated table that grows by whole rows.
///
/// Rows are handed to the system in blocks. If that fails (disk full), the file is cut back to
/// the last whole block before the error is thrown, and nothing more is written to it: every later
/// flush throws again.
class TableFile {
 public:
  /// Creates the file with its first line.
  /// \param header  the names of the columns, with commas
  /// \throws CannotWrite naming the path and the reason
  TableFile(std::filesystem::path path, std::string_view header);
  /// Writes the rest; errors are not seen here, call flush() before.
  ~TableFile();
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;

  /// Adds a cell: the shortest digits that read back to the same bits.
  /// \param value a number; every NaN is `nan`, whatever its sign
  TableFile& cell(double value);
  /// Adds a cell.
  TableFile& cell(std::int64_t value);
  /// Adds a cell.
  /// \param value text; put in quotes where CSV asks for it
  TableFile& cell(std::string_view value);
  /// Adds three cells.
  TableFile& cell(const Vec3& value);
  /// Ends the row.
  /// \throws CannotWrite if a block of rows could not be written
  void end_row();
  /// Hands everything to the system.
  /// \throws CannotWrite if it could not be written
  void flush();

 private:
  void separate();

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  int failure_ = 0;             // errno of the first write that failed
  std::string pending_;         // whole rows not yet written, then the row being made
  std::size_t row_begin_ = 0;   // where in pending_ the row being made begins
  std::uintmax_t written_ = 0;  // bytes of whole rows in the file
};

/// A text as a cell: in quotes if it has commas, quotes or line breaks, its own quotes doubled.
std::string csv_cell(std::string_view text);

/// Takes a row of a comma-separated table apart.
/// \param line  without the line break
/// \return the cells, without the quotes that some are in
std::vector<std::string> cells_of(std::string_view line);

}  // namespace tumble
