/// \file
/// \brief The page that shows all figures.
#pragma once

#include "driver/check.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// All figures on one page: picture, caption, how to draw it again, parameters, numbers.
///
/// One file without scripts and without anything from elsewhere; it reads on a phone and in the
/// dark. Equal figures give equal bytes.
/// \param figures from check_figures()
/// \return the bytes of `index.html`, which lies beside the pictures
std::string index_page(const std::vector<DrawnFigure>& figures);

}  // namespace tumble::chapters
