/// \file
/// \brief Whether the numbers in a chapter's text are still those that were computed.
#pragma once

#include "driver/check.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// Compares the numbers in a page or in captions with those of the figures.
//
// A number that was computed is followed by a comment that says from where:
// `15.3 <!-- cradle: quantity in words -->`, or `15.3 per cent <!-- ... -->` or `15.3 % <!-- ... -->`
// for a share. It must be the
// computed one, rounded to the digits that are written. Figures that were drawn with other
// settings are not compared.
std::vector<std::string> stale_numbers(const std::string& page, const std::string& name,
                                       const std::vector<DrawnFigure>& figures);

}  // namespace tumble::chapters
