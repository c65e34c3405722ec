/// \file
/// \brief Title and caption of each figure, as the chapter's figures.toml has them.
#pragma once

#include "driver/figure.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

// The words about a figure, each text in one line.
//
// A computed number in a caption may be followed by a comment that says from where, as on a page: see
// read_findings().
struct FigureText {
  std::string name;     // of the figure: key `id`
  std::string section;  // of the thesis
  std::string title;    // one line
  std::string caption;  // what to look at, what agrees and what does not; with comments
  std::string film;     // what to look at in its film; empty if it has none
};

// Reads a chapter's `figures.toml`: tables `[[figure]]` with `id`, `section`, `title`, `caption` and perhaps
// `film`, in the order of the page. A line break in a text counts as a blank.
std::vector<FigureText> read_figure_texts(const std::filesystem::path& path);

// Puts figures and their texts together.
std::vector<Figure> with_texts(std::vector<Figure> figures, const std::vector<FigureText>& texts);

}  // namespace tumble::chapters
