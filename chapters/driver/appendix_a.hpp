/// \file
/// \brief The listings of the thesis's appendix A beside the source lines that do them, and the page that shows them.
#pragma once

#include "driver/errata.hpp"
#include "driver/marks.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// Some lines of a source file.
struct SourceExcerpt {
  std::string path;                // the file
  std::size_t first = 0;           // number of the first of them, from 1
  std::vector<std::string> lines;  // their text, moved left by what the first one is indented by
  bool cut = false;                // whether more of them do the printed line than are given
};

// One numbered line of a listing.
struct AppendixLine {
  int number = 0;                   // from 1
  std::string says;                 // what it says, retold
  std::vector<std::string> errata;  // their ids
  std::string why;                  // why the code differs where no erratum says so; may be empty
  std::vector<SourceExcerpt> printed;  // what does it as printed; no lines: no statement of its own
  std::vector<SourceExcerpt> meant;    // what does it as meant; no lines: no statement of its own
  std::string place;                   // how messages about it begin
};

// One listing.
struct AppendixListing {
  std::string name;     // as in the marks: "COLLIDE"
  std::string section;  // of the thesis
  std::string chapter;  // the folder of the chapter that describes it
  std::string about;    // what it does, in a sentence
  std::string mends;    // what the source as printed mends though it is no erratum; may be empty
  std::vector<AppendixLine> lines;  // all of them, from 1
};

// Every C++ source of a folder and of those in it, in the order of their paths.
std::vector<std::filesystem::path> sources_in(const std::filesystem::path& folder);

// Reads the listings and finds the code of each of their lines.
//
// The file has a table `[[listing]]` for each, with the keys `id` (its name), `section`, `chapter`,
// `about` and, where it mends something silently, `mends`, and a table `[[line]]` for each numbered line, with `id` ("COLLIDE 3"), `says` and, where
// needed, `errata` (ids with blanks between), `why`, `printed` and `meant`. The last two show which of
// the lines between the marks are meant: a piece of each, one below the other; the statement that
// begins there is taken. Without them it is all that stands between the marks; "-" says that nothing
// there does this line alone.
std::vector<AppendixListing> read_appendix(const std::filesystem::path& path,
                                           const std::vector<std::filesystem::path>& sources);

// Where Doxygen shows a line of a source file.
std::string source_link(const std::string& path, std::size_t line);

// Every line of the listings: what it says, the code as printed and as meant, why they differ.
//
// Other pages refer to it by `\ref appendix_a`, to a listing by `\ref appendix_a_collide`; a line is at
// `appendix_a.html#collide_14`.
std::string appendix_page(const std::vector<AppendixListing>& listings,
                          const std::vector<ErratumEntry>& errata);

}  // namespace tumble::chapters
