/// \file
/// \brief The page that shows all figures.
#pragma once

#include "driver/findings.hpp"

#include <string>

namespace tumble::chapters {

// All figures on one page: picture, caption, claim with its rule and verdict, numbers, how to draw
// it again with which parameters. The pictures of the gallery come last, as thumbnails.
//
// One file without scripts and without anything from elsewhere; it reads on a phone and in the
// dark. Equal figures give equal bytes.
std::string index_page(const Findings& findings);

}  // namespace tumble::chapters
