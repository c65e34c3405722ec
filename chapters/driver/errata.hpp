/// \file
/// \brief The errata: where the thesis's text fails, and the numbers that show it.
#pragma once

#include "driver/check.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// One erratum, as a chapter's `errata.toml` describes it.
struct Erratum {
  std::string id;       // short name, as `repaired=` takes it where a technique can read as printed
  std::string title;    // what goes wrong, in some words
  std::string section;  // of the thesis
  std::string chapter;  // the folder of the chapter
  std::string
      kind;  // "misprint": contradicts the thesis itself; "choice": meant, or left open; "wording"
  std::string printed;  // what the thesis says, retold
  std::string reading;  // what we do instead
  std::string scene;    // where it shows
  std::string figure;   // the figure that computes both numbers
  std::string failure;  // the number with the erratum in place, one of the figure's
  std::string mended;   // the same number under our reading
  std::string test;     // the test that holds them
  std::string command;  // shows it
  std::string place;    // how messages about it begin
};

// Reads a chapter's errata.
std::vector<Erratum> read_errata(const std::filesystem::path& path);

// An erratum with its numbers; a value is NaN if it is not measured.
struct ErratumEntry {
  Erratum erratum;        // the mistake
  CheckedNumber failure;  // the number with the erratum in place
  CheckedNumber mended;   // the number under our reading
};

// Finds the two numbers of each erratum.
std::vector<ErratumEntry> find_errata(const std::vector<Erratum>& errata,
                                      const std::vector<DrawnFigure>& figures);

}  // namespace tumble::chapters
