/// \file
/// \brief Matrices as text files that other programs read and write too: Matrix Market.
#pragma once

#include "tumble/math/dense.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace tumble {

/// The most rows or columns of a matrix that is read. Reason: all of it is held, 200 MB.
inline constexpr int kMostMatrixRows = 5000;

/// Reads a matrix from the text of a Matrix Market file.
///
/// The first line is `%%MatrixMarket matrix FORM NUMBERS SYMMETRY`: array or coordinate, real (or
/// double) or integer, general or symmetric. Then come the sizes and the entries, one in each line:
/// `array` has all of them column by column, `coordinate` those that are not 0, as row, column (from
/// 1) and value. Of a symmetric matrix only entries on and below the diagonal are given. Lines that
/// begin with % and empty ones are skipped.
/// \param file  its name, for messages
/// \throws std::invalid_argument as `file:line: mistake: expected form`: another form, a line
///         that cannot be read, a number that is not finite, an integer beyond 2^53, an entry out of
///         range or given twice, too few or too many entries, more than kMostMatrixRows rows or columns
/// \see Boisvert, Pozo, Remington, "The Matrix Market exchange formats: initial design", NIST report
///      5935, 1996.
MatX parse_matrix_market(std::string_view text, std::string_view file);

/// Reads a Matrix Market file.
/// \param path where, at most 256 MiB; a pipe will do
/// \throws std::invalid_argument as parse_matrix_market(), or if the file cannot be read
MatX read_matrix_market(const std::filesystem::path& path);

/// Writes a matrix as the text of a Matrix Market file: array, real, general.
/// \param comment  one line about it, or none
/// \return the text; its numbers read back to the same bits
/// \throws std::invalid_argument for an entry that is not finite, or a comment of several lines
std::string to_matrix_market(const MatRef& matrix, std::string_view comment = {});

}  // namespace tumble
