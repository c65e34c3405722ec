/// \file
/// \brief Cells of comma-separated tables, as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A text as a cell: in quotes if it has commas, quotes or line breaks, its own quotes doubled.
std::string csv_cell(std::string_view text);

/// Takes a row of a comma-separated table apart.
/// \param line  without the line break
/// \return the cells, without the quotes that some are in
std::vector<std::string> cells_of(std::string_view line);

}  // namespace tumble
