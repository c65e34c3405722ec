/// \file
/// \brief A film of the column of figure 6.1: bodies moved along straight lines, and along arcs.
#pragma once

#include "tumble/base/parameters.hpp"

#include <string>

namespace tumble::chapters {

/// Two falls of the column under forward Euler with long steps, so that what goes wrong can be seen: on the
/// left centres and orientations are moved apart, on the right each body by the exponential of its twist.
/// \param settings  boxes, angle
/// \return the bytes of a GIF: a frame for each step, four times slowed down
std::string column_film(const Parameters& settings);

}  // namespace tumble::chapters
