/// \file
/// \brief The closest known name to a mistyped one.
#pragma once

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

}  // namespace tumble
