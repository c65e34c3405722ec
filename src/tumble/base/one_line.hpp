/// \file
/// \brief Texts of others in messages.
#pragma once

#include <string>
#include <string_view>

namespace tumble {

/// A foreign text for a message: nothing in it reaches a terminal as a command.
/// \param text  any bytes
/// \return one line of at most 60 bytes without control characters, and three dots if it was longer
std::string one_line(std::string_view text);

}  // namespace tumble
