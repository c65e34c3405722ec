/// \file
/// \brief The thesis's table of contents, and where each section is in this book.
#pragma once

#include "driver/findings.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// A section of the thesis, as `thesis_map.toml` describes it.
struct ThesisSection {
  std::string id;                    // "3.2", "A.1"
  std::string title;                 // what it is called there
  std::string state;                 // "here", "not yet" or "out of scope"
  std::string about;                 // what this book has of it
  std::string because;               // why it is out of scope
  std::vector<std::string> pages;    // labels of the pages and sections that treat it
  std::vector<std::string> figures;  // names of the figures that have a number in the thesis
  std::string place;                 // how messages about it begin
};

// Reads the map.
std::vector<ThesisSection> read_thesis_map(const std::filesystem::path& path);

// The map as a page: each section beside its pages, figures, claims and tests.
//
// Other pages refer to it by `\ref thesis_map`, to a section by `\ref map_3_2 "3.2"`.
std::string thesis_map_page(const std::vector<ThesisSection>& sections, const Findings& findings);

}  // namespace tumble::chapters
