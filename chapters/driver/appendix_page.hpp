/// \file
/// \brief The page that shows appendix A line by line beside the source.
#pragma once

#include "driver/appendix_a.hpp"
#include "driver/errata.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// Where Doxygen shows a line of a source file.
std::string source_link(const std::string& path, std::size_t line);

// Every line of the listings: what it says, the code as printed and as meant, why they differ.
//
// Other pages refer to it by `\ref appendix_a`, to a listing by `\ref appendix_a_collide`; a line is at
// `appendix_a.html#collide_14`.
std::string appendix_page(const std::vector<AppendixListing>& listings,
                          const std::vector<ErratumEntry>& errata);

}  // namespace tumble::chapters
