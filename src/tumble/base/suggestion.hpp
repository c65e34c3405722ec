/// \file
/// \brief Words of others in messages: mistyped names and their closest known one, and foreign texts.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tumble {

/// The known name that is closest to a mistyped one.
///
/// Closeness is the number of letters to be inserted, left out, replaced or swapped with the next one.
/// \return the closest; the earliest of several. If none is within a third of the word's letters (one letter at least),
///         the one that begins most like the word, within a quarter of its letters, of which there are at least four;
///         else empty
/// \see Damerau, "A technique for computer detection and correction of spelling errors", 1964
std::string_view closest_name(std::string_view word, std::span<const std::string_view> known);

/// The end of a message about an unknown name.
/// \return for example "did you mean gravity? Expected one of: title, gravity, ground, box"
std::string expected_names(std::string_view word, std::span<const std::string_view> known);

/// A foreign text for a message: nothing in it reaches a terminal as a command.
/// \param text  any bytes
/// \param most  [bytes] of the text
/// \return one line without control characters, and three dots if the text was longer
std::string one_line(std::string_view text, std::size_t most = 60);

}  // namespace tumble
