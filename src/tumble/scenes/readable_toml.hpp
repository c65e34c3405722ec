/// \file
/// \brief A check of a TOML text before it is parsed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tumble {

/// The message about a text that is not TOML.
/// \param line  from 1
std::string not_toml(std::string_view file, std::size_t line, const std::string& why);

/// Refuses texts that the TOML library does not survive: keys of more than 64 dots, whose tables it walks through by
/// recursion, and letters that are not ASCII where it makes wrong assumptions about them: outside of quotes and
/// comments, and after a backslash, where it looks for blanks. It takes quotes in what begins like a number for a part
/// of the number, so these are refused, too. All other mistakes are left to the library. A string without an end lasts to
/// the end of its line or of the text.
/// \throws std::invalid_argument with file, line and reason
/// \par Cost
/// One pass over the text.
void require_readable(std::string_view text, std::string_view file);

}  // namespace tumble
