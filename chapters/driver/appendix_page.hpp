/// \file
/// \brief The page that shows appendix A line by line beside the source.
#pragma once

#include "driver/appendix_a.hpp"
#include "driver/errata.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// Where Doxygen shows a line of a source file.
/// \param path  the file; no other one that Doxygen reads may have its name
/// \param line  the line, from 1
/// \return for example "collide_8cpp_source.html#l00034"
std::string source_link(const std::string& path, std::size_t line);

/// Every line of the listings: what it says, the code as printed and as meant, why they differ.
///
/// Other pages refer to it by `\ref appendix_a`, to a listing by `\ref appendix_a_collide`; a line is at
/// `appendix_a.html#collide_14`.
/// \param listings  from read_appendix()
/// \param errata    from find_errata()
/// \return the bytes of `appendix_a.md`
/// \throws std::invalid_argument naming the line, for an erratum that does not exist
std::string appendix_page(const std::vector<AppendixListing>& listings,
                          const std::vector<ErratumEntry>& errata);

}  // namespace tumble::chapters
